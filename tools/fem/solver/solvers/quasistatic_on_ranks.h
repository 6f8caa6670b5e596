// The solver of several ranks over arrays in one space: see solver_on_ranks.h.
#pragma once

#include <fem/solver/levels/level_halos.h>
#include <fem/solver/solvers/nested_newton.h>
#include <fem/solver/solvers/part_of_equilibrium.h>
#include <fem/solver/solvers/require.h>
#include <fem/solver/solvers/solver_on_ranks.h>
#include <fem/solver/solvers/whole_body.h>
#include <quasistatic.halos.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace physgen::fem {

namespace detail {

[[nodiscard]] inline std::string in_brackets(std::size_t k) { return "[" + std::to_string(k) + "]"; }

/// The parts of a rank, and what runs steps over them.
template <class On>
struct PartOfRank {
  using Mesh = QuasistaticMesh<typename On::Space>;
  using Part = PartOfEquilibrium<WholeBody, QuasistaticBody<typename On::Space>>;
  std::vector<Mesh> coarser;
  scenes::quasistatic_scene::Stresses<typename On::Space> stressed;
  std::unique_ptr<Part> finest;
  std::unique_ptr<On> on;

  PartOfRank(const Ranks& ranks, WholeBody& whole, const DistributedOptions& options) : coarser(whole.coarser.size()) {
    const InStage stage("parts of ranks");
    const auto add_more = [&](auto& part) {
      part.arrays.add("stresses.of_tets", "tet", stressed.of_tets);
      for (std::size_t k = 0; k < coarser.size(); ++k) add(part.arrays, whole, k);
      for (std::size_t k = 0; k < coarser.size(); ++k) {
        add_parents(part.arrays, k == 0 ? part.patches : coarser[k - 1].patches, whole, k);
      }
    };
    finest = std::make_unique<Part>(ranks, table(), whole, whole.cut, add_more, [&whole] { whole.release_lists(); });
    finest->facts.all_prescribed = whole.facts.all_prescribed;
    for (std::size_t k = 0; k < coarser.size(); ++k) {
      Mesh& mesh = coarser[k];
      const MeshFacts& facts = whole.coarser[k].facts;
      fill_mesh(finest->arrays, mesh.body, mesh.krylov, whole.coarser[k].body,
                whole.listed.of(k + 1, whole.graphs[k + 1]).nodes);
      mesh.facts.rounding_force = facts.rounding_force;
      mesh.facts.moves = facts.moves;
      mesh.facts.all_prescribed = facts.all_prescribed;
      mesh.facts.chunks = {{0, mesh.body.tets.size(), 0, mesh.body.rest.size(), 0, mesh.body.edge_tet_ranges.size()}};
    }
    on = std::make_unique<On>(ranks, finest->arrays, options);
  }

 private:
  static HaloUses table() {
    static const std::vector<HaloUse> rows = with_halos_of_levels(scenes::quasistatic_scene::halos);
    return rows;
  }
  /// Mesh k + 1, which is cut, or which all ranks have.
  void add(DistributedArrays& arrays, const WholeBody& of, std::size_t k) {
    const QuasistaticMesh<Host>& whole = of.coarser[k];
    const ListedLevel listed = of.listed.levels[k + 1];
    const std::string number = in_brackets(k + 1), level = "level" + number, tet = "tet" + number,
                      patch = "patch" + number;
    Mesh& mesh = coarser[k];
    const MeshSets sets{level + ".node", tet, tet, tet};
    const auto add_set = [&](const std::string& set, index_t size) {
      if (k + 1 >= of.cut) return arrays.add_replicated_set(set, size);
      arrays.add_set(set, size);
      arrays.follow(set, sets.node);
    };
    add_set(tet, listed.tets.size);
    add_mesh(arrays, number, sets, mesh.body, mesh.chunk, mesh.krylov, whole.body, listed);
    add_edge_tets(arrays, number, level + ".edge", tet, mesh.body, whole.body, listed);
    if (whole.body.volumes.size() == 0) return;
    add_set(patch, listed.patches.size);
    add_patches(arrays, number, sets, patch, mesh.body, mesh.patches, whole.patches, listed);
    add_edge_patches(arrays, number, level + ".edge", patch, mesh.patches, whole.patches, listed);
  }
  /// Of the patches of mesh k, among those of the next coarser one.
  template <class Patches>
  static void add_parents(DistributedArrays& arrays, Patches& patches, const WholeBody& of, std::size_t k) {
    const auto& whole = k == 0 ? of.patches : of.coarser[k - 1].patches;
    const ListedObjects own = of.listed.levels[k].patches;
    if (whole.parents.size() == 0) return;
    const std::string number = k == 0 ? "" : in_brackets(k);
    arrays.add("patches" + number + ".parents", "patch" + number, patches.parents.contents());
    arrays.connect(patches.parents.contents(), "patch", "patch" + in_brackets(k + 1),
                   patch_of(whole.parents, own, of.listed.coarser[k].patches), own.known);
  }
};

}  // namespace detail

