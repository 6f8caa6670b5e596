// The solver of linear elastic bodies on several ranks.
#include <fem/solver/elastic/rest_shapes.h>
#include <fem/solver/levels/level_halos.h>
#include <fem/solver/levels/listed_mesh.h>
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/in_precision.h>
#include <fem/solver/solvers/linear_solves.h>
#include <fem/solver/solvers/linear_types.h>
#include <fem/solver/solvers/named_of_ranks.h>
#include <fem/solver/solvers/numbers_of_ranks.h>
#include <fem/solver/solvers/part_of_equilibrium.h>
#include <fem/solver/solvers/require.h>
#include <fem/solver/solvers/solvers_on_ranks.h>
#include <linear_elastic.halos.h>
#include <linear_elastic_assembled.halos.h>

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace physgen::fem {

namespace {

using On = DistributedExecutor<HostExecutor>;

template <bool kAssembled>
[[nodiscard]] HaloUses table() {
  static const std::vector<HaloUse> rows = kAssembled
                                               ? with_halos_of_levels(scenes::linear_elastic_assembled_scene::halos)
                                               : with_halos_of_levels(scenes::linear_elastic_scene::halos);
  return rows;
}

/// What a rank has of a linear elastic body.
/// @tparam Types as LinearSolves takes it
template <class Types>
struct PartOfLinear {
  static constexpr bool assembled = Types::Level::Choices::assembled;
  mutable DistributedArrays arrays;  // const functions, too, send messages by it
  typename Types::Body body;
  typename Types::Vectors vectors;
  std::vector<typename Types::Level::Own> levels;
  std::vector<EdgeSums> sums;
  elasticity::StressArray<double> stresses_of_tets;

  PartOfLinear(const Ranks& ranks, const std::vector<MeshLevel>& given, const Loading& loading,
               const SolverSettings& settings, std::optional<index_t> replicated)
      : arrays(ranks, table<assembled>()) {
    const std::size_t used = used_levels(settings, given.size(), given.size()).used;
    std::vector<index_t> nodes;
    for (const MeshLevel& level : given) nodes.push_back(level.mesh.nodes);
    const std::size_t cut = levels_cut_by_solver(nodes, settings, ranks.count(), replicated);
    const PartOfLevels part = part_of_levels(std::span(given).first(used), cut, ranks.rank(), ranks.count(), assembled);
    const MeshLevel& whole = given.front();
    const MeshLevel& here = part.levels.empty() ? whole : part.levels.front();
    levels.resize(used);
    const ListedLevel listed = part.listed.levels.front();
    arrays.add_set("node", listed.nodes.size);
    arrays.add_set("tet", listed.tets.size);
    arrays.follow("tet", "node");
    const EdgeParts parts = assembled ? make_edge_parts(here, part.graphs.front()) : EdgeParts{};
    if constexpr (assembled) {
      add_levels(arrays, each_level(), part.graphs, cut, part.listed);
      arrays.same_set("node", "level[0].node");
      arrays.add("linear.edge_tet_ranges", "level[0].edge", body.edge_tet_ranges.contents());
      add_rows<EdgeTetEntry>("linear.edge_tets", body.edge_tet_ranges, body.edge_tets, parts.edge_tets, listed.edges,
                             listed.tets);
    } else {
      add_level_by_tets(arrays, "", "node", levels.front());
    }
    add_body(here.mesh, listed);
    arrays.cut();
    arrays.fill(body.rest.contents(), [&, shapes = host_rest_shapes(here)](index_t tet) {
      return shapes.const_view().get(listed.tets.here(tet));
    });
    fill_loading(arrays, body.motion, body.loads, whole.fixed, loading.motion, loading.forces);
    body.state.resize(1);
    vectors.state.resize(1);
    if constexpr (assembled) {
      sums = fill_levels(arrays, each_level(), part.graphs, part.listed);
    } else {
      fill_level_by_tets(arrays, levels.front(), part.graphs.front(), listed.nodes);
    }
  }

 private:
  [[nodiscard]] std::vector<typename Types::Level::Own*> each_level() {
    std::vector<typename Types::Level::Own*> each;
    for (auto& level : levels) each.push_back(&level);
    return each;
  }
  template <class Packing, class Ranges, class Entries, class List>
  void add_rows(const char* name, Ranges& ranges, Entries& entries, const List& list, const ListedObjects& rows,
                const ListedObjects& tets) {
    arrays.connect_rows(
        ranges.contents(), name, entries.contents(), "code", "tet",
        detail::packed_row_of<Packing>(list, rows, tets.size, "tets",
                                       [before = static_cast<Index>(tets.offset)](Index /*local*/) { return before; }),
        Packing::bits, rows.known);
  }
  /// Adds and connects the arrays of the body. @param mesh what this rank's lists have of the whole mesh
  void add_body(const TetMesh& mesh, const ListedLevel& listed) {
    arrays.add("linear.tets", "tet", body.tets.contents());
    arrays.add("linear.rest", "tet", body.rest.contents());
    arrays.add("linear.node_tet_ranges", "node", body.node_tet_ranges.contents());
    arrays.add("linear.displacements", "node", body.displacements);
    arrays.add("linear.motion", "node", body.motion.contents());
    arrays.add("linear.loads", "node", body.loads.contents());
    arrays.add("linear.forces", "node", body.forces);
    arrays.add("krylov.step", "node", vectors.step);
    arrays.add("krylov.residual", "node", vectors.residual);
    arrays.add("krylov.direction", "node", vectors.direction);
    arrays.add("krylov.product", "node", vectors.product);
    arrays.add("stresses.of_tets", "tet", stresses_of_tets);
    arrays.connect(body.tets.contents(), "nodes", "node", nodes_of_tets(mesh, listed), listed.tets.known);
    add_rows<NodeTetEntry>("linear.node_tets", body.node_tet_ranges, body.node_tets, mesh.node_tets, listed.nodes,
                           listed.tets);
  }
};

template <class Types>
class LinearOnRanks final : public SolverOnRanks, private PartOfLinear<Types>, private LinearSolves<On, Types> {
  using Part = PartOfLinear<Types>;
  using Solves = LinearSolves<On, Types>;
  using Part::arrays;
  using Part::stresses_of_tets;
  using Solves::body_;
  using Solves::lame_;
  using Solves::linear_;
  using Solves::load_;
  using Solves::on_;
  using Solves::vectors_;
  using typename Solves::Level;

 public:
  LinearOnRanks(const Ranks& ranks, const std::vector<MeshLevel>& levels, const Loading& loading,
                const SolverSettings& settings, std::optional<index_t> replicated, const DistributedOptions& options)
      : Part(ranks, levels, loading, settings, replicated),
        Solves(std::make_unique<On>(ranks, arrays, options), settings,
               rounding_force(settings, levels.front(), loading.motion, false,
                              mean_spacing(levels.front().mesh, levels.front().rest))),
        fixed_(levels.front().fixed),
        rest_(ranks.is_first() ? levels.front().rest : std::vector<Point>()) {
    body_ = std::move(this->body);
    vectors_ = std::move(this->vectors);
    for (std::size_t l = 0; l < this->levels.size(); ++l) {
      linear_.push_back(std::make_unique<Level>(std::move(this->levels[l])));
      linear_.back()->assembled = Part::assembled;
      if constexpr (Part::assembled) linear_.back()->sums = std::move(this->sums[l]);
    }
  }

  NewtonResult solve_to(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) override {
    const SolverState before = state();
    const NewtonResult result = Solves::solve_from_rest(load, report);
    if (result.status != NewtonStatus::converged) restore(before);  // load() is that of an equilibrium
    return result;
  }
  void set_loading(const Loading& loading) override {
    require_next_loading(loading, fixed_.size(), false, {});
    fill_loading(arrays, body_.motion, body_.loads, fixed_, loading.motion, loading.forces);
  }
  [[nodiscard]] double load() const override { return load_; }
  [[nodiscard]] std::vector<Point> positions() const override {
    std::vector<Point> x = of_all_ranks<3>(arrays, body_.displacements, displacement);
    for (std::size_t n = 0; n < x.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) x[n][k] += rest_[n][k];
    }
    return x;
  }
  [[nodiscard]] std::vector<Point> forces() override {
    compute_forces(0);
    return of_all_ranks<3>(arrays, body_.forces, force);
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override {
    compute_stresses();
    return of_all_ranks<9>(arrays, stresses_of_tets, stress);
  }
  [[nodiscard]] index_t bytes() const override { return Solves::bytes() + stresses_of_tets.bytes(); }

  [[nodiscard]] SolverState state() const override { return {load_, true, {positions()}}; }
  void restore(const SolverState& state) override {
    std::vector<Point> u;
    if (arrays.ranks().is_first()) {
      require_state(state, std::array{rest_.size()});
      u = state.positions[0];
      for (std::size_t n = 0; n < u.size(); ++n) {
        for (std::size_t k = 0; k < 3; ++k) u[n][k] -= rest_[n][k];
      }
    }
    fill_from_first_rank(arrays, body_.displacements, u, [](auto& node, int k) -> auto& { return node.dx[k]; });
    load_ = state.load;
  }

  [[nodiscard]] std::vector<Index> nodes_of_levels() const override { return {static_cast<Index>(fixed_.size())}; }
  [[nodiscard]] std::vector<Point> positions_of(std::size_t /*level*/, std::span<const Index> nodes) const override {
    std::vector<Point> x = named_of_ranks<3>(arrays, body_.displacements, nodes, displacement);
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) x[i][k] += rest_[static_cast<std::size_t>(nodes[i])][k];
    }
    return x;
  }
  [[nodiscard]] std::vector<Point> forces_of(std::size_t /*level*/, std::span<const Index> nodes) const override {
    return named_of_ranks<3>(arrays, body_.forces, nodes, force);
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses_of(std::span<const Index> tets) const override {
    return named_of_ranks<9>(arrays, stresses_of_tets, tets, stress);
  }
  void compute_forces(std::size_t /*level*/) override { (void)Solves::evaluate(load_); }
  void compute_stresses() override { compute_linear_stresses(*on_, body_, lame_, stresses_of_tets); }

  [[nodiscard]] PartOfMesh part() const override {
    return part_of(arrays.objects_of(body_.displacements), arrays.objects_of(stresses_of_tets));
  }
  [[nodiscard]] Traffic traffic() const override { return on_->traffic(); }
  [[nodiscard]] std::string transport() const override { return transport_of(*on_); }
  [[nodiscard]] std::vector<std::string> unknown_kernels() const override { return unknown_kernels_of(*on_); }
  [[nodiscard]] Traffic traffic_of_iteration() override {
    const SolverState before = state();
    const Traffic sent =
        fem::traffic_of_iteration(*on_, arrays, body_.forces, [&](int count) { (void)Solves::solve_once(0, count); });
    restore(before);
    return sent;
  }

 private:
  static constexpr auto displacement = [](const auto& node, int k) -> double { return node.dx()[k]; };
  static constexpr auto force = [](const auto& node, int k) -> double { return node.f()[k]; };
  static constexpr auto stress = [](const auto& tet, int k) -> double { return tet.P()[k]; };

  std::vector<std::uint8_t> fixed_;  ///< of all nodes
  std::vector<Point> rest_;          ///< of all nodes, on the first rank
};

}  // namespace

std::unique_ptr<SolverOnRanks> make_linear_elastic_on_ranks(const Ranks& ranks, const std::vector<MeshLevel>& levels,
                                                            const Loading& loading, const SolverSettings& given,
                                                            std::optional<index_t> replicated,
                                                            const DistributedOptions& options) {
  SolverSettings settings = given;
  settings.nested = false;
  return in_precision(settings.precision, [&]<class Real, class Stored>() -> std::unique_ptr<SolverOnRanks> {
    using Assembled = LinearAssembledArrays<Real, Host, Stored>;
    using ByTets = LinearByTetsArrays<Real, Host>;  // which store no matrices
    if (settings.newton.product == Product::assembled) {
      return std::make_unique<LinearOnRanks<Assembled>>(ranks, levels, loading, settings, replicated, options);
    }
    return std::make_unique<LinearOnRanks<ByTets>>(ranks, levels, loading, settings, replicated, options);
  });
}

}  // namespace physgen::fem
