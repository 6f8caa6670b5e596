// The symmetric product on the CPU.
#include <fem/kernels/symmetric_product_host.h>
#include <physgen/threads.h>

#include "symmetric_product_checks.h"

namespace physgen::fem {
namespace {

TEST(SymmetricProductOnHost, agrees_with_the_sum_in_double_and_repeats_its_bits) {
  constexpr unsigned stream = 11;
  check_products<float, Host, Aosoa<16>>(SumOrder::fixed, stream);
  check_products<float, Host, Soa>(SumOrder::any, stream);
  check_products<float, Host, Aos>(SumOrder::fixed, stream);
  check_products<double, Host, Aosoa<16>>(SumOrder::fixed, stream);
}

TEST(SymmetricProductOnHost, gives_the_same_bits_with_any_number_of_threads) {
  ProductScene<float, Host, Aosoa<16>> scene(make_box_mesh(20, 20, 20), 11);
  const EdgeSums sums(scene.mesh, SpaceKind::host, sizeof(float));
  set_threads(1);
  multiply(Host{}, scene.product(), sums, SumOrder::fixed);
  const auto alone = scene.result();
  set_threads(5);
  multiply(Host{}, scene.product(), sums, SumOrder::fixed);
  set_threads(0);
  const auto five = scene.result();
  EXPECT_EQ(std::memcmp(alone.untyped().base, five.untyped().base, static_cast<std::size_t>(alone.untyped().bytes())),
            0);
}

TEST(SymmetricProductOnHost, leaves_out_the_first_edges_where_these_stand_for_none) {
  constexpr index_t first = 41;
  ProductScene<float, Host, Aosoa<16>> scene(make_box_mesh(3, 3, 3), 11);
  EdgeList edges = scene.mesh.edges;
  for (std::size_t e = 0; e < first; ++e) edges[e] = {-1, -1};
  const EdgeSums sums(scene.mesh.nodes, edges, SpaceKind::host, sizeof(float), SumOrder::fixed, first);
  multiply(Host{}, scene.product(), sums, SumOrder::fixed);
  const auto without = scene.result();
  for (index_t e = 0; e < first; ++e) scene.edge_stiffness[e].E() = Eigen::Matrix3f(Eigen::Matrix3f::Zero());
  multiply(Host{}, scene.product(), EdgeSums(scene.mesh, SpaceKind::host, sizeof(float)), SumOrder::fixed);
  const auto zeroed = scene.result();
  for (index_t i = 0; i < without.size(); ++i) {
    for (int k = 0; k < 3; ++k) EXPECT_EQ(without.getdata(i, k), zeroed.getdata(i, k)) << "node " << i;
  }
}

std::string refused(const TetMesh& mesh) {
  try {
    const EdgeSums sums(mesh, SpaceKind::host, 4);
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(EdgeSums, refuses_edges_that_are_not_ascending) {
  TetMesh mesh = make_box_mesh(1, 1, 1);
  std::swap(mesh.edges[3], mesh.edges[4]);
  EXPECT_NE(refused(mesh).find("edge 4 of the mesh is not above the one before it"), std::string::npos)
      << refused(mesh);
}

TEST(EdgeSums, refuses_edges_of_nodes_that_are_not_there) {
  TetMesh mesh = make_tet_mesh(4, {{0, 1, 2, 3}});
  mesh.edges.back() = {3, 4};
  EXPECT_NE(refused(mesh).find("edge 5 of the mesh is (3, 4); edges (m, n) must have 0 <= m < n < 4"),
            std::string::npos)
      << refused(mesh);
  mesh.edges = {{-1, 0}};
  EXPECT_NE(refused(mesh).find("edge 0 of the mesh is (-1, 0)"), std::string::npos) << refused(mesh);
}

TEST(SymmetricProductOnHost, refuses_arrays_of_another_size_and_leaves_the_result) {
  ProductScene<float, Host, Aosoa<16>> scene(make_box_mesh(2, 2, 2), 11);
  const EdgeSums sums(scene.mesh, SpaceKind::host, sizeof(float));
  scene.displacements.resize(26);
  try {
    multiply(Host{}, scene.product(), sums, SumOrder::fixed);
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "physgen: a symmetric product over 27 objects was given displacements of 26; resize that array");
  }
  EXPECT_TRUE(scene.result().view().get(0).df.hasNaN()) << "the poison";
}

}  // namespace
}  // namespace physgen::fem
