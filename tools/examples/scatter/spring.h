// What the kernel wants of a spring, and what it gives.
#include <physgen/schema.h>

namespace model {
using namespace physgen::schema;

/// A spring between two points that moves, with the force that it exerts.
struct PHYSGEN_OBJECT(layout(host, aosoa(16)), layout(cuda, aosoa(32))) Spring {
  PHYSGEN(unit("m")) Vector<3> edge;  ///< from the first end to the second
  PHYSGEN(unit("m")) Scalar length;   ///< at rest
  PHYSGEN(unit("N/m")) Scalar stiffness;
  PHYSGEN(unit("N")) Vector<3> f;  ///< on the first end
  PHYSGEN(unit("J")) Scalar energy;
};
}  // namespace model
