// The rows of nodes with their edges, against the mesh that they were made of, and products by them on the CPU.
#include <fem/kernels/edge_rows.h>
#include <physgen/executor.h>

#include <algorithm>
#include <vector>

#include "edge_rows_checks.h"

namespace physgen::fem {
namespace {

TEST(EdgeRows, name_the_other_end_of_each_edge_of_a_node) {
  for (const TetMesh& mesh : product_meshes()) {
    const EdgeRows rows(mesh, SpaceKind::host);
    const EdgeRows::View view = rows.view();
    ASSERT_EQ(view.nodes, mesh.nodes);
    EXPECT_EQ(rows.bytes(), EdgeRows::bytes_for(mesh.nodes, index_t(mesh.edges.size())));
    std::vector<std::vector<Index>> expected(static_cast<std::size_t>(mesh.nodes));
    for (const auto& [m, n] : mesh.edges) {
      expected[static_cast<std::size_t>(m)].push_back(n);
      expected[static_cast<std::size_t>(n)].push_back(m);
    }
    for (Index node = 0; node < mesh.nodes; ++node) {
      std::vector<Index> found(view.others + view.first[node], view.others + view.first[node + 1]);
      std::ranges::sort(found);
      std::ranges::sort(expected[static_cast<std::size_t>(node)]);
      EXPECT_EQ(found, expected[static_cast<std::size_t>(node)]) << "node " << node;
    }
  }
}

TEST(RowProductOnHost, agrees_with_the_sum_in_double_and_repeats_its_bits) {
  HostExecutor on;
  check_products_by_rows<float, Host>(on);
  check_products_by_rows<double, Host>(on);
}

}  // namespace
}  // namespace physgen::fem
