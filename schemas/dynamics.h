// Object types of bodies that move: what their nodes carry beside positions and forces, and what a state of motion
// amounts to.
#pragma once

#include <physgen/schema.h>

namespace dynamics {
using namespace physgen::schema;

/// Lumped mass of a node: a quarter of the mass of each of its tets.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) NodeMass {
  PHYSGEN(unit("kg")) Scalar mass;  ///< 0 of a node that is in no tet
};

/// Velocity of a node.
struct PHYSGEN_OBJECT(layout(host, aos_padded), layout(cuda, aos_padded)) NodeVelocity {
  PHYSGEN(unit("m/s")) Vector<3> v;  ///< velocity
};

/// The sums of the nodes' velocities; one object, which kernels leave for the host.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) Motion {
  PHYSGEN(unit("J")) Scalar kinetic;           ///< kinetic energy
  PHYSGEN(unit("kg m/s")) Vector<3> momentum;  ///< linear momentum
  PHYSGEN(unit("J")) Scalar elastic;           ///< elastic energy of the tets
  PHYSGEN(unit("m")) Scalar farthest;          ///< the largest coordinate of a position
};

}  // namespace dynamics
