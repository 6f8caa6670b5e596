// Bricks of nodes and the order of edges in them, against the mesh that they were made of.
#include <fem/kernels/edge_bricks.h>
#include <fem/mesh/renumber.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <algorithm>
#include <random>
#include <vector>

namespace physgen::fem {
namespace {

std::vector<std::array<double, 3>> scattered(Index nodes) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<std::array<double, 3>> points(static_cast<std::size_t>(nodes));
  for (auto& point : points) point = {number(random), 2 * number(random), number(random)};
  return points;
}

/// Visits edges as the threads of a warp do.
void expect_each_edge_once(const TetMesh& mesh, const EdgeBricks& bricks) {
  const EdgeBricks::View view = bricks.view();
  ASSERT_EQ(view.nodes, mesh.nodes);
  EXPECT_EQ(bricks.bytes(), EdgeBricks::bytes_for(mesh.nodes, index_t(mesh.edges.size())));
  std::vector<int> nodes(static_cast<std::size_t>(mesh.nodes), 0), edges(mesh.edges.size(), 0);
  EXPECT_EQ(view.places_begin(0), 0);
  EXPECT_EQ(view.places_begin(view.bricks), mesh.nodes);
  for (Index b = 0; b < view.bricks; ++b) {
    const Index from = view.places_begin(b), to = view.places_begin(b + 1);
    ASSERT_LE(to - from, view.bricks == 1 ? EdgeBricks::few_nodes : EdgeBricks::most_nodes);
    for (Index slice = from; slice < to; slice += EdgeBricks::slice) {
      Index place = view.begin[slice];
      const Index end = std::min(slice + EdgeBricks::slice, to);
      for (Index k = 0; place < view.begin[end]; ++k) {
        for (Index at = slice; at < end; ++at) {
          if (k >= view.begin[at + 1] - view.begin[at]) continue;
          const Index node = view.order[at], edge = view.first[node] + k, other = view.others[place++];
          ASSERT_LT(static_cast<std::size_t>(edge), mesh.edges.size());
          ++edges[static_cast<std::size_t>(edge)];
          ASSERT_LT(other < 0 ? ~other : 0, to - from);
          const Index end_of_edge = other < 0 ? view.order[from + ~other] : other;
          EXPECT_EQ(mesh.edges[static_cast<std::size_t>(edge)], (std::array<Index, 2>{node, end_of_edge}));
          const auto* begin = view.order + from;
          EXPECT_EQ(other < 0, std::find(begin, view.order + to, end_of_edge) != view.order + to) << "inside the brick";
        }
      }
    }
    for (Index at = from; at < to; ++at) ++nodes[static_cast<std::size_t>(view.order[at])];
  }
  EXPECT_EQ(std::ranges::count(nodes, 1), mesh.nodes);
  EXPECT_EQ(std::ranges::count(edges, 1), std::ssize(mesh.edges));
}

TEST(EdgeBricks, have_each_node_and_each_edge_once) {
  std::vector<TetMesh> meshes{make_tet_mesh(3, {}), make_tet_mesh(4, {{0, 1, 2, 3}}), make_box_mesh(9, 9, 9),
                              make_box_mesh(17, 11, 13)};
  meshes.push_back(renumbered(meshes.back(), random_numbering(meshes.back(), 5)));
  std::vector<std::array<Index, 4>> fan;
  for (Index n = 1; n + 2 < 2000; ++n) fan.push_back({0, n, n + 1, n + 2});
  meshes.push_back(make_tet_mesh(2000, fan));
  for (const TetMesh& mesh : meshes) {
    expect_each_edge_once(mesh, EdgeBricks(mesh, scattered(mesh.nodes), SpaceKind::host));
  }
}

TEST(EdgeBricks, of_a_box_have_most_edges_inside) {
  const TetMesh mesh = make_box_mesh(20, 20, 20);
  std::vector<std::array<double, 3>> points;
  for (int n = 0; n < mesh.nodes; ++n) points.push_back({double(n % 21), double(n / 21 % 21), double(n / 441)});
  const EdgeBricks bricks(mesh, points, SpaceKind::host);
  const EdgeBricks::View view = bricks.view();
  const auto inside =
      std::count_if(view.others, view.others + mesh.edges.size(), [](Index other) { return other < 0; });
  EXPECT_GT(static_cast<double>(inside), 0.65 * static_cast<double>(mesh.edges.size()));
}

TEST(EdgeBricks, refuse_positions_of_another_mesh) {
  EXPECT_THROW(EdgeBricks(make_box_mesh(2, 2, 2), scattered(26), SpaceKind::host), Error);
}

}  // namespace
}  // namespace physgen::fem
