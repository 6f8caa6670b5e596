// A time step of backward Euler as a program over an executor and arrays by name: the equilibrium of elastic forces,
// loads and inertia.
#pragma once

#include <fem/solver/loads/time_step.h>
#include <fem/solver/newton/newton.h>

namespace physgen::fem {

/// The largest coordinate of a node [m].
template <class PositionView>
struct LargestCoordinate {
  using Scalar = double;
  PositionView positions;  ///< elasticity::NodePosition
  PHYSGEN_FUNCTION double operator()(SingleObject auto node) const {
    const Vector3<double> x = positions[node].x();
    return max(abs(x[0]), max(abs(x[1]), abs(x[2])));
  }
};

template <class MotionView>
struct StoreFarthest {
  MotionView motion;  ///< dynamics::Motion
  PHYSGEN_FUNCTION void operator()(double farthest) const { motion[index_t{0}].farthest() = farthest; }
};

/// The largest coordinate of a node's position [m]. @pre the level has inertia
template <class On, class Arrays, class Level>
[[nodiscard]] double largest_coordinate(On& on, const Arrays& a, Level& level) {
  auto& measured = level.inertia->measured;
  on.reduce(a.nodes(), LargestCoordinate{a.positions.const_view()}, Max{}, StoreFarthest{measured.view()});
  return on.value(measured).farthest;
}

/// The sums over the nodes' velocities: momentum and kinetic energy. @pre the level has inertia
template <class On, class Arrays, class Level>
[[nodiscard]] auto measure_motion(On& on, const Arrays& a, Level& level) {
  auto& inertia = *level.inertia;
  on.reduce(a.nodes(), NodeMotion{inertia.masses.const_view(), inertia.velocities.const_view()}, Sum{},
            StoreMotion{inertia.measured.view()});
  return on.value(inertia.measured);
}

/// From a.positions and the velocities of levels[0]->inertia to those at the end of the step. Newton's method begins
/// where inertia leads; where a tet would be flat there, at the positions before. When it does not converge, positions
/// and velocities are as before.
/// @param levels finest first, each mesh with inertia
/// @param evaluator an Evaluator of these arrays, or MaterialSteps
/// @param moves whether prescribed components or planes are not yet where the load takes them
template <class On, class Arrays, class Levels, class Vectors, class Evaluate>
NewtonResult implicit_step(On& on, typename On::Loop& loop, Arrays& a, Levels& levels, Vectors& v, Evaluate& evaluator,
                           const NewtonSettings& settings, const TimeStep& step, bool moves) {
  const index_t n = a.nodes();
  auto& level = *levels[0];
  auto& inertia = *level.inertia;
  const auto constraints = level.constraints.const_view();
  const auto positions = a.positions.view();
  for (auto& each : levels) {
    if (each->inertia != nullptr) each->inertia->per_mass = (1 / step.length + step.damping) / step.length;
  }
  on.run(n, KeepPositions{a.positions.const_view(), a.kept.view()});
  on.run(n, PredictPositions{step.length, step.damping, a.kept.const_view(), inertia.velocities.const_view(),
                             constraints, inertia.centres.view(), positions});
  on.reduce(a.tet_count(), VolumeRatio{a.tets.const_view(), a.rest.const_view(), a.positions.const_view()}, Min{},
            StoreSmallestRatio{a.state.view()});
  if (!(on.value(a.state).smallest_ratio > 0)) on.run(n, KeepPositions{a.kept.const_view(), positions});
  if (moves) {
    on.run(n, ComputeIncrement{step.load, a.rest.const_view(), a.motion.const_view(), constraints,
                               a.positions.const_view(), a.increment.view()});
  }
  const NewtonResult result =
      find_equilibrium(on, loop, a, levels, 0, v, evaluator, settings, step.load, moves, true, {});
  if (result.status == NewtonStatus::converged) {
    on.run(n, UpdateVelocities{step.length, a.positions.const_view(), a.kept.const_view(), inertia.velocities.view()});
  } else {
    on.run(n, KeepPositions{a.kept.const_view(), positions});
  }
  for (auto& each : levels) {
    if (each->inertia != nullptr) each->inertia->per_mass = 0;
  }
  return result;
}

}  // namespace physgen::fem
