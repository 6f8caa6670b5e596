// Equilibria of linear elastic bodies: what a solver does, over arrays that are made.
#pragma once

#include <fem/solver/arrays/node_vectors.h>
#include <fem/solver/newton/linear_steps.h>
#include <fem/solver/preconditioners/all.h>
#include <fem/solver/quasistatic.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace physgen::fem {

/// @tparam Types LinearAssembledArrays or LinearByTetsArrays of linear_types.h. @pre the settings ask for its product
template <class On, class Types>
class LinearSolves {
 protected:
  using Real = typename Types::Real;
  using Body = typename Types::Body;
  using Level = typename Types::Level;
  using Vectors = typename Types::Vectors;

  /// The caller makes the arrays. @param rounding_force [N], up to which forces count as rounding
  LinearSolves(std::unique_ptr<On> on, const SolverSettings& settings, double rounding_force)
      : settings_(settings),
        on_(std::move(on)),
        lame_(lame_parameters(settings.youngs_modulus, settings.poissons_ratio, "linear elasticity")),
        rounding_force_(rounding_force) {}

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
      const LinearResult linear = solve_once(linear_tolerance(), settings_.newton.most_iterations);
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

  auto evaluate(double load) {
    evaluate_linear(*on_, body_, *linear_[0], lame_, load);
    return on_->value(body_.state);
  }
  /// For the forces that were evaluated last.
  LinearResult solve_once(double tolerance, int most_iterations) {
    NewtonSettings newton = settings_.newton;
    newton.most_iterations = most_iterations;
    const bool prepared = std::exchange(is_prepared_, true);
    if constexpr (Level::Choices::assembled) {
      if (!prepared) prepare_linear(*on_, body_, linear_, lame_, newton.preconditioner);
      solve_linear(*on_, loop_, body_, linear_, vectors_, newton, tolerance);
    } else {
      Level& level = *linear_[0];
      const bool blocks = asks_for(newton.preconditioner.kind, asks::inverses);
      if (blocks && !prepared) prepare_linear_nodes(*on_, body_, level, lame_);
      solve_linear_matrix_free(*on_, loop_, body_, level, vectors_, lame_, blocks, tolerance, most_iterations);
    }
    return linear_result(*on_, vectors_);
  }
  [[nodiscard]] index_t bytes() const {
    index_t sum = body_.bytes() + vectors_.bytes();
    for (const auto& level : linear_) sum += level->bytes();
    return sum;
  }

  SolverSettings settings_;
  std::unique_ptr<On> on_;
  std::vector<std::unique_ptr<Level>> linear_;  ///< finest first
  LameParameters lame_;
  Body body_;
  Vectors vectors_;
  typename On::Loop loop_;
  double rounding_force_;  ///< [N]
  double load_ = 0;

 private:
  /// The tolerance of sqrt(r . z); so far below that of the residual that one solve reaches it, where rounding lets it.
  [[nodiscard]] double linear_tolerance() const {
    return std::max(0.03 * settings_.newton.tolerance, 8.0 * std::numeric_limits<Real>::epsilon());
  }
  [[nodiscard]] double smallest_ratio() {
    measure_smallest_ratio(*on_, body_);
    return on_->value(body_.state).smallest_ratio;
  }

  bool is_prepared_ = false;
};

}  // namespace physgen::fem
