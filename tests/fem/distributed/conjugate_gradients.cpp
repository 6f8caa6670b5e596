// conjugate_gradients: the solver's own, over the stiffness of a cube of springs that resist in all directions, on as
// many ranks as it is started with. It prints a digest of the displacements and of the norms of all iterations, what
// the recurrence ended with, and what crossed. The table of kernels is that of the scene quasistatic.
//
//   --cells N            along each side (default 20)
//   --coarsest N         cells of the coarsest level at least (default: there is one level)
//   --preconditioner P   jacobi (default) or multigrid
//   --replicate N        coarser levels of more nodes are cut, too, however few blocks ranks then have of them
//   --plain 1            by the solver's own levels in one process, without distributed arrays
//   --table 0            the product has no rows in the table
#include <fem/mesh/mesh.h>
#include <fem/solver/arrays/run_time_choices.h>
#include <fem/solver/elastic/tangent_blocks.h>
#include <fem/solver/levels/distributed_levels.h>
#include <fem/solver/levels/level_halos.h>
#include <fem/solver/linear/conjugate_gradients.h>
#include <fem/solver/linear/product_host.h>
#include <physgen/distributed/executor.h>
#include <quasistatic.halos.h>
#include <quasistatic.scene.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "digest.h"

namespace {

using namespace physgen;
using namespace physgen::fem;
using Real = float;
using Level = LevelOver<Real, Host, StoredAsComputed, AssembledOnMeshes,
                        scenes::quasistatic_scene::Level<Host, Real, StoredAsComputed>, NoArrays, NoArrays, NoArrays>;
using Levels = std::vector<std::unique_ptr<Level>>;
using Krylov = scenes::quasistatic_scene::Krylov<Host>;

/// Counts what a host would wait for, if the steps were those of a device.
struct CountingExecutor : HostExecutor {
  static inline int waits = 0;
  void wait() { ++waits; }
  template <class Array>
  [[nodiscard]] typename Array::Value value(const Array& array) {
    ++waits;
    return HostExecutor::value(array);
  }
};

/// A number of each object between -1 and 1.
float number(index_t object, int k) {
  auto bits = static_cast<std::uint32_t>(object) * 2654435761U + static_cast<std::uint32_t>(k) * 40503U;
  bits ^= bits >> 15;
  bits *= 2246822519U;
  return static_cast<float>(bits >> 8) / 8388608.0F - 1.0F;
}
/// Symmetric, and positive: dominant on the diagonal.
elasticity::EdgeStiffness<Real> stiffness(index_t edge) {
  elasticity::EdgeStiffness<Real> value{};
  for (int k = 0; k < 3; ++k) {
    value.E(k, k) = 2.0F + number(edge, k);
    value.E(k, (k + 1) % 3) = value.E((k + 1) % 3, k) = 0.25F * number(edge, 3 + k);
  }
  return value;
}

struct Options {
  Index cells = 20, coarsest = 0;
  bool is_multigrid = false, is_plain = false, has_rows = true;
  index_t replicate = 0;
};

/// Meshes of a cube that hangs on its base.
struct Cube {
  std::vector<MeshLevel> levels;
  std::vector<LevelGraph> graphs;

