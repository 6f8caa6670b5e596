// Object types of contact: the planes that a body may touch, what its nodes carry of its surface, and its pressed
// faces.
#pragma once

#include <physgen/schema.h>

namespace contact {
using namespace physgen::schema;

/// The part of the body's surface that a node carries: a third of each boundary face that it is a corner of.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) NodeArea {
  PHYSGEN(unit("m^2")) Scalar area;  ///< at rest; 0 inside the body
};

/// A plane that the body's surface cannot pass without force: the points x with normal . x = offset + load travel.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) RigidPlane {
  PHYSGEN(unit("1")) Vector<3> normal;  ///< of length 1, towards the body
  PHYSGEN(unit("m")) Scalar offset;     ///< normal . x of its points at a load of 0
  PHYSGEN(unit("m")) Scalar travel;     ///< along the normal, at a load of 1
};

/// A face of the surface that is pushed by a pressure, which follows it.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) PressedFace {
  Vector<3, Index> nodes;               ///< counter-clockwise, seen from outside
  PHYSGEN(unit("Pa")) Scalar pressure;  ///< at a load of 1
};

/// How a plane and the body touch; one object, which kernels leave for the host.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) PlaneContact {
  PHYSGEN(unit("N")) Scalar force;  ///< on the body along the normal
  PHYSGEN(unit("m")) Scalar depth;  ///< of the node that is farthest behind it among those that it touches
};

}  // namespace contact
