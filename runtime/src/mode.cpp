// The constant that all objects of this library's mode refer to, so that objects of the other mode do not link with it.
#include <physgen/config.h>

namespace physgen {
extern "C" {
#ifdef PHYSGEN_CHECKED
const char physgen_objects_were_compiled_with_PHYSGEN_CHECKED = 0;
#else
const char physgen_objects_were_compiled_without_PHYSGEN_CHECKED = 0;
#endif
}
}  // namespace physgen
