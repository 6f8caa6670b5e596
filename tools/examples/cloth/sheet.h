// A sheet of cloth of point masses and springs, and the search of a linear solve over it.
#include <physgen/schema.h>
namespace sheet {
using namespace physgen::schema;
struct PHYSGEN_OBJECT(layout(host, aos_padded)) Node {
  PHYSGEN(unit("m")) Vector<3> x;    ///< position
  PHYSGEN(unit("m/s")) Vector<3> v;  ///< velocity
  PHYSGEN(unit("kg")) Scalar m;      ///< mass
  Scalar free;                       ///< 1, or 0 where it is pinned
};
/// The vectors of conjugate gradients at one node.
struct PHYSGEN_OBJECT(layout(host, aos_padded)) Search {
  PHYSGEN(unit("m/s")) Vector<3> dv;  ///< the solution: the change of v in a time step
  PHYSGEN(unit("N s")) Vector<3> r;   ///< residual
  PHYSGEN(unit("m/s")) Vector<3> p;   ///< direction
  PHYSGEN(unit("N s")) Vector<3> q;   ///< matrix times direction
};
struct PHYSGEN_OBJECT(layout(host, aos)) Spring {
  Vector<2, Index> ends;
  PHYSGEN(unit("m")) Scalar length;  ///< at rest
  PHYSGEN(unit("N/m")) Scalar stiffness;
  PHYSGEN(unit("N")) Vector<3> f;       ///< on the first end; the second is pulled the other way
  PHYSGEN(unit("N/m")) Symmetric<3> J;  ///< -df/dx of the first end, positive semidefinite
};
struct PHYSGEN_OBJECT() Range {
  Index begin, end;
};
struct PHYSGEN_OBJECT() Touch {
  Index spring;  ///< that has its end at the node
};
}  // namespace sheet
