// Objects of the kernels on which the choice of lanes is measured: particles, cloth, hexahedra.
#include <physgen/schema.h>

namespace lane_objects {
using namespace physgen::schema;

/// A smoothed particle.
struct PHYSGEN_OBJECT(layout(host, aos_padded), layout(cuda, aos_padded)) Particle {
  PHYSGEN(unit("m")) Vector<3> x;
  PHYSGEN(unit("m/s")) Vector<3> v;
  PHYSGEN(unit("kg")) Scalar m;
  PHYSGEN(unit("kg/m^3")) Scalar rho;
  PHYSGEN(unit("Pa")) Scalar p;
  PHYSGEN(unit("N/m^3")) Vector<3> f;
};

/// A node of a cloth.
struct PHYSGEN_OBJECT(layout(host, aos_padded), layout(cuda, aos_padded)) ClothNode {
  PHYSGEN(unit("m")) Vector<3> x;
  PHYSGEN(unit("m/s")) Vector<3> v;
  PHYSGEN(unit("N")) Vector<3> f;
};

/// What a solver iterates on.
struct PHYSGEN_OBJECT(layout(host, aos_padded), layout(cuda, aos_padded)) Direction {
  Vector<3> p, q;
};

/// A spring with its Jacobian: 13 numbers.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) Spring {
  PHYSGEN(unit("N/m")) Symmetric<3> J;
  PHYSGEN(unit("m")) Scalar length;
  PHYSGEN(unit("N/m")) Scalar stiffness;
  PHYSGEN(unit("N s/m")) Scalar damping;
  PHYSGEN(unit("m")) Vector<2> sheet;
  Vector<2, Index> ends;
};

/// Eight corners.
struct PHYSGEN_OBJECT() Hexahedron {
  Vector<8, Index> nodes;
  PHYSGEN(unit("m^3")) Scalar volume;
};

/// The force of a hexahedron on one of its corners.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) CornerForce {
  PHYSGEN(unit("N")) Vector<3> f;
};

/// A cell of a grid.
struct PHYSGEN_OBJECT() Cell {
  Scalar u, next;
};

/// A row: which entries an object has.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) Range {
  Index begin, end;
};
/// An entry: another object.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) Entry {
  Index other;
};
/// An entry of a sparse matrix.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) Coefficient {
  Index column;
  Scalar value;
};

}  // namespace lane_objects
