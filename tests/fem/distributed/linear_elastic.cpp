// linear_elastic: the steps of the scenes linear_elastic, with block Jacobi, and linear_elastic_assembled, with
// multigrid over meshes that halve cells, for a cube that is pressed between plates, on as many ranks as it is started
// with.
//
//   --cells N      along each side (default 12)
//   --levels N     assembled, over so many meshes at most (default 1: by tets, of irregular ones)
//   --replicate N  coarser meshes of more nodes are cut, too
//   --ordinary 1   one process by the solver's ordinary way
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/newton/linear_steps.h>
#include <fem/solver/preconditioners/make_linear_levels.h>
#include <fem/solver/solvers/linear_body.h>
#include <fem/solver/solvers/linear_types.h>
#include <linear_elastic.halos.h>
#include <linear_elastic_assembled.halos.h>

#include <memory>
#include <vector>

#include "newton_runs.h"

namespace {

using namespace physgen;
using namespace physgen::fem;

/// What a rank has of it, or all.
template <class Types>
struct Linear {
  static constexpr bool assembled = Types::Level::Choices::assembled;
  typename Types::Body body;
  std::vector<std::unique_ptr<typename Types::Level>> levels;
  typename Types::Vectors vectors;
  elasticity::StressArray<double> stresses;
};

template <class Types>
struct Whole : Linear<Types> {
  std::vector<LevelGraph> graphs;

  Whole(const Body& given, const SolverSettings& settings) {
    LevelsInUse used = levels_in_use(given.levels, settings);
    graphs = make_level_graphs(used.levels, this->assembled);
    this->levels = make_linear_levels<typename Types::Level>(used, settings);
    fill_linear_body(this->body, given.levels.front(), graphs.front(), given.loading, this->assembled);
    this->vectors.allocate({.node = graphs.front().nodes});
    this->stresses = elasticity::StressArray<double>(this->body.tets.size());
  }
};

template <class Types>
struct Part : Linear<Types> {
  DistributedArrays arrays;

