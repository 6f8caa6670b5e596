// The solver of linear elastic bodies over one executor and in one precision: see make_linear_solver(). Compiled once
// for each.
#pragma once

#include <fem/solver/arrays/host_points.h>
#include <fem/solver/arrays/node_vectors.h>
#include <fem/solver/loads/loading_arrays.h>
#include <fem/solver/newton/linear_steps.h>
#include <fem/solver/preconditioners/make_linear_levels.h>
#include <fem/solver/quasistatic.h>
#include <fem/solver/solvers/linear_body.h>
#include <fem/solver/solvers/make_executor.h>
#include <fem/solver/solvers/require.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace physgen::fem {

/// @tparam Types LinearAssembledArrays or LinearByTetsArrays of linear_types.h. @pre the settings ask for its product
template <class On, class Types>
class LinearSolverOf final : public EquilibriumSolver {
 public:
  using Space = typename On::Space;
  using Real = typename Types::Real;
  using Body = typename Types::Body;
  using Level = typename Types::Level;
  using Vectors = typename Types::Vectors;

  LinearSolverOf(const std::vector<MeshLevel>& levels, const Loading& loading, const SolverSettings& settings)
      : LinearSolverOf(loading, settings, levels_in_use(levels, unnested(settings))) {}

  NewtonResult solve_to(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) override {
    const SolverState before = state();
    const NewtonResult result = solve_from_rest(load, report);
    if (result.status != NewtonStatus::converged) restore(before);  // load() is that of an equilibrium
    return result;
  }

  void set_loading(const Loading& loading) override {
    require_next_loading(loading, rest_.size(), false, {});
    store_loading(body_, plain_constraints(*on_, linear_[0]->constraints), loading.motion, loading.forces);
    synchronize();
  }

