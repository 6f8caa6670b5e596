// The solver of linear elastic bodies over one executor and in one precision: see make_linear_solver(). Compiled once
// for each.
#pragma once

#include <fem/solver/arrays/host_points.h>
#include <fem/solver/arrays/node_vectors.h>
#include <fem/solver/loads/loading_arrays.h>
#include <fem/solver/preconditioners/make_linear_levels.h>
#include <fem/solver/quasistatic.h>
#include <fem/solver/solvers/linear_body.h>
#include <fem/solver/solvers/linear_solves.h>
#include <fem/solver/solvers/make_executor.h>
#include <fem/solver/solvers/require.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace physgen::fem {

/// @tparam Types LinearAssembledArrays or LinearByTetsArrays of linear_types.h. @pre the settings ask for its product
template <class On, class Types>
class LinearSolverOf final : public EquilibriumSolver, private LinearSolves<On, Types> {
  using Solves = LinearSolves<On, Types>;
  using Solves::body_;
  using Solves::lame_;
  using Solves::linear_;
  using Solves::load_;
  using Solves::on_;
  using Solves::vectors_;
  using typename Solves::Level;

 public:
  LinearSolverOf(const std::vector<MeshLevel>& levels, const Loading& loading, const SolverSettings& settings)
      : LinearSolverOf(loading, settings, levels_in_use(levels, unnested(settings))) {}

  NewtonResult solve_to(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) override {
    const SolverState before = state();
    const NewtonResult result = Solves::solve_from_rest(load, report);
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
    (void)Solves::evaluate(load_);
    return plain_forces(*on_, body_.forces);
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override {
    elasticity::StressArray<double, typename On::Space> stresses(body_.tets.size());
    compute_linear_stresses(*on_, body_, lame_, stresses);
    return plain_stresses(*on_, stresses);
  }
  [[nodiscard]] index_t bytes() const override { return Solves::bytes(); }

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
      : Solves(make_executor<On>(index_t(used.levels.front().mesh.tets.size()), settings), settings,
               rounding_force(settings, used.levels.front(), loading.motion, false,
                              mean_spacing(used.levels.front().mesh, used.levels.front().rest))),
        rest_(used.levels.front().rest) {
    linear_ = make_linear_levels<Level>(used, settings);
    fill_linear_body(body_, used.levels.front(), used.graphs.front(), loading,
                     settings.newton.product == Product::assembled);
    vectors_.allocate({.node = used.graphs.front().nodes});
  }
  static SolverSettings unnested(SolverSettings settings) {
    settings.nested = false;
    return settings;
  }

  std::vector<Point> rest_;
};

}  // namespace physgen::fem
