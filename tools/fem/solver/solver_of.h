// The solver over one executor and in one precision: see quasistatic.h. Compiled once for each.
#pragma once

#include <fem/solver/host_points.h>
#include <fem/solver/loading_arrays.h>
#include <fem/solver/measure_linear.h>
#include <fem/solver/newton.h>
#include <fem/solver/quasistatic.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <utility>

namespace physgen::fem {

/// The executor, which on CUDA must know the longest range that is reduced.
template <class On>
[[nodiscard]] std::unique_ptr<On> make_executor(index_t objects) {
  if constexpr (std::is_default_constructible_v<On>) {
    return std::make_unique<On>();
  } else {
    return std::make_unique<On>(objects);
  }
}

template <class On, class Real, class Stored>
class SolverOf final : public QuasistaticSolver {
 public:
  using Space = typename On::Space;
  using Arrays = EquilibriumArrays<Real, Space>;
  using Level = LinearLevel<Real, Space, Stored>;
  using Vectors = KrylovVectors<Real, Space>;

  SolverOf(const std::vector<MeshLevel>& levels, const Loading& loading, const SolverSettings& settings)
      : settings_(settings),
        on_(make_executor<On>(index_t(levels.front().mesh.tets.size()))),
        evaluator_(
            make_evaluator<On, Arrays>(settings.material, settings.youngs_modulus, settings.poissons_ratio,
                                       levels.front().averages_at_nodes || !levels.front().patches.nodes.empty())) {
    const bool assembled = settings.newton.product == Product::assembled;
    const auto meshes = static_cast<std::size_t>(std::ranges::find_if(levels, &MeshLevel::is_grid) - levels.begin());
    const auto [used, solved] = used_levels(settings, levels.size(), meshes);
    solved_ = solved;
    std::vector<MeshLevel> own(levels.begin(), levels.begin() + static_cast<std::ptrdiff_t>(used));
    const std::vector<LevelGraph> graphs = make_level_graphs(own, assembled);
    const TangentLists lists = tangent_lists<Space>(settings.newton);
    const bool blocks = settings.newton.preconditioner.kind != Preconditioner::none;
    std::vector<Point> motion = loading.motion, forces = loading.forces;
    for (std::size_t l = 0; l < used; ++l) {
      const LevelGraph* next = l + 1 < used ? &graphs[l + 1] : nullptr;
      linear_.push_back(assembled ? std::make_unique<Level>(graphs[l], next, own[l].rest)
                                  : std::make_unique<Level>(graphs[l], MatrixFree{blocks, next != nullptr}));
      if (l < solved_) {
        if (settings.newton.preconditioner.kind == Preconditioner::schwarz) {
          linear_.back()->use_schwarz(graphs[l], own[l].rest);
        }
        arrays_.push_back(std::make_unique<Arrays>(own[l], graphs[l], l + 1 < solved_, lists,
                                                   l == 0 ? nullptr : arrays_.front()->chunk_arrays));
        vectors_.push_back(std::make_unique<Vectors>(graphs[l].nodes));
        loops_.emplace_back();
        store_loading(*arrays_.back(), own[l], motion, forces);
        rounding_forces_.push_back(
            rounding_force(settings, own[l], motion, !loading.planes.empty(), arrays_.back()->spacing));
        moves_.push_back(std::ranges::any_of(own[l].fixed, [](std::uint8_t fixed) { return fixed != 0; }) ||
                         !loading.planes.empty());
        all_prescribed_.push_back(std::ranges::all_of(own[l].fixed, [](std::uint8_t fixed) { return fixed == 7; }));
      }
      if (!loading.planes.empty() && !own[l].is_grid()) {
        linear_.back()->planes = make_planes(l, own[l], loading.planes);
      }
      if (l + 1 < solved_) coarsen_loading(own[l], own[l + 1].mesh.nodes, motion, forces);
    }
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
    (void)evaluate_now();
    return plain_forces(arrays_.front()->forces);
  }
  [[nodiscard]] std::optional<NodeState> coarser_equilibrium() override {
    if (solved_ < 2 || coarser_load_ != load_ || !reached_) return std::nullopt;
    const Arrays& coarser = *arrays_[1];
    (void)evaluate_now(1);
    return NodeState{points(coarser.positions), plain_forces(coarser.forces), plane_contacts_of(1)};
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override {
    (void)evaluate_now();
    Arrays& a = *arrays_.front();
    typename Evaluator<On, Arrays>::Stresses stresses(a.tet_count());
    evaluator_->evaluate_stress(*on_, a, stresses);
    on_->wait();
    return plain_stresses(stresses);
  }
  [[nodiscard]] std::vector<PlaneContact> plane_contacts() override { return plane_contacts_of(0); }
  [[nodiscard]] index_t bytes() const override {
    index_t sum = arrays_.front()->chunk_arrays->bytes();
    for (const auto& level : linear_) sum += level->bytes();
    for (const auto& arrays : arrays_) sum += arrays->bytes();
    for (const auto& vectors : vectors_) sum += vectors->bytes();
    return sum;
  }

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
    (void)evaluate_now();
    form_tangent(*on_, *arrays_.front(), *linear_.front(), *evaluator_, TangentFilter::none, load_);
    on_->wait();
    return linear_.front()->stiffness();
  }
  LinearMeasurement measure_linear(std::span<const Point> force, const LinearTask& task,
                                   std::vector<Point>* step) override {
    require_nodes(0, force.size());
    (void)evaluate_now();
    return fem::measure_linear(*on_, *arrays_.front(), linear_, *vectors_.front(), *evaluator_, settings_.newton, load_,
                               task, force, step);
  }

