// The explicit solver over one executor and in one precision: see explicit.h. Compiled once for each.
#pragma once

#include <fem/dynamics/explicit_body.h>
#include <fem/dynamics/explicit_steps.h>
#include <fem/solver/arrays/host_points.h>
#include <fem/solver/arrays/node_vectors.h>
#include <fem/solver/dynamic_solver.h>
#include <fem/solver/masses.h>
#include <fem/solver/material_names.h>
#include <fem/solver/solvers/make_executor.h>
#include <fem/solver/solvers/require.h>

#include <memory>
#include <utility>

namespace physgen::fem {

/// The steps of a body of one material, whichever it is.
template <class On, class Body>
struct ExplicitSteps {
  using Stresses = elasticity::StressArray<typename Body::Real, typename Body::Space>;
  virtual ~ExplicitSteps() = default;
  virtual void step(On& on, Body& body, const TimeStep& step) const = 0;
  virtual void forces(On& on, Body& body) const = 0;
  virtual void measure(On& on, Body& body) const = 0;
  virtual void stresses(On& on, Body& body, Stresses& stresses) const = 0;
};

template <class On, class Body, class Material>
struct ExplicitStepsOf final : ExplicitSteps<On, Body> {
  using typename ExplicitSteps<On, Body>::Stresses;
  Material material;

  explicit ExplicitStepsOf(const Material& own) : material(own) {}
  void step(On& on, Body& body, const TimeStep& step) const override { explicit_step(on, body, material, step); }
  void forces(On& on, Body& body) const override { compute_forces(on, body, material); }
  void measure(On& on, Body& body) const override { measure_explicit_motion(on, body, material); }
  void stresses(On& on, Body& body, Stresses& stresses) const override {
    compute_stresses(on, body, material, stresses);
  }
};

/// @throw Error when there is no such material, or its constants are out of range
template <class On, class Body>
[[nodiscard]] std::unique_ptr<ExplicitSteps<On, Body>> make_explicit_steps(const SolverSettings& settings) {
  std::unique_ptr<ExplicitSteps<On, Body>> made;
  for_each_material<typename Body::Real>([&]<class Material>(const char* name) {
    if (settings.material != name) return;
    made = std::make_unique<ExplicitStepsOf<On, Body, Material>>(
        Material::from(settings.youngs_modulus, settings.poissons_ratio));
  });
  if (made == nullptr) refuse_material(settings.material);
  return made;
}

template <class On, class Real>
class ExplicitSolverOf final : public DynamicSolver {
 public:
  using Space = typename On::Space;
  using Body = scenes::explicit_dynamics_scene::Body<Space, Real>;

  ExplicitSolverOf(const MeshLevel& level, const Loading& loading, const DynamicSettings& settings)
      : settings_(settings),
        rest_(level.rest),
        on_(make_executor<On>(index_t(level.mesh.tets.size()), settings.solver)),
        steps_(make_explicit_steps<On, Body>(settings.solver)) {
    fill_explicit_body(body_, level, loading, lumped_masses(level.mesh, level.rest, settings.density),
                       settings.fixed_order);
  }

  NewtonResult step(double length, double load) override {
    require_step(length, load);
    steps_->step(*on_, body_, {length, load, settings_.damping});
    time_ += length;
    load_ = load;
    return {};
  }
  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] std::vector<Point> positions() const override {
    std::vector<Point> x = plain_displacements(*on_, body_.displacements);
    for (std::size_t n = 0; n < x.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) x[n][k] += rest_[n][k];
    }
    return x;
  }
  [[nodiscard]] std::vector<Point> velocities() const override { return plain_velocities(*on_, body_.velocities); }
  void set_positions(std::span<const Point> positions) override {
    require_vectors("the position", positions, rest_.size());
    std::vector<Point> u(positions.begin(), positions.end());
    for (std::size_t n = 0; n < u.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) u[n][k] -= rest_[n][k];
    }
    store_displacements(*on_, u, body_.displacements);
    store_displacements(*on_, u, body_.rounded);
  }
  void set_velocities(std::span<const Point> velocities) override {
    require_vectors("the velocity", velocities, rest_.size());
    store_velocities(*on_, velocities, body_.velocities);
  }
  [[nodiscard]] std::vector<Point> forces() override {
    steps_->forces(*on_, body_);
    std::vector<Point> f = plain_forces(*on_, body_.forces);
    const std::vector<Point> loads = plain_forces(*on_, body_.loads);
    for (std::size_t n = 0; n < f.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) f[n][k] += load_ * loads[n][k];
    }
    return f;
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override {
    typename ExplicitSteps<On, Body>::Stresses stresses(body_.tets.size());
    steps_->stresses(*on_, body_, stresses);
    return plain_stresses(*on_, stresses);
  }
  [[nodiscard]] MotionMeasure measure() override {
    steps_->measure(*on_, body_);
    const auto found = on_->value(body_.measured);
    return {found.kinetic, found.elastic, {found.momentum[0], found.momentum[1], found.momentum[2]}};
  }
  [[nodiscard]] index_t bytes() const override { return body_.bytes(); }

 private:
  DynamicSettings settings_;
  std::vector<Point> rest_;
  std::unique_ptr<On> on_;
  std::unique_ptr<ExplicitSteps<On, Body>> steps_;
  Body body_;
  double time_ = 0, load_ = 0;
};

}  // namespace physgen::fem
