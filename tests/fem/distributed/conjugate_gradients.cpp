// conjugate_gradients: the solver's own, preconditioned by the inverses of nodes' blocks, over the stiffness of a cube
// of springs that resist in all directions, on as many ranks as it is started with. It prints a digest of the
// displacements, and what the recurrence ended with. The table of kernels is that of the scene quasistatic.
//
//   --cells N     along each side (default 20)
//   --table 0     the product has no rows in the table
#include <fem/mesh/mesh.h>
#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/arrays/packed_rows.h>
#include <fem/solver/elastic/tangent_blocks.h>
#include <fem/solver/linear/conjugate_gradients.h>
#include <fem/solver/linear/product_host.h>
#include <fem/solver/preconditioners/jacobi/preconditioner.h>
#include <physgen/distributed/executor.h>
#include <quasistatic.halos.h>

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

using namespace physgen;
using namespace physgen::fem;
using Real = float;

/// The product, which is done in place of a kernel over the nodes: see performs_in.h.
constexpr HaloUse product_rows[] = {
    {"physgen::fem::SymmetricProduct", 0, "K", {.reads_own = true}},
    {"physgen::fem::SymmetricProduct", 1, "E", {.reads_others = true}, "level.node_edge_entries.code"},
    {"physgen::fem::SymmetricProduct", 2, "nodes", {.reads_others = true}, "level.node_edge_entries.code"},
    {"physgen::fem::SymmetricProduct", 3, "dx", {.reads_own = true, .reads_others = true}, "level.edges.nodes"},
    {"physgen::fem::SymmetricProduct", 4, "df", {.reads_own = true, .writes_own = true}},
};

struct Level {
  quasistatic::NodeConstraintArray<Real> constraints;
  elasticity::EdgeArray<Real> edges;
  elasticity::IncidenceRangeArray<float> node_edge_ranges;
  quasistatic::PackedIncidenceArray<float> node_edge_entries;
  elasticity::NodeStiffnessArray<Real> node_stiffness, scaled_nodes;
  elasticity::EdgeStiffnessArray<Real> edge_stiffness;
  quasistatic::NodeScaleArray<Real> scales;
  quasistatic::NodeInverseArray<Real> inverse;
  elasticity::NodeForceDifferentialArray<Real> residual;
  elasticity::NodeDisplacementArray<Real> correction;
  EdgeSums sums;
  [[nodiscard]] index_t nodes() const { return constraints.size(); }
};
struct Krylov {
  quasistatic::LinearSolveArray<double> state{1};
  elasticity::NodeDisplacementArray<Real> step, direction;
  elasticity::NodeForceDifferentialArray<Real> residual, product;
};

/// A number of each object between -1 and 1.
float number(index_t object, int k) {
  auto bits = static_cast<std::uint32_t>(object) * 2654435761U + static_cast<std::uint32_t>(k) * 40503U;
  bits ^= bits >> 15;
  bits *= 2246822519U;
  return static_cast<float>(bits >> 8) / 8388608.0F - 1.0F;
}

struct Cube {
  Index cells;
  TetMesh mesh = make_box_mesh(cells, cells, cells);

  [[nodiscard]] bool is_fixed(index_t node) const { return node < (cells + 1) * (cells + 1); }
  [[nodiscard]] const auto& edge(index_t e) const { return mesh.edges[static_cast<std::size_t>(e)]; }
  [[nodiscard]] auto row(index_t node) const {
    std::vector<quasistatic::PackedIncidence<float>> row;
    const auto at = static_cast<std::size_t>(node);
    for (Index k = mesh.node_edges.first[at]; k < mesh.node_edges.first[at + 1]; ++k) {
      const IncidenceEntry& entry = mesh.node_edges.entries[static_cast<std::size_t>(k)];
      row.emplace_back().code = entry.element << NodeEdgeEntry::bits | entry.local;
    }
    return row;
  }
  /// Symmetric, and positive: dominant on the diagonal.
  [[nodiscard]] static auto stiffness(index_t edge) {
    elasticity::EdgeStiffness<Real> value{};
    for (int k = 0; k < 3; ++k) {
      value.E(k, k) = 2.0F + number(edge, k);
      value.E(k, (k + 1) % 3) = value.E((k + 1) % 3, k) = 0.25F * number(edge, 3 + k);
    }
    return value;
  }
};