  explicit Cube(const Options& options)
      : levels(make_cube_levels(options.cells, 1, false, options.coarsest == 0 ? options.cells : options.coarsest)) {
    for (MeshLevel& level : levels) {
      for (std::size_t n = 0; n < level.rest.size(); ++n) level.fixed[n] = level.rest[n][2] == 0 ? 7 : 0;
    }
    graphs = make_level_graphs(levels);
  }
  [[nodiscard]] auto force(index_t node) const {
    elasticity::NodeForceDifferential<Real> value{};
    const bool is_fixed = levels.front().fixed[at(node)] != 0;
    for (int k = 0; k < 3 && !is_fixed; ++k) value.df[k] = number(node, 7 + k);
    return value;
  }
};

/// Adds the displacements of nodes.
void add(Digest& digest, const auto& view) {
  for (index_t i = 0; i < view.size(); ++i) {
    for (int k = 0; k < 3; ++k) digest.add(float{view[i].dx()[k]});
  }
}

/// @return a digest of the norms of all iterations
template <class On>
Digest solve(On& on, Levels& levels, Krylov& v, const Options& options, Traffic& before) {
  Level& level = *levels.front();
  const PreconditionerSettings settings;
  on.run(level.nodes(), SumNodeStiffness{level.node_edges.const_view(), level.edge_stiffness.const_view(),
                                         level.node_stiffness.view()});
  if (options.is_multigrid) {
    Multigrid::prepare(on, levels, 0, settings, true);
    Multigrid::prepare(on, levels, 0, settings, false);  // as a second step of Newton's method has it
  } else {
    BlockJacobi::prepare(on, levels, 0, settings, true);
  }
  if constexpr (requires { on.traffic(); }) before = on.traffic();
  typename On::Loop loop;
  Digest norms;
  const auto multiply = [&] {
    const auto state = v.state.const_view().get(index_t{0});
    for (const double x : {double{state.rz}, double{state.alpha}, double{state.beta}}) norms.add(x);
    on.run(level.nodes(), TurnDirection{v.state.const_view(), level.scales.const_view(), level.correction.const_view(),
                                        level.node_stiffness.const_view(), v.direction.view(), v.product.view()});
    add_edges(on,
              SymmetricProduct{level.node_stiffness.const_view(), level.edge_stiffness.const_view(),
                               level.edges.const_view(), v.direction.const_view(), v.product.view()},
              level.sums);
  };
  CountingExecutor::waits = 0;
  conjugate_gradients(on, loop, level, v, 1e-6, 300, 0, multiply, [&] {
    options.is_multigrid ? Multigrid::apply(on, levels, 0, settings) : BlockJacobi::apply(on, levels, 0, settings);
  });
  return norms;
}

void print(const Digest& digest, const Digest& norms, const auto& state) {
  std::printf("digest %s norms %s iterations %d status %d rz %a alpha %a", digest.text().c_str(), norms.text().c_str(),
              int{state.iterations}, int{state.status}, double{state.rz}, double{state.alpha});
}

void run_plain(const Options& options) {
  const Cube cube(options);
  Levels levels;
  for (std::size_t l = 0; l < cube.graphs.size(); ++l) {
    const LevelGraph* const coarser = l + 1 < cube.graphs.size() ? &cube.graphs[l + 1] : nullptr;
    levels.push_back(std::make_unique<Level>(cube.graphs[l], coarser));
  }
  Level& level = *levels.front();
  Krylov krylov;
  krylov.allocate({.node = level.nodes()});
  for (index_t e = 0; e < level.edge_count(); ++e) level.edge_stiffness.view().put(e, stiffness(e));
  for (index_t n = 0; n < level.nodes(); ++n) krylov.residual.view().put(n, cube.force(n));
  HostExecutor on;
  Traffic none;
  const Digest norms = solve(on, levels, krylov, options, none);
  Digest digest;
  add(digest, krylov.step.const_view());
  print(digest, norms, on.value(krylov.state));
  std::printf("\n");
}

/// The most of all ranks, on each of them.
index_t most_of_ranks(Transport& transport, index_t mine) {
  const std::vector<index_t> given(static_cast<std::size_t>(transport.count()), mine);
  return std::ranges::max(transport.all_to_all(given));
}

void run_on_ranks(const Ranks& ranks, const Options& options) {
  namespace table = scenes::quasistatic_scene;
  std::vector<HaloUse> rows = with_halos_of_levels(table::halos);
  if (!options.has_rows) {
    std::erase_if(rows, [](const HaloUse& row) { return row.kernel == "physgen::fem::SymmetricProduct"; });
  }
  const Cube cube(options);
  Levels levels;
  for (std::size_t l = 0; l < cube.graphs.size(); ++l) levels.push_back(std::make_unique<Level>(Level::Own()));
  Level& level = *levels.front();
  Krylov krylov;
  krylov.allocate({.node = 0});
  DistributedArrays arrays(ranks, rows);
  const auto replicated = options.replicate > 0 ? std::optional<index_t>(options.replicate) : std::nullopt;
  const std::size_t cut = levels_that_are_cut(cube.graphs, ranks.count(), replicated);
  add_levels(arrays, levels, cube.graphs, cut);
  arrays.add("krylov.step", "level[0].node", krylov.step);
  arrays.add("krylov.residual", "level[0].node", krylov.residual);
  arrays.add("krylov.direction", "level[0].node", krylov.direction);
  arrays.add("krylov.product", "level[0].node", krylov.product);
  arrays.cut();
  std::vector<EdgeSums> sums = fill_levels(arrays, levels, cube.graphs);
  for (std::size_t l = 0; l < sums.size(); ++l) levels[l]->sums = std::move(sums[l]);
  arrays.fill(level.edge_stiffness, [](index_t edge) { return stiffness(edge); });
  arrays.fill(krylov.residual, [&](index_t node) { return cube.force(node); });
  DistributedExecutor<CountingExecutor> on(ranks, arrays, {.poisons_stale_ghosts = true});
  const Traffic of_plans = on.traffic();
  Traffic before;
  const Digest norms = solve(on, levels, krylov, options, before);
  const Traffic traffic = on.traffic();
  const int waits = CountingExecutor::waits;
  Digest digest;
  arrays.each_block(krylov.step, [&](index_t /*first*/, auto view) { add(digest, view); });
  const auto state = on.value(krylov.state);
  const index_t bytes = most_of_ranks(arrays.transport(), traffic.bytes - before.bytes);
  const LocalSet& nodes = arrays.set("level[0].node");
  const index_t ghosts = most_of_ranks(arrays.transport(), static_cast<index_t>(nodes.ghosts().size()));
  if (!ranks.is_first()) return;
  print(digest, norms, state);
  const auto number_of = [](index_t n) { return static_cast<long long>(n); };
  std::printf(" prepared %lld %lld solved %lld %lld bytes %lld gathered %lld cut %zu ghosts %lld waits %d and %d",
              number_of(before.exchanges - of_plans.exchanges), number_of(before.gathers - of_plans.gathers),
              number_of(traffic.exchanges - before.exchanges), number_of(traffic.gathers - before.gathers),
              number_of(bytes), number_of(traffic.gathered_bytes - before.gathered_bytes), cut, number_of(ghosts),
              waits, CountingExecutor::waits - waits);
  for (const std::string& kernel : on.unknown_kernels()) std::printf(" unknown %s", kernel.c_str());
  std::printf("\n");
}

void run(int argc, char** argv) {
  Options options;
  for (int a = 1; a + 1 < argc; a += 2) {
    const std::string what = argv[a];
    if (what == "--cells") options.cells = std::atoi(argv[a + 1]);
    if (what == "--coarsest") options.coarsest = std::atoi(argv[a + 1]);
    if (what == "--preconditioner") options.is_multigrid = argv[a + 1] == std::string("multigrid");
    if (what == "--replicate") options.replicate = std::atoi(argv[a + 1]);
    if (what == "--plain") options.is_plain = std::atoi(argv[a + 1]) != 0;
    if (what == "--table") options.has_rows = std::atoi(argv[a + 1]) != 0;
  }
  if (options.is_plain) return run_plain(options);
  const Ranks ranks(argc, argv);
  ranks.guard([&] { run_on_ranks(ranks, options); });
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
