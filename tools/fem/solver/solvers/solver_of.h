// The solver over one executor and in one precision: see quasistatic.h. Compiled once for each.
#pragma once

#include <fem/solver/arrays/host_points.h>
#include <fem/solver/quasistatic.h>
#include <fem/solver/solvers/measure_linear.h>
#include <fem/solver/solvers/nested_newton.h>
#include <fem/solver/solvers/require.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace physgen::fem {

/// Whether types are those of a scene, over arrays that lack what its program does without.
template <class Types>
inline constexpr bool is_of_scene = requires { typename Types::Law; };

/// @tparam Types SolverTypes of solver_types.h, or SceneTypes of scene_types.h
template <class On, class Types>
class SolverOf final : public QuasistaticSolver, private NestedNewton<On, Types> {
  using Nested = NestedNewton<On, Types>;
  using Nested::arrays_;
  using Nested::coarser_load_;
  using Nested::evaluate_now;
  using Nested::evaluator_;
  using Nested::last_reaction_;
  using Nested::linear_;
  using Nested::load_;
  using Nested::on_;
  using Nested::plane_contacts_of;
  using Nested::reached_;
  using Nested::settings_;
  using Nested::solved_;
  using Nested::state_now;
  using Nested::store;
  using Nested::vectors_;
  using typename Nested::Arrays;

 public:
  SolverOf(const std::vector<MeshLevel>& levels, const Loading& loading, const SolverSettings& settings)
      : Nested(levels, loading, settings) {
    reached_ = loading.planes.empty();  // planes may push at rest
    has_planes_ = !loading.planes.empty();
    faces_ = pressed_nodes(loading.pressures);
    on_->wait();
  }

  NewtonResult solve_to(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) override {
    return Nested::solve_to(load, report);
  }

  void set_loading(const Loading& loading) override {
    require_next_loading(loading, nodes(), has_planes_, faces_);
    Nested::replace_loading(loading);
    reached_ = false;
  }

  [[nodiscard]] double load() const override { return load_; }
  [[nodiscard]] std::vector<Point> positions() const override { return points(*on_, arrays_.front()->positions); }
  [[nodiscard]] std::vector<Point> forces() override {
    (void)evaluate_now(0, load_);
    return plain_forces(*on_, arrays_.front()->forces);
  }
  [[nodiscard]] std::optional<NodeState> coarser_equilibrium() override {
    if (solved_ < 2 || coarser_load_ != load_ || !reached_) return std::nullopt;
    const Arrays& coarser = *arrays_[1];
    (void)evaluate_now(1, load_);
    return NodeState{points(*on_, coarser.positions), plain_forces(*on_, coarser.forces), plane_contacts_of(1)};
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override { return Nested::stresses_at(load_); }
  [[nodiscard]] std::vector<PlaneContact> plane_contacts() override { return plane_contacts_of(0); }
  [[nodiscard]] index_t bytes() const override { return Nested::bytes(); }

  [[nodiscard]] SolverState state() const override {
    SolverState state;
    state.load = load_;
    state.is_equilibrium = reached_;
    for (const auto& a : arrays_) state.positions.push_back(points(*on_, a->positions));
    return state;
  }
  void restore(const SolverState& state) override {
    std::vector<std::size_t> counts;
    for (const auto& a : arrays_) counts.push_back(static_cast<std::size_t>(a->nodes()));
    require_state(state, counts);
    for (std::size_t l = 0; l < arrays_.size(); ++l) store(*arrays_[l], state.positions[l]);
    load_ = state.load;
    reached_ = state.is_equilibrium;
    coarser_load_ = reached_ ? load_ : std::numeric_limits<double>::quiet_NaN();
    last_reaction_ = reached_ ? state_now().reaction : 0.0;
  }
  void set_positions(std::span<const Point> positions) override {
    require_vectors("the position", positions, nodes());
    store(*arrays_.front(), positions);
    reached_ = false;
  }

  [[nodiscard]] AssembledStiffness stiffness() override {
    if (settings_.newton.product != Product::assembled) {
      throw Error("a matrix-free product has no blocks of the stiffness; set Product::assembled");
    }
    if constexpr (Types::Level::Choices::assembled) {
      (void)evaluate_now(0, load_);
      form_tangent(*on_, *arrays_.front(), *linear_.front(), *evaluator_, TangentFilter::none, load_);
      on_->wait();
      return linear_.front()->stiffness();
    }
    return {};
  }
  LinearMeasurement measure_linear(std::span<const Point> force, const LinearTask& task,
                                   std::vector<Point>* step) override {
    if constexpr (is_of_scene<Types>) {
      throw Error("only solvers over all arrays measure linear solves; this one has the arrays of a scene");
    } else {
      require_vectors("the force", force, nodes());
      (void)evaluate_now(0, load_);
      return fem::measure_linear(*on_, *arrays_.front(), linear_, *vectors_.front(), *evaluator_, settings_.newton,
                                 load_, task, force, step);
    }
  }

 private:
  bool has_planes_ = false;
  std::vector<Face> faces_;  ///< that pressures push
  [[nodiscard]] std::size_t nodes() const { return static_cast<std::size_t>(arrays_.front()->nodes()); }
};

}  // namespace physgen::fem
