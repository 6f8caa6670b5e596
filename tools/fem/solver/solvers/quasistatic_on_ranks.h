// The solver of several ranks over arrays in one space: see solver_on_ranks.h.
#pragma once

#include <fem/solver/solvers/nested_newton.h>
#include <fem/solver/solvers/part_of_rank.h>
#include <fem/solver/solvers/require.h>
#include <fem/solver/solvers/solver_on_ranks.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace physgen::fem {

/// @tparam On DistributedExecutor @tparam Scene of a row of PHYSGEN_EQUILIBRIUM_SCENES, or EverythingOnRanks
template <class On, class Scene = scenes::quasistatic>
class QuasistaticOnRanks final : public SolverOnRanks,
                                 private detail::PartOfRank<On, Scene>,
                                 private NestedNewton<On, typename QuasistaticMesh<typename On::Space, Scene>::Types> {
  using Types = typename QuasistaticMesh<typename On::Space, Scene>::Types;
  using PartOfRank = detail::PartOfRank<On, Scene>;
  using Nested = NestedNewton<On, Types>;
  using Nested::all_prescribed_;
  using Nested::arrays_;
  using Nested::coarser_load_;
  using Nested::evaluate_now;
  using Nested::evaluator_;
  using Nested::last_reaction_;
  using Nested::linear_;
  using Nested::load_;
  using Nested::loops_;
  using Nested::moves_;
  using Nested::plane_contacts_of;
  using Nested::reached_;
  using Nested::rounding_forces_;
  using Nested::settings_;
  using Nested::solved_;
  using Nested::state_now;
  using Nested::vectors_;
  using PartOfRank::coarser;
  using PartOfRank::finest;
  using PartOfRank::on;
  using PartOfRank::stresses_of_tets;
  using typename Nested::Arrays;
  using typename Nested::Level;
  using typename Nested::Vectors;
  using typename PartOfRank::Mesh;

 public:
  QuasistaticOnRanks(const Ranks& ranks, WholeBody<Scene> whole, const SolverSettings& settings,
                     const DistributedOptions& options)
      : PartOfRank(ranks, whole, options),
        Nested(*PartOfRank::on, settings, Types::make_material(settings, whole.body.volumes.size() > 0),
               1 + whole.coarser.size()),
        is_first_(ranks.is_first()),
        fixed_(std::move(whole.fixed)),
        parents_(std::move(whole.parents)) {
    take(*finest);
    for (Mesh& mesh : coarser) take(mesh);
    for (std::size_t l = 0; l < finest->levels.size(); ++l) {
      linear_.push_back(std::make_unique<Level>(std::move(finest->levels[l])));
      linear_.back()->is_grid = whole.graphs[l].is_grid;
      linear_.back()->lies_in_grid = !whole.graphs[l].grid_parents.empty();
      if constexpr (Level::Choices::assembled) {
        linear_.back()->sums = std::move(finest->facts.sums[l]);
        linear_.back()->rows = std::move(finest->facts.rows[l]);
      } else {
        linear_.back()->assembled = false;
      }
    }
    if constexpr (may_have<decltype(Level::planes)>) {
      for (std::size_t l = 0; l < PartOfRank::planes.size(); ++l) {
        linear_[l]->planes = std::make_unique<GroupOf<decltype(Level::planes)>>(std::move(PartOfRank::planes[l]));
        if (l <= coarser.size())
          linear_[l]->planes->per_area = (l == 0 ? finest->facts : coarser[l - 1].facts).plane_stiffness;
      }
      has_planes_ = !PartOfRank::planes.empty();
    }
    reached_ = !has_planes_;  // planes may push at rest
  }

  NewtonResult solve_to(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) override {
    return Nested::solve_to(load, report);
  }
  void set_loading(const Loading& loading) override {
    require_next_loading(loading, fixed_.front().size(), has_planes_, {});
    std::vector<Point> motion = loading.motion, forces = loading.forces;
    for (std::size_t l = 0; l < arrays_.size(); ++l) {
      const LoadingOfNodes all(fixed_[l], motion, forces);
      finest->arrays.fill(arrays_[l]->loads.contents(), all.loads);
      finest->arrays.fill(arrays_[l]->motion.contents(), all.motion);
      if (l + 1 < arrays_.size()) {
        coarsen_loading(parents_[l], static_cast<Index>(fixed_[l + 1].size()), motion, forces);
      }
    }
    reached_ = false;
  }
  [[nodiscard]] double load() const override { return load_; }
  [[nodiscard]] std::vector<Point> positions() const override { return positions_of(0); }
  [[nodiscard]] std::vector<Point> forces() override { return forces_of(0); }
  [[nodiscard]] std::optional<NodeState> coarser_equilibrium() override {
    if (solved_ < 2 || coarser_load_ != load_ || !reached_) return std::nullopt;
    return NodeState{positions_of(1), forces_of(1), plane_contacts_of(1)};
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override {
    Nested::evaluate_stresses(load_, stresses_of_tets);
    return of_all_ranks<9>(stresses_of_tets, [](const auto& tet, int k) -> double { return tet.P()[k]; });
  }
  [[nodiscard]] std::vector<PlaneContact> plane_contacts() override { return plane_contacts_of(0); }
  [[nodiscard]] index_t bytes() const override {
    index_t sum = stresses_of_tets.bytes();
    for (const auto& level : linear_) sum += level->bytes();
    for (const auto& arrays : arrays_) sum += arrays->bytes() + arrays->chunk_arrays->bytes();
    for (const auto& vectors : vectors_) sum += vectors->bytes();
    return sum;
  }

  [[nodiscard]] SolverState state() const override {
    SolverState state;
    state.load = load_;
    state.is_equilibrium = reached_;
    for (std::size_t l = 0; l < arrays_.size(); ++l) state.positions.push_back(positions_of(l));
    return state;
  }
  void restore(const SolverState& state) override {
    std::vector<std::size_t> counts;
    for (const auto& a : arrays_)
      counts.push_back(static_cast<std::size_t>(objects_of(a->rest.contents()).runs().size()));
    if (is_first_) require_state(state, counts);
    for (std::size_t l = 0; l < arrays_.size(); ++l) {
      const LocalSet& objects = objects_of(arrays_[l]->rest.contents());
      const std::vector<Point> here =
          of_first_rank(objects, is_first_ ? std::span(state.positions[l]) : std::span<const Point>());
      const auto position = [&](index_t node) {
        typename std::remove_cvref_t<decltype(arrays_[l]->positions)>::Value value{};
        for (int k = 0; k < 3; ++k) {
          value.x[k] = here[static_cast<std::size_t>(objects.local(node))][static_cast<std::size_t>(k)];
        }
        return value;
      };
      for (auto* array : {&arrays_[l]->positions, &arrays_[l]->kept}) finest->arrays.fill(*array, position);
    }
    load_ = state.load;
    reached_ = state.is_equilibrium;
    coarser_load_ = reached_ ? load_ : std::numeric_limits<double>::quiet_NaN();
    last_reaction_ = reached_ ? state_now().reaction : 0.0;
  }

  [[nodiscard]] PartOfMesh part() const override {
    const auto ghosts = [](const LocalSet& set) { return static_cast<index_t>(set.ghosts().size()); };
    const LocalSet &nodes = objects_of(arrays_.front()->positions), &tets = objects_of(stresses_of_tets);
    std::set<int> neighbours;
    for (const index_t ghost : nodes.ghosts()) neighbours.insert(nodes.runs().owner(ghost));
    return {nodes.owned(), ghosts(nodes), tets.owned(), ghosts(tets), static_cast<int>(neighbours.size())};
  }
  [[nodiscard]] Traffic traffic() const override { return on->traffic(); }
  [[nodiscard]] std::string transport() const override {
    if constexpr (requires { on->transport_name(); }) return on->transport_name();
    return "MPI";
  }
  [[nodiscard]] Traffic traffic_of_iteration() override {
    Arrays& a = *arrays_.front();
    Level& level = *linear_.front();
    Vectors& v = *vectors_.front();
    const PreconditionerSettings& preconditioner = settings_.newton.preconditioner;
    (void)evaluate_now(0, load_);
    form_tangent(*on, a, level, *evaluator_, TangentFilter::none, load_);
    prepare_tangent(*on, a, linear_, 0, preconditioner, true);
    const auto of_iterations = [&](int count) {
      finest->arrays.fill(a.forces, [](index_t node) {  // any that are not 0
        typename std::remove_cvref_t<decltype(a.forces)>::Value value{};
        for (int k = 0; k < 3; ++k) value.f[k] = 1 + static_cast<double>((3 * node + k) % 7);
        return value;
      });
      on->run(a.nodes(),
              BeginResidual{a.forces.const_view(), level.constraints.const_view(), false, v.residual.view()});
      const Traffic before = on->traffic();
      typename On::Loop loop;
      solve(*on, loop, a, linear_, 0, v, preconditioner, 0, count);
      on->wait();
      return on->traffic() - before;
    };
    (void)of_iterations(2);  // fields cross more than once before ranks know what all steps read
    const Traffic two = of_iterations(2);
    return of_iterations(3) - two;
  }

 private:
  /// Of all nodes of a mesh.
  struct LoadingOfNodes {
    elasticity::NodeDisplacementArray<double> motion;
    elasticity::NodeForceArray<double> loads;
    LoadingOfNodes(std::span<const std::uint8_t> fixed, const std::vector<Point>& moved,
                   const std::vector<Point>& forces)
        : motion(static_cast<index_t>(fixed.size())), loads(static_cast<index_t>(fixed.size())) {
      store_loading(*this, fixed, moved, forces);
    }
  };
  bool is_first_, has_planes_ = false;
  // As WholeBody has them.
  std::vector<std::vector<std::uint8_t>> fixed_;
  std::vector<std::vector<std::array<Index, 2>>> parents_;

  template <class Array>
  [[nodiscard]] const LocalSet& objects_of(const Array& array) const {
    return finest->arrays.objects_of(array);
  }
  template <class Groups>
  void take(Groups& groups) {
    const MeshFacts& facts = groups.facts;
    arrays_.push_back(std::make_unique<Arrays>(std::move(groups.body)));
    Arrays& arrays = *arrays_.back();
    arrays.chunks = facts.chunks;
    arrays.materials = groups.materials;
    arrays.chunk_arrays = std::make_shared<decltype(Mesh::chunk)>(std::move(groups.chunk));
    if constexpr (may_have<decltype(arrays.patches)>) {
      if (arrays.volumes.size() > 0) {
        arrays.patches = std::make_unique<GroupOf<decltype(arrays.patches)>>(std::move(groups.patches));
      }
    }
    vectors_.push_back(std::make_unique<Vectors>(std::move(groups.krylov)));
    loops_.emplace_back();
    rounding_forces_.push_back(facts.rounding_force);
    moves_.push_back(facts.moves);
    all_prescribed_.push_back(facts.all_prescribed);
  }
  [[nodiscard]] std::vector<Point> positions_of(std::size_t level) const {
    return of_all_ranks<3>(arrays_[level]->positions, [](const auto& node, int k) -> double { return node.x()[k]; });
  }
  [[nodiscard]] std::vector<Point> forces_of(std::size_t level) {
    (void)evaluate_now(level, load_);
    return of_all_ranks<3>(arrays_[level]->forces, [](const auto& node, int k) -> double { return node.f()[k]; });
  }
  /// Numbers of all objects, by blocks of them, on the first rank; none on others.
  /// @param element element(object, k) is number k of an object
  template <std::size_t kCount, class Array, class Element>
  [[nodiscard]] std::vector<std::array<double, kCount>> of_all_ranks(const Array& array, const Element& element) const {
    on->wait();
    std::vector<std::array<double, kCount>> all;
    finest->arrays.each_block(array, [&](index_t first, const auto& view) {
      if (first == 0) all.reserve(static_cast<std::size_t>(objects_of(array).runs().size()));
      for (index_t i = 0; i < view.size(); ++i) {
        std::array<double, kCount>& numbers = all.emplace_back();
        for (std::size_t k = 0; k < kCount; ++k) numbers[k] = element(view[i], static_cast<int>(k));
      }
    });
    return all;
  }
  /// Of what the first rank has of all objects, that of those that are here, by local numbers.
  [[nodiscard]] std::vector<Point> of_first_rank(const LocalSet& objects, std::span<const Point> all) const {
    constexpr index_t most = (index_t{64} << 20) / index_t{sizeof(Point)};
    Transport& transport = finest->arrays.transport();
    std::vector<Point> here(static_cast<std::size_t>(objects.size())), window;
    index_t local = objects.first();
    for (index_t first = 0; first < objects.runs().size(); first += most) {
      const index_t last = std::min(first + most, objects.runs().size());
      window.resize(static_cast<std::size_t>(last - first));
      std::vector<index_t> sizes(static_cast<std::size_t>(transport.count()), 0);
      sizes.front() = static_cast<index_t>(std::as_bytes(std::span(window)).size());
      const auto given = all.empty() ? all : all.subspan(static_cast<std::size_t>(first), window.size());
      transport.gather(std::as_bytes(given), sizes, std::as_writable_bytes(std::span(window)));
      for (; local < objects.last() && objects.global(local) < last; ++local) {
        here[static_cast<std::size_t>(local)] = window[static_cast<std::size_t>(objects.global(local) - first)];
      }
    }
    return here;
  }
};

}  // namespace physgen::fem
