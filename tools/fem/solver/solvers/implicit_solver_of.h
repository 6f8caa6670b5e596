// The implicit solver of motion over one executor and in one precision: see dynamic_solver.h. Compiled once for each.
#pragma once

#include <fem/solver/arrays/node_vectors.h>
#include <fem/solver/dynamic_solver.h>
#include <fem/solver/masses.h>
#include <fem/solver/newton/implicit_step.h>
#include <fem/solver/solvers/require.h>
#include <fem/solver/solvers/solver_parts.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace physgen::fem {

/// @tparam Types SolverTypes of solver_types.h, or SceneTypes of scene_types.h
template <class On, class Types>
class ImplicitSolverOf final : public DynamicSolver, private SolverParts<On, Types> {
  using Parts = SolverParts<On, Types>;
  using Parts::all_prescribed_;
  using Parts::arrays_;
  using Parts::evaluator_;
  using Parts::linear_;
  using Parts::loops_;
  using Parts::moves_;
  using Parts::on_;
  using Parts::settings_;
  using Parts::vectors_;
  using typename Parts::Arrays;
  using typename Parts::Space;

 public:
  ImplicitSolverOf(const std::vector<MeshLevel>& levels, const Loading& loading, const DynamicSettings& settings)
      : Parts(levels, loading, unnested(settings.solver)),
        damping_(settings.damping),
        has_planes_(!loading.planes.empty()),
        is_moved_(has_planes_) {
    std::vector<double> masses = lumped_masses(levels.front().mesh, levels.front().rest, settings.density);
    largest_mass_ = std::ranges::max(masses);
    for (std::size_t l = 0; l < linear_.size() && !levels[l].is_grid(); ++l) {
      make(linear_[l]->inertia, masses, l == 0);
      if (l + 1 < linear_.size() && !levels[l + 1].is_grid()) {
        masses = coarsened_masses(masses, levels[l].parents, levels[l + 1].mesh.nodes);
      }
    }
    on_->wait();
  }

  NewtonResult step(double length, double load) override {
    require_step(length, load);
    Arrays& a = *arrays_.front();
    NewtonSettings newton = settings_.newton;
    newton.start_load = load_;
    newton.last_reaction = last_reaction_;
    const double inertial = largest_mass_ * (1 / length + damping_) / length;
    newton.rounding_force = rounding_force(node_stiffness(settings_, has_planes_, a.spacing) + inertial,
                                           largest_coordinate(*on_, a, *linear_.front()), std::size_t(a.nodes()));
    newton.all_prescribed = all_prescribed_.front();
    const bool moves = moves_.front() && (is_moved_ || load != load_);
    const NewtonResult result = implicit_step(*on_, loops_.front(), a, linear_, *vectors_.front(), *evaluator_, newton,
                                              {length, load, damping_}, moves);
    if (result.status != NewtonStatus::converged) return result;
    time_ += length;
    load_ = load;
    is_moved_ = false;
    last_reaction_ = result.reaction;
    return result;
  }

  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] std::vector<Point> positions() const override { return points(*on_, arrays_.front()->positions); }
  [[nodiscard]] std::vector<Point> velocities() const override { return plain_velocities(*on_, inertia().velocities); }
  void set_positions(std::span<const Point> positions) override {
    require_vectors("the position", positions, nodes());
    Parts::store(*arrays_.front(), positions);
    is_moved_ = true;
  }
  void set_velocities(std::span<const Point> velocities) override {
    require_vectors("the velocity", velocities, nodes());
    store_velocities(*on_, velocities, inertia().velocities);
  }
  [[nodiscard]] std::vector<Point> forces() override {
    (void)Parts::evaluate_now(0, load_);
    return plain_forces(*on_, arrays_.front()->forces);
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override { return Parts::stresses_at(load_); }
  [[nodiscard]] MotionMeasure measure() override {
    const auto found = measure_motion(*on_, *arrays_.front(), *linear_.front());
    const auto state = Parts::evaluate_now(0, load_);
    return {found.kinetic, state.elastic + state.volumetric, {found.momentum[0], found.momentum[1], found.momentum[2]}};
  }
  [[nodiscard]] std::vector<PlaneContact> plane_contacts() override {
    std::vector<PlaneContact> contacts;
    where(linear_.front()->planes, [&](auto& /*planes*/) {
      contacts = measure_planes(*on_, *linear_.front(), arrays_.front()->positions.const_view(), load_);
    });
    return contacts;
  }
  [[nodiscard]] index_t bytes() const override { return Parts::bytes(); }

 private:
  static SolverSettings unnested(SolverSettings settings) {
    settings.nested = false;
    return settings;
  }
  [[nodiscard]] std::size_t nodes() const { return static_cast<std::size_t>(arrays_.front()->nodes()); }
  [[nodiscard]] auto& inertia() const { return *linear_.front()->inertia; }

  double damping_;  ///< [1/s]
  bool has_planes_;
  bool is_moved_;             ///< whether positions were set from outside, or planes may push at rest
  double largest_mass_ = 0;   ///< of a node [kg]
  double last_reaction_ = 0;  ///< [N]
  double time_ = 0, load_ = 0;
};

}  // namespace physgen::fem
