// Newton's method over nested meshes and the steps of a load: what a solver does, over parts of any types.
#pragma once

#include <fem/solver/newton/interpolate_motion.h>
#include <fem/solver/solvers/solver_parts.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace physgen::fem {

template <class On, class Types>
class NestedNewton : protected SolverParts<On, Types> {
  using Parts = SolverParts<On, Types>;

 protected:
  using Parts::all_prescribed_;
  using Parts::arrays_;
  using Parts::evaluate_now;
  using Parts::evaluator_;
  using Parts::linear_;
  using Parts::loops_;
  using Parts::moves_;
  using Parts::on_;
  using Parts::Parts;
  using Parts::rounding_forces_;
  using Parts::settings_;
  using Parts::solved_;
  using Parts::vectors_;
  using typename Parts::Arrays;
  using typename Parts::Level;

  NewtonResult solve_to(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) {
    if (load == load_ && reached_) return state_now();
    NewtonResult total;
    int halvings = 0;
    while (load_ != load || !reached_) {
      const double next = halvings == 0 ? load : load_ + (load - load_) * std::ldexp(1.0, -halvings);
      const NewtonResult result = solve_increment(next, report);
      add_increment(total, result);
      if (result.status == NewtonStatus::converged) {
        load_ = next;
        reached_ = true;
        coarser_load_ = next;
        last_reaction_ = total.reaction;
        for (auto& a : arrays_) on_->run(a->nodes(), KeepPositions{a->positions.const_view(), a->kept.view()});
        if (halvings > 0) --halvings;
        continue;
      }
      for (auto& a : arrays_) on_->run(a->nodes(), KeepPositions{a->kept.const_view(), a->positions.view()});
      const bool began_badly = result.status == NewtonStatus::not_finite && result.steps == 0;
      if (began_badly || load_ == load || ++halvings > settings_.most_bisections ||
          total.bisections >= 4 * settings_.most_bisections) {
        return total;
      }
      ++total.bisections;
    }
    total.status = NewtonStatus::converged;
    return total;
  }

  /// The result of a solve that has nothing to do.
  [[nodiscard]] NewtonResult state_now() {
    const auto state = evaluate_now(0, load_);
    NewtonResult result;
    result.energy = state.elastic + state.volumetric + state.loads;
    result.smallest_J = state.smallest_ratio;
    result.reaction = std::sqrt(state.fixed_square);
    const double scale = std::max(result.reaction, last_reaction_);
    result.residual = scale > 0 ? std::sqrt(state.free_square) / scale : 0.0;
    return result;
  }

  [[nodiscard]] std::vector<PlaneContact> plane_contacts_of(std::size_t level) {
    std::vector<PlaneContact> contacts;
    where(linear_[level]->planes, [&](auto& /*planes*/) {
      contacts = measure_planes(*on_, *linear_[level], arrays_[level]->positions.const_view(), load_);
    });
    return contacts;
  }

  double last_reaction_ = 0;  ///< at the last equilibrium [N]
  double load_ = 0;
  double coarser_load_ = std::numeric_limits<double>::quiet_NaN();  ///< of the coarser levels' equilibria
  bool reached_ = true;  ///< whether the positions are an equilibrium of load_

 private:
  void find_increment(Arrays& a, const Level& level, double load) {
    on_->run(a.nodes(), ComputeIncrement{load, a.rest.const_view(), a.motion.const_view(),
                                         level.constraints.const_view(), a.positions.const_view(), a.increment.view()});
  }
  /// Averages at nodes the gradients of the motion from where the load increment began.
  void average_gradients(Arrays& a) {
    on_->run(a.nodes(), AverageMotionGradients{a.node_tets.const_view(), a.tets.const_view(), a.rest.const_view(),
                                               a.kept.const_view(), a.positions.const_view(), node_matrices(a)});
  }
  /// Moves positions, which are kept, by what the next coarser level has moved, and prescribed components to a load.
  void begin_from_coarser(std::size_t l, double load, bool bends) {
    Arrays& a = *arrays_[l];
    const Arrays& coarse = *arrays_[l + 1];
    const Level& level = *linear_[l];
    on_->run(a.nodes(),
             InterpolateMotion{bends, level.parents.const_view(), a.rest.const_view(), coarse.rest.const_view(),
                               coarse.kept.const_view(), coarse.positions.const_view(), const_node_matrices(coarse),
                               level.constraints.const_view(), a.positions.view()});
    find_increment(a, level, load);
    on_->run(a.nodes(), MovePrescribed{a.increment.const_view(), a.positions.view()});
  }
  /// The smallest ratio of a tet's current volume to its rest volume.
  [[nodiscard]] double smallest_ratio(Arrays& a) {
    on_->reduce(a.tet_count(), VolumeRatio{a.tets.const_view(), a.rest.const_view(), a.positions.const_view()}, Min{},
                StoreSmallestRatio{a.state.view()});
    return on_->value(a.state).smallest_ratio;
  }
  /// Seeks the equilibrium of a load from the kept one: nested, or by the increment inside the first linear solve.
  NewtonResult solve_increment(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) {
    NewtonResult total;
    for (std::size_t l = solved_; l-- > 0;) {
      Arrays& a = *arrays_[l];
      Level& level = *linear_[l];
      const bool coarsest = l + 1 == solved_;
      if (coarsest) {
        find_increment(a, level, load);
      } else {
        average_gradients(*arrays_[l + 1]);
        begin_from_coarser(l, load, true);
        if (!(smallest_ratio(a) > 0)) {
          on_->run(a.nodes(), KeepPositions{a.kept.const_view(), a.positions.view()});
          begin_from_coarser(l, load, false);
        }
      }
      const bool injects =
          !coarsest && inject_pressures(*on_, std::as_const(*arrays_[l + 1]), a, level.parents.const_view());
      const bool increment = coarsest && moves_[l] && (load != load_ || !reached_);
      NewtonSettings newton = settings_.newton;
      newton.start_load = load_;
      newton.is_interpolated = !coarsest;
      newton.start_is_given = l == 0 && !reached_;
      newton.last_reaction = last_reaction_;
      if (l > 0) newton.tolerance = std::max(newton.tolerance, settings_.coarser_tolerance);
      newton.rounding_force = rounding_forces_[l];
      newton.all_prescribed = all_prescribed_[l];
      const NewtonResult result = find_equilibrium(*on_, loops_[l], a, linear_, l, *vectors_[l], *evaluator_, newton,
                                                   load, increment, !injects, [&](const NewtonStep& step) {
                                                     if (report) report(l, step);
                                                   });
      if (l > 0) {
        total.coarse_steps += result.steps;
        total.coarse_iterations += result.iterations;
        if (result.status != NewtonStatus::converged) {
          total.status = result.status;
          return total;
        }
      } else {
        const int steps = total.coarse_steps, iterations = total.coarse_iterations;
        total = result;
        total.coarse_steps = steps;
        total.coarse_iterations = iterations;
      }
    }
    return total;
  }
};

}  // namespace physgen::fem
