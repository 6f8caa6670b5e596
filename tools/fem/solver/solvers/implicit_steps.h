// Time steps of backward Euler: what a solver of motion does, over parts of any types.
#pragma once

#include <fem/solver/dynamic_solver.h>
#include <fem/solver/newton/implicit_step.h>
#include <fem/solver/solvers/require.h>
#include <fem/solver/solvers/solver_parts.h>

#include <cstddef>

namespace physgen::fem {

/// What the host knows of a body that moves.
struct MovingBody {
  double damping = 0;       ///< [1/s]
  double stiffness = 0;     ///< of a node, elastic and of planes [N/m]
  double largest_mass = 0;  ///< of a node [kg]
  std::size_t nodes = 0;    ///< of all of it
};

template <class On, class Types>
class ImplicitSteps : protected SolverParts<On, Types> {
  using Parts = SolverParts<On, Types>;

 protected:
  using Parts::all_prescribed_;
  using Parts::arrays_;
  using Parts::evaluator_;
  using Parts::linear_;
  using Parts::loops_;
  using Parts::moves_;
  using Parts::on_;
  using Parts::Parts;
  using Parts::settings_;
  using Parts::vectors_;

  /// A time step of a length [s] to a load. Without an equilibrium the state is as before. @pre there is inertia
  NewtonResult step(double length, double load) {
    require_step(length, load);
    NewtonSettings newton = settings_.newton;
    newton.start_load = load_;
    newton.last_reaction = last_reaction_;
    const double inertial = body_.largest_mass * (1 / length + body_.damping) / length;
    newton.rounding_force = rounding_force(body_.stiffness + inertial,
                                           largest_coordinate(*on_, *arrays_.front(), *linear_.front()), body_.nodes);
    newton.all_prescribed = all_prescribed_.front();
    const bool moves = moves_.front() && (is_moved_ || load != load_);
    const NewtonResult result = implicit_step(*on_, loops_.front(), *arrays_.front(), linear_, *vectors_.front(),
                                              *evaluator_, newton, {length, load, body_.damping}, moves);
    if (result.status != NewtonStatus::converged) return result;
    time_ += length;
    load_ = load;
    is_moved_ = false;
    last_reaction_ = result.reaction;
    return result;
  }
  [[nodiscard]] MotionMeasure measure() {
    const auto found = measure_motion(*on_, *arrays_.front(), *linear_.front());
    const auto state = Parts::evaluate_now(0, load_);
    return {found.kinetic, state.elastic + state.volumetric, {found.momentum[0], found.momentum[1], found.momentum[2]}};
  }

  MovingBody body_;
  bool is_moved_ = false;     ///< whether positions were set from outside, or planes may push at rest
  double last_reaction_ = 0;  ///< [N]
  double time_ = 0, load_ = 0;
};

}  // namespace physgen::fem
