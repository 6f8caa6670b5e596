// The solver over one executor and in one precision: see quasistatic.h. Compiled once for each.
#pragma once

#include <fem/solver/host_points.h>
#include <fem/solver/measure_linear.h>
#include <fem/solver/newton.h>
#include <fem/solver/quasistatic.h>
#include <fem/solver/solver_parts.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace physgen::fem {

template <class On, class Real, class Stored>
class SolverOf final : public QuasistaticSolver, private SolverParts<On, Real, Stored> {
  using Parts = SolverParts<On, Real, Stored>;
  using Parts::all_prescribed_;
  using Parts::arrays_;
  using Parts::evaluate_now;
  using Parts::evaluator_;
  using Parts::linear_;
  using Parts::loops_;
  using Parts::moves_;
  using Parts::on_;
  using Parts::require_nodes;
  using Parts::rounding_forces_;
  using Parts::settings_;
  using Parts::solved_;
  using Parts::store;
  using Parts::vectors_;
  using typename Parts::Arrays;
  using typename Parts::Level;
  using typename Parts::Space;

 public:
  SolverOf(const std::vector<MeshLevel>& levels, const Loading& loading, const SolverSettings& settings)
      : Parts(levels, loading, settings) {
    reached_ = loading.planes.empty();  // planes may push at rest
    on_->wait();
  }

  NewtonResult solve_to(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) override {
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

  [[nodiscard]] double load() const override { return load_; }
  [[nodiscard]] std::vector<Point> positions() const override { return points(arrays_.front()->positions); }
  [[nodiscard]] std::vector<Point> forces() override {
    (void)evaluate_now(0, load_);
    return plain_forces(arrays_.front()->forces);
  }
  [[nodiscard]] std::optional<NodeState> coarser_equilibrium() override {
    if (solved_ < 2 || coarser_load_ != load_ || !reached_) return std::nullopt;
    const Arrays& coarser = *arrays_[1];
    (void)evaluate_now(1, load_);
    return NodeState{points(coarser.positions), plain_forces(coarser.forces), plane_contacts_of(1)};
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override { return Parts::stresses_at(load_); }
  [[nodiscard]] std::vector<PlaneContact> plane_contacts() override { return plane_contacts_of(0); }
  [[nodiscard]] index_t bytes() const override { return Parts::bytes(); }

  [[nodiscard]] SolverState state() const override {
    SolverState state;
    state.load = load_;
    state.is_equilibrium = reached_;
    for (const auto& a : arrays_) state.positions.push_back(points(a->positions));
    return state;
  }
  void restore(const SolverState& state) override {
    if (state.positions.size() != arrays_.size()) {
      throw Error("a state of " + std::to_string(state.positions.size()) + " levels for a solver that solves on " +
                  std::to_string(arrays_.size()));
    }
    for (std::size_t l = 0; l < arrays_.size(); ++l) require_nodes(l, state.positions[l].size());
    for (std::size_t l = 0; l < arrays_.size(); ++l) store(*arrays_[l], state.positions[l]);
    load_ = state.load;
    reached_ = state.is_equilibrium;
    coarser_load_ = reached_ ? load_ : std::numeric_limits<double>::quiet_NaN();
    last_reaction_ = reached_ ? state_now().reaction : 0.0;
  }
  void set_positions(std::span<const Point> positions) override {
    require_nodes(0, positions.size());
    store(*arrays_.front(), positions);
    reached_ = false;
  }

  [[nodiscard]] AssembledStiffness stiffness() override {
    if (settings_.newton.product != Product::assembled) {
      throw Error("the stiffness as blocks is that of the assembled product: the matrix-free one forms none");
    }
    (void)evaluate_now(0, load_);
    form_tangent(*on_, *arrays_.front(), *linear_.front(), *evaluator_, TangentFilter::none, load_);
    on_->wait();
    return linear_.front()->stiffness();
  }
  LinearMeasurement measure_linear(std::span<const Point> force, const LinearTask& task,
                                   std::vector<Point>* step) override {
    require_nodes(0, force.size());
    (void)evaluate_now(0, load_);
    return fem::measure_linear(*on_, *arrays_.front(), linear_, *vectors_.front(), *evaluator_, settings_.newton, load_,
                               task, force, step);
  }

 private:
  /// What a solve that has nothing to do would say.
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

  /// To a load, from the equilibrium that is kept: nested, or by the increment inside the first linear solve.
  NewtonResult solve_increment(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) {
    NewtonResult total;
    for (std::size_t l = solved_; l-- > 0;) {
      Arrays& a = *arrays_[l];
      Level& level = *linear_[l];
      const bool coarsest = l + 1 == solved_;
      if (!coarsest) {
        const Arrays& coarse = *arrays_[l + 1];
        on_->run(a.nodes(),
                 InterpolateMotion{HalfWay{level.parents.const_view()}, coarse.kept.const_view(),
                                   coarse.positions.const_view(), level.constraints.const_view(), a.positions.view()});
      }
      on_->run(a.nodes(),
               ComputeIncrement{load, a.rest.const_view(), a.motion.const_view(), level.constraints.const_view(),
                                a.positions.const_view(), a.increment.view()});
      if (!coarsest) on_->run(a.nodes(), MovePrescribed{a.increment.const_view(), a.positions.view()});
      const bool injects =
          !coarsest && inject_pressures(*on_, std::as_const(*arrays_[l + 1]), a, level.parents.const_view());
      const bool increment = coarsest && moves_[l] && (load != load_ || !reached_);
      NewtonSettings newton = settings_.newton;
      newton.start_load = load_;
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

  [[nodiscard]] std::vector<PlaneContact> plane_contacts_of(std::size_t level) {
    if (linear_[level]->planes == nullptr) return {};
    return measure_planes(*on_, *linear_[level], arrays_[level]->positions.const_view(), load_);
  }
  double last_reaction_ = 0;  ///< at the last equilibrium [N]
  double load_ = 0;
  double coarser_load_ = std::numeric_limits<double>::quiet_NaN();  ///< of the coarser levels' equilibria
  bool reached_ = true;  ///< whether the positions are an equilibrium of load_
};

}  // namespace physgen::fem
