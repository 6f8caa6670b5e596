// The stiffness as a sparse matrix of Eigen.
#include <fem/kernels/sparse_stiffness.h>
#include <fem/materials/neo_hookean.h>
#include <gtest/gtest.h>
#include <physgen/parallel_for.h>

#include "kernel_scene.h"

namespace physgen::fem {
namespace {

template <class Layout>
using Scene = KernelScene<KernelCase<float, Host, Layout, NeoHookean>>;

template <class Layout>
void check_product() {
  Scene<Layout> scene(5);
  scene.run_all(NeoHookean<float>{3, 7});
  const auto K =
      sparse_stiffness(scene.node_stiffness.const_view(), scene.edge_stiffness.const_view(), scene.edges.const_view());
  const index_t nodes = scene.nodes();
  ASSERT_EQ(K.rows(), 3 * nodes);
  EXPECT_EQ(K.nonZeros(), 9 * (nodes + 2 * scene.edges.size()));
  EXPECT_EQ((K - Eigen::SparseMatrix<double>(K.transpose())).norm(), 0) << "symmetric to the last bit";
  Eigen::VectorXd dx(3 * nodes);
  for (index_t v = 0; v < nodes; ++v)
    dx.segment<3>(3 * v) = scene.displacements.view().get(v).dx.template cast<double>();
  const Eigen::VectorXd df = K * dx, bound = K.cwiseAbs() * dx.cwiseAbs();
  for (index_t v = 0; v < nodes; ++v) {
    const Eigen::Vector3d product = scene.assembled.view().get(v).df.template cast<double>();
    EXPECT_LE((product - df.segment<3>(3 * v)).norm(), 40 * Scene<Layout>::eps * bound.segment<3>(3 * v).norm())
        << "node " << v;
    EXPECT_GT(product.norm(), 0);
  }
}

TEST(SparseStiffness, gives_the_product_of_the_kernels_in_every_layout) {
  check_product<Aos>();
  check_product<Soa>();
  check_product<Aosoa<16>>();
}

struct Blocks {
  elasticity::NodeStiffnessArray<double> nodes{2};
  elasticity::EdgeStiffnessArray<double> blocks{1};
  elasticity::EdgeArray<double> edges{1};

  Blocks() {
    nodes.view()[0].K() = Eigen::Matrix3d::Identity();
    nodes.view()[1].K() = 2 * Eigen::Matrix3d::Identity();
    blocks.view()[0].E() = (Eigen::Matrix3d() << 0, 1, 2, 3, 4, 5, 6, 7, 8).finished();
    edges.view()[0].nodes() = Eigen::Vector2i(1, 0);
  }
  [[nodiscard]] std::string refused() const {
    try {
      static_cast<void>(sparse_stiffness(nodes.const_view(), blocks.const_view(), edges.const_view()));
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing was thrown";
  }
};

TEST(SparseStiffness, has_the_block_of_an_edge_in_the_row_of_its_first_node) {
  const Blocks given;
  const Eigen::MatrixXd K =
      sparse_stiffness(given.nodes.const_view(), given.blocks.const_view(), given.edges.const_view());
  const Eigen::Matrix3d E = given.blocks.const_view().get(0).E;
  EXPECT_EQ((K.block<3, 3>(3, 0)), E);
  EXPECT_EQ((K.block<3, 3>(0, 3)), E.transpose());
  EXPECT_EQ((K.block<3, 3>(3, 3)), 2 * Eigen::Matrix3d::Identity());
}

TEST(SparseStiffness, refuses_edges_of_nodes_that_are_not_there_and_blocks_of_another_number) {
  Blocks given;
  given.edges.view()[0].nodes() = Eigen::Vector2i(0, 2);
  EXPECT_NE(given.refused().find("edge 0 is (0, 2), and there are 2 nodes"), std::string::npos) << given.refused();
  given.blocks.resize(3);
  EXPECT_NE(given.refused().find("there are 1 edges and 3 blocks of edges; give one block for each edge"),
            std::string::npos)
      << given.refused();
}

TEST(SparseStiffness, refuses_more_entries_than_its_indices_can_number) {
  const Blocks given;
  const auto call = [&] {
    return sparse_stiffness<double, signed char>(given.nodes.const_view(), given.blocks.const_view(),
                                                 given.edges.const_view());
  };
  EXPECT_EQ(call().nonZeros(), 36);
  elasticity::NodeStiffnessArray<double> many(15);
  const auto too_many = [&] {
    return sparse_stiffness<double, signed char>(many.const_view(), given.blocks.const_view(),
                                                 given.edges.const_view());
  };
  EXPECT_THROW(static_cast<void>(too_many()), Error);
}

}  // namespace
}  // namespace physgen::fem
