// Smoothed particles, and a row of neighbours for each.
#include <physgen/schema.h>
namespace fluid {
using namespace physgen::schema;
struct PHYSGEN_OBJECT(layout(host, aos_padded)) Particle {
  PHYSGEN(unit("m")) Vector<3> x;      ///< position
  PHYSGEN(unit("m/s")) Vector<3> v;    ///< velocity
  PHYSGEN(unit("N/m^3")) Vector<3> f;  ///< force per volume
  PHYSGEN(unit("kg/m^3")) Scalar rho;  ///< density
  PHYSGEN(unit("Pa")) Scalar p;        ///< pressure
};
struct PHYSGEN_OBJECT() Range {
  Index begin, end;
};
struct PHYSGEN_OBJECT() Neighbour {
  Index j;  ///< a particle within reach, or the particle itself
};
}  // namespace fluid
