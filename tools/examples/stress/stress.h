#include <physgen/schema.h>
namespace model {
using namespace physgen::schema;
struct PHYSGEN_OBJECT(layout(host, aosoa(16)), layout(cuda, aosoa(32))) Stress {
  PHYSGEN(unit("Pa")) Symmetric<3> sigma;
  PHYSGEN(unit("Pa")) Scalar pressure;
};
}  // namespace model