/// @tparam On DistributedExecutor
template <class On>
class QuasistaticOnRanks final : public SolverOnRanks,
                                 private detail::PartOfRank<On>,
                                 private NestedNewton<On, typename QuasistaticMesh<typename On::Space>::Types> {
  using Types = typename QuasistaticMesh<typename On::Space>::Types;
  using PartOfRank = detail::PartOfRank<On>;
  using Nested = NestedNewton<On, Types>;
  using Nested::all_prescribed_;
  using Nested::arrays_;
  using Nested::coarser_load_;
  using Nested::evaluate_now;
  using Nested::last_reaction_;
  using Nested::linear_;
  using Nested::load_;
  using Nested::loops_;
  using Nested::moves_;
  using Nested::reached_;
  using Nested::rounding_forces_;
  using Nested::solved_;
  using Nested::state_now;
  using Nested::vectors_;
  using PartOfRank::coarser;
  using PartOfRank::finest;
  using PartOfRank::on;
  using PartOfRank::stressed;
  using typename Nested::Arrays;
  using typename Nested::Level;
  using typename Nested::Vectors;
  using typename PartOfRank::Mesh;

 public:
  QuasistaticOnRanks(const Ranks& ranks, WholeBody whole, const SolverSettings& settings,
                     const DistributedOptions& options)
      : PartOfRank(ranks, whole, options),
        Nested(*PartOfRank::on, settings, Types::make_material(settings, whole.body.volumes.size() > 0),
               1 + whole.coarser.size()) {
    take(*finest);
    for (Mesh& mesh : coarser) take(mesh);
    for (std::size_t l = 0; l < finest->levels.size(); ++l) {
      linear_.push_back(std::make_unique<Level>(std::move(finest->levels[l])));
      linear_.back()->sums = std::move(finest->facts.sums[l]);
    }
  }

  NewtonResult solve_to(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) override {
    return Nested::solve_to(load, report);
  }
  void set_loading(const Loading& /*loading*/) override {
    throw Error("a solver on several ranks keeps the loading that it was made with; change loads in one process");
  }
  [[nodiscard]] double load() const override { return load_; }
  [[nodiscard]] std::vector<Point> positions() const override { return positions_of(0); }
  [[nodiscard]] std::vector<Point> forces() override { return forces_of(0); }
  [[nodiscard]] std::optional<NodeState> coarser_equilibrium() override {
    if (solved_ < 2 || coarser_load_ != load_ || !reached_) return std::nullopt;
    return NodeState{positions_of(1), forces_of(1), {}};
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override {
    Nested::evaluate_stresses(load_, stressed.of_tets);
    return of_all_ranks<9>(stressed.of_tets, [](const auto& tet, int k) -> double { return tet.P()[k]; });
  }
  [[nodiscard]] index_t bytes() const override {
    index_t sum = stressed.bytes();
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
    require_state(state, counts);
    for (std::size_t l = 0; l < arrays_.size(); ++l) {
      elasticity::NodePositionArray<double> all(static_cast<index_t>(state.positions[l].size()));
      store_positions(state.positions[l], all.view());
      for (auto* array : {&arrays_[l]->positions, &arrays_[l]->kept}) finest->arrays.fill(*array, all);
    }
    load_ = state.load;
    reached_ = state.is_equilibrium;
    coarser_load_ = reached_ ? load_ : std::numeric_limits<double>::quiet_NaN();
    last_reaction_ = reached_ ? state_now().reaction : 0.0;
  }

  [[nodiscard]] PartOfMesh part() const override {
    const auto ghosts = [](const LocalSet& set) { return static_cast<index_t>(set.ghosts().size()); };
    const LocalSet &nodes = objects_of(arrays_.front()->positions), &tets = objects_of(stressed.of_tets);
    return {nodes.owned(), ghosts(nodes), tets.owned(), ghosts(tets)};
  }
  [[nodiscard]] Traffic traffic() const override { return on->traffic(); }
  [[nodiscard]] std::string transport() const override {
    if constexpr (requires { on->transport_name(); }) return on->transport_name();
    return "MPI";
  }

 private:
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
    arrays.chunk_arrays = std::make_shared<decltype(Mesh::chunk)>(std::move(groups.chunk));
    if (arrays.volumes.size() > 0) {
      arrays.patches = std::make_unique<GroupOf<decltype(arrays.patches)>>(std::move(groups.patches));
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
  /// Numbers of all objects, on every rank. @param element element(object, k) is number k of an object
  template <std::size_t kCount, class Array, class Element>
  [[nodiscard]] std::vector<std::array<double, kCount>> of_all_ranks(const Array& array, const Element& element) const {
    on->wait();
    const LocalSet& objects = objects_of(array);
    const Runs& runs = objects.runs();
    std::vector<std::array<double, kCount>> mine(static_cast<std::size_t>(objects.owned()));
    const auto& on_host = physgen::detail::in_form_of<physgen::detail::OnHost<Array>>(array);
    const auto view = on_host.const_view();
    for (index_t i = objects.begin(); i < objects.end(); ++i) {
      for (std::size_t k = 0; k < kCount; ++k) {
        mine[static_cast<std::size_t>(i - objects.begin())][k] = element(view[i], static_cast<int>(k));
      }
    }
    if (runs.ranks() == 1) return mine;
    std::vector<std::array<double, kCount>> all(static_cast<std::size_t>(runs.size()));
    const auto window = index_t{1} << 24;  // of objects: MPI gathers less than 2 GiB at once
    const auto own = [&](int rank, index_t first, index_t last) {
      const index_t begin = runs.begin(rank), end = runs.end(rank);
      return std::pair{std::clamp(first, begin, end), std::clamp(last, begin, end)};
    };
    for (index_t first = 0; first < runs.size(); first += window) {
      const index_t last = std::min(first + window, runs.size());
      std::vector<index_t> sizes;
      for (int r = 0; r < runs.ranks(); ++r) {
        const auto [begin, end] = own(r, first, last);
        sizes.push_back((end - begin) * index_t{sizeof(mine[0])});
      }
      const auto [begin, end] = own(objects.rank(), first, last);
      const auto given = std::span(mine).subspan(static_cast<std::size_t>(begin - runs.begin(objects.rank())),
                                                 static_cast<std::size_t>(end - begin));
      const auto taken =
          std::span(all).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first));
      finest->arrays.transport().gather(std::as_bytes(given), sizes, std::as_writable_bytes(taken));
    }
    return all;
  }
};

/// In a build with CUDA: see solver_on_ranks.cu.
[[nodiscard]] std::unique_ptr<SolverOnRanks> make_cuda_solver_on_ranks(const Ranks& ranks, WholeBody whole,
                                                                       const SolverSettings& settings,
                                                                       const DistributedOptions& options);

}  // namespace physgen::fem
