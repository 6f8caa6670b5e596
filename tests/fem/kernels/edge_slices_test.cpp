// Slices of nodes and the order of edges in them, against the mesh that they were made of.
#include <fem/kernels/edge_slices.h>
#include <fem/mesh/renumber.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <algorithm>
#include <vector>

namespace physgen::fem {
namespace {

/// Visits edges as the threads of warps do.
void expect_each_edge_once(const TetMesh& mesh) {
  const EdgeSlices slices(mesh, SpaceKind::host);
  const EdgeSlices::View view = slices.view();
  ASSERT_EQ(view.nodes, mesh.nodes);
  EXPECT_EQ(slices.bytes(), EdgeSlices::bytes_for(mesh.nodes, index_t(mesh.edges.size())));
  std::vector<int> visits(mesh.edges.size(), 0);
  for (Index slice = 0; slice < view.nodes; slice += EdgeSlices::slice) {
    const Index end = std::min(slice + EdgeSlices::slice, view.nodes);
    Index place = view.first[slice];
    for (Index k = 0; place < view.first[end]; ++k) {
      for (Index node = slice; node < end; ++node) {
        const Index edge = view.first[node] + k;
        if (edge >= view.first[node + 1]) continue;
        ++visits[static_cast<std::size_t>(edge)];
        const std::array<Index, 2> ends{node, view.others[place++]};
        EXPECT_EQ(mesh.edges[static_cast<std::size_t>(edge)], ends);
      }
    }
  }
  EXPECT_EQ(std::ranges::count(visits, 1), std::ssize(mesh.edges));
}

TEST(EdgeSlices, have_each_edge_once) {
  const TetMesh box = make_box_mesh(9, 9, 9);
  std::vector<std::array<Index, 4>> fan;
  for (Index n = 1; n + 2 < 500; ++n) fan.push_back({0, n, n + 1, n + 2});
  for (const TetMesh& mesh : {make_tet_mesh(3, {}), make_tet_mesh(4, {{0, 1, 2, 3}}), make_box_mesh(3, 4, 5), box,
                              renumbered(box, random_numbering(box, 5)), make_tet_mesh(500, fan)}) {
    expect_each_edge_once(mesh);
  }
}

TEST(EdgeSlices, refuse_more_nodes_than_a_thread_block_has_room_for) {
  EXPECT_THROW(EdgeSlices(make_box_mesh(10, 9, 9), SpaceKind::host), Error);
}

}  // namespace
}  // namespace physgen::fem
