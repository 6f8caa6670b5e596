// Bodies that the sun attracts, and that do not attract each other.
#include <physgen/schema.h>
namespace model {
using namespace physgen::schema;
/// A body on its way round the sun, which stands at 0.
struct PHYSGEN_OBJECT(layout(host, soa)) Body {
  PHYSGEN(unit("au")) Vector<3> x;       ///< position
  PHYSGEN(unit("au/year")) Vector<3> v;  ///< velocity
};
}  // namespace model
