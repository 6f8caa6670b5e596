// How far Newton's method goes along a step: until the energy falls.
#pragma once

#include <fem/solver/elastic/mean_pressures.h>
#include <fem/solver/newton/evaluate_state.h>
#include <fem/solver/newton/newton_steps.h>
#include <fem/solver/settings.h>

#include <cmath>

namespace physgen::fem {

/// A full step may raise the energy where the one behind it makes up for that; if it does not, none may any more.
struct Risk {
  bool is_taken = false, is_allowed = true;
  double energy = 0, free = 0;  ///< before the step that took it

  /// @param lowers whether the step from `before` to `next` lowers the energy, or the forces by a tenth at least
  template <class State>
  void accept(const State& before, const State& next, bool lowers) {
    if (is_taken) is_allowed = energy_of(next) < energy || free_force(next) <= 0.9 * free;
    is_taken = !lowers;
    energy = energy_of(before);
    free = free_force(before);
  }
};

/// Goes along v.step from a.positions to a.trial, and leaves the forces there in a.trial_forces. The step is halved
/// until the energy falls; before the first halving the system is solved once more with a tangent that is filtered.
/// @param has_increment whether prescribed components take a.increment in: that step is taken whole where its energy is
/// finite, and else a half, a quarter or an eighth of it that turns no tet over; a.increment stays all of it
/// @param state at a.positions; becomes that at a.trial
/// @param step its halvings, and whether it was filtered
/// @param solve_filtered makes v.step anew; returns whether there is one
/// @return why no step is taken, or `converged` where one is
template <class On, class Arrays, class Level, class Vectors, class Evaluate, class State, class Solve>
[[nodiscard]] NewtonStatus search_along_step(On& on, Arrays& a, Level& level, Vectors& v, Evaluate& evaluator,
                                             const NewtonSettings& settings, double load, bool has_increment,
                                             State& state, Risk& risk, NewtonStep& step, const Solve& solve_filtered) {
  double length = 1;
  for (;;) {
    on.reduce(a.nodes(),
              Advance{length, has_increment, a.positions.const_view(), a.forces.const_view(), v.step.const_view(),
                      a.increment.const_view(), level.constraints.const_view(), a.trial.view()},
              Sum{}, StoreWork{a.state.view()});
    const double work = on.value(a.state).work;
    if (step.halvings == 0) {
      advance_pressures(on, a, evaluator, v.step.const_view());
    } else {
      shorten_pressures(on, a, length);
    }
    const auto next = evaluate_state(on, a, level, evaluator, a.trial.const_view(), a.trial_forces.view(), load, false);
    const bool finite = std::isfinite(energy_of(next)) && std::isfinite(next.free_square);
    const double rounding = 1e-13 * (std::abs(state.elastic) + std::abs(state.volumetric) + std::abs(state.loads));
    const bool falls = energy_of(next) <= energy_of(state) - 1e-4 * length * work + rounding;
    const bool closer = free_force(next) <= 0.9 * free_force(state);
    const bool may_rise =
        settings.full_steps_first && step.halvings == 0 && risk.is_allowed && !risk.is_taken && next.smallest_ratio > 0;
    const bool goes_far_enough = has_increment ? step.halvings == 0 || next.smallest_ratio > 0
                                               : !settings.line_search || falls || closer || may_rise;
    if (finite && goes_far_enough) {
      risk.accept(state, next, has_increment || falls || closer);
      state = next;
      return NewtonStatus::converged;
    }
    if (has_increment) {
      constexpr int most_halvings = 3;  // the load's increment is halved where this does not do
      if (step.halvings == most_halvings) return NewtonStatus::not_finite;
    } else if (!step.filtered) {  // conjugate gradients have not met the negative curvature that there may be
      shorten_pressures(on, a, 0.0);
      if (!solve_filtered()) return NewtonStatus::linear_solver;
      continue;
    }
    if (!has_increment && step.halvings == settings.most_halvings) return NewtonStatus::no_descent;
    ++step.halvings;
    length /= 2;
  }
}

}  // namespace physgen::fem