  Part(const Ranks& ranks, HaloUses table, const Whole<Types>& whole, std::optional<index_t> replicated)
      : arrays(ranks, table) {
    auto& body = this->body;
    const index_t nodes = whole.graphs.front().nodes;
    for (const char* set : {"node", "block_node"}) arrays.add_set(set, nodes);
    arrays.add_set("tet", whole.body.tets.size());
    arrays.same_set("block_node", "node");
    arrays.follow("tet", "node");
    for (std::size_t l = 0; l < whole.levels.size(); ++l) {
      this->levels.push_back(std::make_unique<typename Types::Level>(typename Types::Level::Own()));
    }
    auto& level = *this->levels.front();
    if constexpr (Linear<Types>::assembled) {
      add_levels(arrays, this->levels, whole.graphs, levels_that_are_cut(whole.graphs, ranks.count(), replicated));
      arrays.same_set("node", "level[0].node");
      arrays.add("linear.edge_tet_ranges", "level[0].edge", body.edge_tet_ranges.contents());
      arrays.connect_rows(body.edge_tet_ranges.contents(), "linear.edge_tets", body.edge_tets.contents(), "code", "tet",
                          rows_of(whole.body.edge_tet_ranges, whole.body.edge_tets), EdgeTetEntry::bits);
    } else {
      level.assembled = false;
      arrays.add("level.constraints", "node", level.constraints.contents());
      arrays.add("level.node_stiffness", "block_node", level.node_stiffness);
      arrays.add("level.scales", "node", level.scales);
      arrays.add("level.inverse", "block_node", level.inverse);
      arrays.add("level.residual", "node", level.residual);
      arrays.add("level.correction", "node", level.correction);
    }
    arrays.add("linear.tets", "tet", body.tets.contents());
    arrays.add("linear.rest", "tet", body.rest.contents());
    arrays.add("linear.node_tet_ranges", "node", body.node_tet_ranges.contents());
    arrays.add("linear.displacements", "node", body.displacements);
    arrays.add("linear.motion", "node", body.motion.contents());
    arrays.add("linear.loads", "node", body.loads.contents());
    arrays.add("linear.forces", "node", body.forces);
    arrays.add("krylov.step", "node", this->vectors.step);
    arrays.add("krylov.residual", "node", this->vectors.residual);
    arrays.add("krylov.direction", "node", this->vectors.direction);
    arrays.add("krylov.product", "node", this->vectors.product);
    arrays.add("stresses.of_tets", "tet", this->stresses);
    arrays.connect(body.tets.contents(), "nodes", "node", nodes_of<4>(whole.body.tets));
    arrays.connect_rows(body.node_tet_ranges.contents(), "linear.node_tets", body.node_tets.contents(), "code", "tet",
                        rows_of(whole.body.node_tet_ranges, whole.body.node_tets), NodeTetEntry::bits);
    arrays.cut();
    arrays.fill(body.rest.contents(), whole.body.rest);
    arrays.fill(body.motion.contents(), whole.body.motion);
    arrays.fill(body.loads.contents(), whole.body.loads);
    body.state = whole.body.state;
    this->vectors.state.resize(1);
    if constexpr (Linear<Types>::assembled) {
      std::vector<EdgeSums> sums = fill_levels(arrays, this->levels, whole.graphs);
      for (std::size_t l = 0; l < sums.size(); ++l) this->levels[l]->sums = std::move(sums[l]);
    } else {
      arrays.fill(level.constraints.contents(), whole.levels.front()->constraints);
    }
  }
};

/// Two loads, with what a scene's program does of each. @param then called behind each solve
template <class On, class Types, class Then>
void solve_for(On& on, Linear<Types>& linear, bool is_first, const NewtonSettings& settings, const Then& then) {
  const LameParameters lame = lame_parameters(1e4, 0.45, "linear elasticity");
  typename On::Loop loop;
  for (const double load : {0.5, 1.0}) {
    auto& level = *linear.levels.front();
    begin_linear(on, linear.body, level, lame, load);
    if constexpr (Linear<Types>::assembled) {
      if (load == 0.5) prepare_linear(on, linear.body, linear.levels, lame, settings.preconditioner);
      solve_linear(on, loop, linear.body, linear.levels, linear.vectors, settings, 1e-6);
    } else {
      if (load == 0.5) prepare_linear_nodes(on, linear.body, level, lame);
      solve_linear_matrix_free(on, loop, linear.body, level, linear.vectors, lame, true, 1e-6, 1000);
    }
    evaluate_linear(on, linear.body, level, lame, load);
    measure_smallest_ratio(on, linear.body);
    compute_linear_stresses(on, linear.body, lame, linear.stresses);
    const auto solve = on.value(linear.vectors.state);
    const auto state = on.value(linear.body.state);
    if (is_first) {
      std::printf("load iterations %d status %d rz %a energy %a %a free %a fixed %a smallest %a\n",
                  int{solve.iterations}, int{solve.status}, double{solve.rz}, double{state.elastic},
                  double{state.loads}, double{state.free_square}, double{state.fixed_square},
                  double{state.smallest_ratio});
    }
    then();
  }
}
template <class Each, class Types>
void print_digests(const Digests<Each>& digests, const Linear<Types>& linear) {
  digests.print("displacements", linear.body.displacements,
                [](const auto& node, int k) -> double { return node.dx()[k]; });
  digests.print("forces", linear.body.forces, [](const auto& node, int k) -> double { return node.f()[k]; });
  for (int row = 0; row < 3; ++row) {
    digests.print("stresses", linear.stresses, [row](const auto& tet, int k) -> double { return tet.P()(row, k); });
  }
}

template <class Types>
void run(const Ranks& ranks, const Body& body, const SolverSettings& settings, HaloUses table,
         std::optional<index_t> replicated, bool is_ordinary) {
  Whole<Types> whole(body, settings);
  if (is_ordinary) {
    HostExecutor on;
    solve_for<HostExecutor, Types>(on, whole, true, settings.newton, [] {});
    return print_digests(Digests{true, [](const auto& array, const auto& visit) { visit(array.const_view()); }}, whole);
  }
  Part<Types> part(ranks, table, whole, replicated);
  DistributedExecutor<HostExecutor> on(ranks, part.arrays, {.poisons_stale_ghosts = true});
  Traffic before = on.traffic();
  solve_for<DistributedExecutor<HostExecutor>, Types>(on, part, ranks.is_first(), settings.newton, [&] {
    const Traffic now = on.traffic() - before;
    before = on.traffic();
    if (!ranks.is_first()) return;
    std::printf("traffic exchanges %lld gathers %lld\n", static_cast<long long>(now.exchanges),
                static_cast<long long>(now.gathers));
  });
  const auto each = [&](const auto& array, const auto& visit) {
    part.arrays.each_block(array, [&](index_t /*first*/, const auto& view) { visit(view); });
  };
  print_digests(Digests{ranks.is_first(), each}, part);
  if (!ranks.is_first()) return;
  for (const std::string& kernel : on.unknown_kernels()) std::printf("unknown %s\n", kernel.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const auto levels = static_cast<std::size_t>(asked(argc, argv, "--levels", 1));
  const auto most = replicated(asked(argc, argv, "--replicate", 0));
  return run_as_asked(argc, argv, [&](const Ranks& ranks, Index cells, bool /*patches*/, bool ordinary) {
    SolverSettings settings = settings_of_the_cube();
    const Body body = pressed_cube(cells, false, levels);
    if (levels > 1) {
      settings.newton.preconditioner.kind = Preconditioner::multigrid;
      run<LinearAssembledArrays<float, Host, StoredAsComputed>>(
          ranks, body, settings, with_halos_of_levels(scenes::linear_elastic_assembled_scene::halos), most, ordinary);
    } else {
      settings.newton.product = Product::matrix_free;
      run<LinearByTetsArrays<float, Host>>(ranks, body, settings,
                                           with_halos_of_levels(scenes::linear_elastic_scene::halos), most, ordinary);
    }
  });
}