  [[nodiscard]] double load() const override { return load_; }
  [[nodiscard]] std::vector<Point> positions() const override {
    std::vector<Point> x = plain_displacements(*on_, body_.displacements);
    for (std::size_t n = 0; n < x.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) x[n][k] += rest_[n][k];
    }
    return x;
  }
  [[nodiscard]] std::vector<Point> forces() override {
    (void)evaluate(load_);
    return plain_forces(*on_, body_.forces);
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override {
    elasticity::StressArray<double, Space> stresses(body_.tets.size());
    compute_linear_stresses(*on_, body_, lame_, stresses);
    return plain_stresses(*on_, stresses);
  }
  [[nodiscard]] index_t bytes() const override {
    index_t sum = body_.bytes() + vectors_.bytes();
    for (const auto& level : linear_) sum += level->bytes();
    return sum;
  }

  [[nodiscard]] SolverState state() const override { return {load_, true, {positions()}}; }
  void restore(const SolverState& state) override {
    require_state(state, std::array{rest_.size()});
    std::vector<Point> u = state.positions[0];
    for (std::size_t n = 0; n < u.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) u[n][k] -= rest_[n][k];
    }
    store_displacements(*on_, u, body_.displacements);
    load_ = state.load;
  }

 private:
  LinearSolverOf(const Loading& loading, const SolverSettings& settings, LevelsInUse used)
      : settings_(settings),
        rest_(used.levels.front().rest),
        on_(make_executor<On>(index_t(used.levels.front().mesh.tets.size()), settings)),
        linear_(make_linear_levels<Level>(used, settings)),
        lame_(lame_parameters(settings.youngs_modulus, settings.poissons_ratio, "linear elasticity")),
        rounding_force_(rounding_force(settings, used.levels.front(), loading.motion, false,
                                       mean_spacing(used.levels.front().mesh, rest_))) {
    fill_linear_body(body_, used.levels.front(), used.graphs.front(), loading,
                     settings.newton.product == Product::assembled);
    vectors_.allocate({.node = used.graphs.front().nodes});
  }
  static SolverSettings unnested(SolverSettings settings) {
    settings.nested = false;
    return settings;
  }

  /// Leaves what it has found in the displacements, also where it has not converged.
  NewtonResult solve_from_rest(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) {
    using Clock = std::chrono::steady_clock;
    begin_linear(*on_, body_, *linear_[0], lame_, load);
    load_ = load;
    auto state = on_->value(body_.state);
    NewtonResult result;
    for (bool solved = false;;) {
      const double free = std::sqrt(state.free_square), fixed = std::sqrt(state.fixed_square);
      result.energy = state.elastic + state.loads;
      result.reaction = fixed;
      const double residual = fixed > 0 ? free / fixed : (free > 0 ? 1.0 : 0.0);
      // A residual that a solve has not lessened, though it reached its tolerance, is rounding.
      const bool stuck = solved && !(residual < 0.5 * result.residual);
      result.residual = residual;
      if (!std::isfinite(result.energy) || !std::isfinite(free)) result.status = NewtonStatus::not_finite;
      if (result.status != NewtonStatus::converged || free <= rounding_force_ ||
          residual <= settings_.newton.tolerance || stuck) {
        break;
      }
      if (result.steps == settings_.newton.most_steps) {
        result.status = NewtonStatus::too_many_steps;
        break;
      }
      const auto start = Clock::now();
      const LinearResult linear = solve_once();
      result.steps += 1;
      result.iterations += linear.iterations;
      if (linear.status == LinearStatus::not_finite || linear.status == LinearStatus::negative_curvature) {
        result.status = NewtonStatus::linear_solver;
        break;
      }
      solved = linear.status == LinearStatus::converged;
      state = evaluate(load);
      if (report) {
        NewtonStep step;
        step.number = result.steps;
        step.residual = std::sqrt(state.free_square / state.fixed_square);
        step.energy = state.elastic + state.loads;
        step.smallest_J = smallest_ratio();
        step.iterations = linear.iterations;
        step.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        report(0, step);
      }
    }
    result.smallest_J = smallest_ratio();
    return result;
  }

  [[nodiscard]] index_t nodes() const { return body_.displacements.size(); }
  auto evaluate(double load) {
    evaluate_linear(*on_, body_, *linear_[0], lame_, load);
    return on_->value(body_.state);
  }
  LinearResult solve_once() {
    const NewtonSettings& newton = settings_.newton;
    const bool prepared = std::exchange(is_prepared_, true);
    if constexpr (Level::Choices::assembled) {
      if (!prepared) prepare_linear(*on_, body_, linear_, lame_, newton.preconditioner);
      solve_linear(*on_, loop_, body_, linear_, vectors_, newton, linear_tolerance());
    } else {
      Level& level = *linear_[0];
      const bool blocks = asks_for(newton.preconditioner.kind, asks::inverses);
      if (blocks && !prepared) prepare_linear_nodes(*on_, body_, level, lame_);
      solve_linear_matrix_free(*on_, loop_, body_, level, vectors_, lame_, blocks, linear_tolerance(),
                               newton.most_iterations);
    }
    return linear_result(*on_, vectors_);
  }
  /// The tolerance of sqrt(r . z); so far below that of the residual that one solve reaches it, where rounding lets it.
  [[nodiscard]] double linear_tolerance() const {
    return std::max(0.03 * settings_.newton.tolerance, 8.0 * std::numeric_limits<Real>::epsilon());
  }
  [[nodiscard]] double smallest_ratio() {
    measure_smallest_ratio(*on_, body_);
    return on_->value(body_.state).smallest_ratio;
  }

  SolverSettings settings_;
  std::vector<Point> rest_;
  std::unique_ptr<On> on_;
  std::vector<std::unique_ptr<Level>> linear_;  ///< finest first
  LameParameters lame_;
  Body body_;
  Vectors vectors_;
  typename On::Loop loop_;
  double rounding_force_;  ///< [N]
  double load_ = 0;
  bool is_prepared_ = false;
};

}  // namespace physgen::fem
