// The implicit solver of motion over one executor and in one precision: see dynamic_solver.h. Compiled once for each.
#pragma once

#include <fem/solver/arrays/node_vectors.h>
#include <fem/solver/dynamic_solver.h>
#include <fem/solver/masses.h>
#include <fem/solver/solvers/implicit_steps.h>
#include <fem/solver/solvers/require.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace physgen::fem {

/// @tparam Types SolverTypes of solver_types.h, or SceneTypes of scene_types.h
template <class On, class Types>
class ImplicitSolverOf final : public DynamicSolver, private ImplicitSteps<On, Types> {
  using Steps = ImplicitSteps<On, Types>;
  using Steps::arrays_;
  using Steps::body_;
  using Steps::is_moved_;
  using Steps::linear_;
  using Steps::load_;
  using Steps::on_;
  using Steps::settings_;
  using Steps::time_;

 public:
  ImplicitSolverOf(const std::vector<MeshLevel>& levels, const Loading& loading, const DynamicSettings& settings)
      : Steps(levels, loading, unnested(settings.solver)) {
    const bool has_planes = !loading.planes.empty();
    is_moved_ = has_planes;
    std::vector<double> masses = lumped_masses(levels.front().mesh, levels.front().rest, settings.density);
    body_ = {settings.damping, node_stiffness(settings_, has_planes, arrays_.front()->spacing),
             std::ranges::max(masses), nodes()};
    for (std::size_t l = 0; l < linear_.size() && !levels[l].is_grid(); ++l) {
      make(linear_[l]->inertia, masses, l == 0);
      if (l + 1 < linear_.size() && !levels[l + 1].is_grid()) {
        masses = coarsened_masses(masses, levels[l].parents, levels[l + 1].mesh.nodes);
      }
    }
    on_->wait();
  }

  NewtonResult step(double length, double load) override { return Steps::step(length, load); }
  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] std::vector<Point> positions() const override { return points(*on_, arrays_.front()->positions); }
  [[nodiscard]] std::vector<Point> velocities() const override { return plain_velocities(*on_, inertia().velocities); }
  void set_positions(std::span<const Point> positions) override {
    require_vectors("the position", positions, nodes());
    Steps::store(*arrays_.front(), positions);
    is_moved_ = true;
  }
  void set_velocities(std::span<const Point> velocities) override {
    require_vectors("the velocity", velocities, nodes());
    store_velocities(*on_, velocities, inertia().velocities);
  }
  [[nodiscard]] std::vector<Point> forces() override {
    (void)Steps::evaluate_now(0, load_);
    return plain_forces(*on_, arrays_.front()->forces);
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override { return Steps::stresses_at(load_); }
  [[nodiscard]] MotionMeasure measure() override { return Steps::measure(); }
  [[nodiscard]] std::vector<PlaneContact> plane_contacts() override {
    std::vector<PlaneContact> contacts;
    where(linear_.front()->planes, [&](auto& /*planes*/) {
      contacts = measure_planes(*on_, *linear_.front(), arrays_.front()->positions.const_view(), load_);
    });
    return contacts;
  }
  [[nodiscard]] index_t bytes() const override { return Steps::bytes(); }

 private:
  static SolverSettings unnested(SolverSettings settings) {
    settings.nested = false;
    return settings;
  }
  [[nodiscard]] std::size_t nodes() const { return static_cast<std::size_t>(arrays_.front()->nodes()); }
  [[nodiscard]] auto& inertia() const { return *linear_.front()->inertia; }
};

}  // namespace physgen::fem