 private:
  /// Of a level's positions as they are.
  typename quasistatic::EquilibriumArray<double, Space>::Value evaluate_now(std::size_t level = 0) {
    Arrays& a = *arrays_[level];
    return evaluate_state(*on_, a, *linear_[level], *evaluator_, a.positions.const_view(), a.forces.view(), load_,
                          true);
  }
  /// What a solve that has nothing to do would say.
  [[nodiscard]] NewtonResult state_now() {
    const auto state = evaluate_now();
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
  [[nodiscard]] std::unique_ptr<PlaneArrays<Real, Space>> make_planes(std::size_t l, const MeshLevel& level,
                                                                      const std::vector<RigidPlane>& planes) const {
    using Planes = PlaneArrays<Real, Space>;
    if (l >= solved_) return std::make_unique<Planes>(level.mesh.nodes);
    const double per_area = settings_.plane_stiffness * settings_.youngs_modulus / arrays_[l]->spacing;
    return std::make_unique<Planes>(level, planes, per_area);
  }

  void store(Arrays& a, std::span<const Point> points) {
    elasticity::NodePositionArray<double> host(a.nodes());
    store_positions(points, host.view());
    on_->wait();
    copy(a.positions, host);
    copy(a.kept, host);
    synchronize();
  }

  void require_nodes(std::size_t level, std::size_t given) const {
    const index_t nodes = arrays_[level]->nodes();
    if (static_cast<index_t>(given) != nodes) {
      throw Error("level " + std::to_string(level) + " has " + std::to_string(nodes) + " nodes, and " +
                  std::to_string(given) + " were given");
    }
  }

  SolverSettings settings_;
  std::unique_ptr<On> on_;
  std::unique_ptr<Evaluator<On, Arrays>> evaluator_;
  std::vector<std::unique_ptr<Level>> linear_;   ///< finest first
  std::vector<std::unique_ptr<Arrays>> arrays_;  ///< of the levels on which equilibrium is solved
  std::vector<std::unique_ptr<Vectors>> vectors_;
  std::deque<typename On::Loop> loops_;
  std::vector<double> rounding_forces_;       ///< per level on which equilibrium is solved [N]
  std::vector<bool> moves_, all_prescribed_;  ///< any component or plane is moved by the load; every component is
  std::size_t solved_ = 1;
  double last_reaction_ = 0;  ///< at the last equilibrium [N]
  double load_ = 0;
  double coarser_load_ = std::numeric_limits<double>::quiet_NaN();  ///< of the coarser levels' equilibria
  bool reached_ = true;  ///< whether the positions are an equilibrium of load_
};

}  // namespace physgen::fem
