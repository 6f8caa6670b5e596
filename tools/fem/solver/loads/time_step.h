// A step in time, and what the nodes' velocities amount to.
#pragma once

#include <fem/numerics/scalar.h>
#include <physgen/kernel.h>

namespace physgen::fem {

struct TimeStep {
  double length;   ///< [s]
  double load;     ///< at its end: what prescribed motion and external forces are multiplied by
  double damping;  ///< in proportion to mass [1/s]: the force -damping m v
};

/// Kinetic energy and momentum of a node.
template <class MassView, class VelocityView>
struct NodeMotion {
  using Scalar = double;
  MassView masses;          ///< dynamics::NodeMass
  VelocityView velocities;  ///< dynamics::NodeVelocity

  PHYSGEN_FUNCTION Eigen::Matrix<double, 4, 1> operator()(SingleObject auto node) const {
    const double mass = masses[node].mass();
    const Vector3<double> v = velocities[node].v();
    return {0.5 * mass * dot3<double>(v, v), mass * v[0], mass * v[1], mass * v[2]};
  }
};

template <class MotionView>
struct StoreMotion {
  MotionView motion;  ///< dynamics::Motion
  PHYSGEN_FUNCTION void operator()(const Eigen::Matrix<double, 4, 1>& sums) const {
    const auto m = motion[index_t{0}];
    m.kinetic() = sums[0];
    m.momentum() = Vector3<double>(sums[1], sums[2], sums[3]);
  }
};

}  // namespace physgen::fem