void distribute(DistributedArrays& arrays, Level& level, Krylov& krylov, const Cube& cube) {
  const auto nodes = index_t{cube.mesh.nodes};
  for (const char* set : {"node", "edge_node", "block_node"}) arrays.add_set(set, nodes);
  arrays.add_set("edge", static_cast<index_t>(cube.mesh.edges.size()));
  arrays.same_set("edge_node", "node");
  arrays.same_set("block_node", "node");
  arrays.follow("edge", "node");
  arrays.add("level.constraints", "node", level.constraints);
  arrays.add("level.edges", "edge", level.edges);
  arrays.add("level.node_edge_ranges", "edge_node", level.node_edge_ranges);
  arrays.add("level.node_stiffness", "block_node", level.node_stiffness);
  arrays.add("level.edge_stiffness", "edge", level.edge_stiffness);
  arrays.add("level.scales", "node", level.scales);
  arrays.add("level.scaled_nodes", "edge_node", level.scaled_nodes);
  arrays.add("level.inverse", "block_node", level.inverse);
  arrays.add("level.residual", "node", level.residual);
  arrays.add("level.correction", "node", level.correction);
  arrays.add("krylov.step", "node", krylov.step);
  arrays.add("krylov.residual", "node", krylov.residual);
  arrays.add("krylov.direction", "node", krylov.direction);
  arrays.add("krylov.product", "node", krylov.product);
  arrays.connect(level.edges, "nodes", "node", [&](index_t e) { return cube.edge(e); });
  arrays.connect_rows(
      level.node_edge_ranges, "level.node_edge_entries", level.node_edge_entries, "code", "edge",
      [&](index_t node) { return cube.row(node); }, NodeEdgeEntry::bits);
  arrays.cut();
  arrays.fill(level.constraints, [&](index_t node) {
    quasistatic::NodeConstraint<Real> value{};
    value.fixed = cube.is_fixed(node) ? 7 : 0;
    return value;
  });
  arrays.fill(level.edge_stiffness, [](index_t edge) { return Cube::stiffness(edge); });
  arrays.fill(krylov.residual, [&](index_t node) {
    elasticity::NodeForceDifferential<Real> value{};
    for (int k = 0; k < 3 && !cube.is_fixed(node); ++k) value.df[k] = number(node, 7 + k);
    return value;
  });
  // The product goes by lists of the edges that are here.
  const LocalSet& edges = arrays.set("edge");
  std::vector<std::array<Index, 2>> ends(static_cast<std::size_t>(edges.size()));
  for (index_t e = edges.first(); e < edges.last(); ++e) {
    const Eigen::Vector2i nodes_of_edge = level.edges.const_view()[e].nodes();
    ends[static_cast<std::size_t>(e)] = {nodes_of_edge[0], nodes_of_edge[1]};
  }
  const bool has_edges = edges.first() < edges.last();
  level.sums = EdgeSums(static_cast<Index>(level.nodes()), ends, SpaceKind::host, sizeof(Real), SumOrder::fixed,
                        has_edges ? edges.first() : edges.size());
}

template <class On>
void solve(On& on, Level& level, Krylov& v) {
  on.run(level.nodes(), SumNodeStiffness{Rows(level.node_edge_ranges.const_view(), level.node_edge_entries.const_view(),
                                              level.edges.size()),
                                         level.edge_stiffness.const_view(), level.node_stiffness.view()});
  scale_nodes(on, level, false);
  typename On::Loop loop;
  const auto multiply = [&] {
    on.run(level.nodes(), TurnDirection{v.state.const_view(), level.scales.const_view(), level.correction.const_view(),
                                        level.node_stiffness.const_view(), v.direction.view(), v.product.view()});
    add_edges(on,
              SymmetricProduct{level.node_stiffness.const_view(), level.edge_stiffness.const_view(),
                               level.edges.const_view(), v.direction.const_view(), v.product.view()},
              level.sums);
  };
  conjugate_gradients(on, loop, level, v, 1e-6, 300, 0, multiply, [&] { BlockJacobi::apply(on, level); });
}

void run(int argc, char** argv) {
  const Ranks ranks(argc, argv);
  Index cells = 20;
  bool has_rows = true;
  for (int a = 1; a + 1 < argc; a += 2) {
    if (argv[a] == std::string("--cells")) cells = std::atoi(argv[a + 1]);
    if (argv[a] == std::string("--table")) has_rows = std::atoi(argv[a + 1]) != 0;
  }
  ranks.guard([&] {
    std::vector<HaloUse> rows(std::begin(scenes::quasistatic_scene::halos), std::end(scenes::quasistatic_scene::halos));
    if (has_rows) rows.insert(rows.end(), std::begin(product_rows), std::end(product_rows));
    const Cube cube{cells};
    Level level;
    Krylov krylov;
    DistributedArrays arrays(ranks, rows);
    distribute(arrays, level, krylov, cube);
    DistributedExecutor<HostExecutor> on(ranks, arrays, {.poisons_stale_ghosts = true});
    solve(on, level, krylov);
    const Traffic traffic = on.traffic();
    std::uint64_t hash = 0xcbf29ce484222325;
    arrays.each_block(krylov.step, [&](index_t /*first*/, auto view) {
      for (index_t i = 0; i < view.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
          const float dx = view[i].dx()[k];
          hash = (hash ^ std::bit_cast<std::uint32_t>(dx)) * 0x100000001b3;
        }
      }
    });
    const auto state = on.value(krylov.state);
    if (!ranks.is_first()) return;
    std::printf("digest %016llx iterations %d status %d rz %a alpha %a exchanges %lld bytes %lld gathers %lld",
                static_cast<unsigned long long>(hash), int{state.iterations}, int{state.status}, double{state.rz},
                double{state.alpha}, static_cast<long long>(traffic.exchanges), static_cast<long long>(traffic.bytes),
                static_cast<long long>(traffic.gathers));
    for (const std::string& kernel : on.unknown_kernels()) std::printf(" unknown %s", kernel.c_str());
    std::printf("\n");
  });
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
