// Checks of the symmetric product on random blocks, the same for CPU and CUDA.
#pragma once

#include <elasticity.physgen.h>
#include <fem/kernels/symmetric_product.h>
#include <fem/mesh/mesh_arrays.h>
#include <fem/mesh/renumber.h>
#include <fem/reference/random.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <cstring>
#include <vector>

#include "reference.h"

namespace physgen::fem {

/// A mesh with random blocks and displacements, the arrays of a product, and what it should give.
template <class Real, class Space, class EdgeLayout>
struct ProductScene {
  template <class Object, class Layout>
  using HostArray = Array<Object, Real, Host, Layout, FormatsOf<Object, Host>>;

  TetMesh mesh;
  elasticity::NodeStiffnessArray<Real, Space> node_stiffness;
  Array<elasticity::EdgeStiffnessObject, Real, Space, EdgeLayout> edge_stiffness;
  elasticity::EdgeArray<Real, Space> edges;
  elasticity::NodeDisplacementArray<Real, Space> displacements;
  elasticity::NodeForceDifferentialArray<Real, Space> differentials;
  std::vector<Eigen::Vector3d> expected;
  std::vector<double> sizes;  ///< sums of the magnitudes that were added

  ProductScene(TetMesh mesh_, unsigned stream) : mesh(std::move(mesh_)) {
    reference::Random random(stream);
    const auto nodes = static_cast<std::size_t>(mesh.nodes);
    elasticity::NodeStiffnessArray<Real> host_nodes(mesh.nodes);
    elasticity::EdgeStiffnessArray<Real> host_blocks(static_cast<index_t>(mesh.edges.size()));
    elasticity::EdgeArray<Real> host_edges(host_blocks.size());
    elasticity::NodeDisplacementArray<Real> host_displacements(mesh.nodes);
    const auto number = [&random] { return Real(random.normal()); };
    store_edges(mesh, host_edges.view());
    for (index_t n = 0; n < mesh.nodes; ++n) {
      for (int k = 0; k < 6; ++k) host_nodes.view()[n].K()[k] = number();
      for (int k = 0; k < 3; ++k) host_displacements.view()[n].dx()[k] = number();
    }
    for (index_t e = 0; e < host_blocks.size(); ++e) {
      for (int k = 0; k < 9; ++k) host_blocks.view()[e].E()[k] = number();
    }
    expected.assign(nodes, Eigen::Vector3d::Zero());
    sizes.assign(nodes, 0);
    const auto add = [this](index_t node, const Eigen::Matrix3d& block, const Eigen::Vector3d& dx) {
      expected[static_cast<std::size_t>(node)] += block * dx;
      sizes[static_cast<std::size_t>(node)] += (block.cwiseAbs() * dx.cwiseAbs()).sum();
    };
    const auto dx = [&](index_t n) {
      return Eigen::Vector3d(host_displacements.view().get(n).dx.template cast<double>());
    };
    for (index_t n = 0; n < mesh.nodes; ++n) add(n, host_nodes.view().get(n).K.template cast<double>(), dx(n));
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      const Eigen::Matrix3d E = host_blocks.view().get(static_cast<index_t>(e)).E.template cast<double>();
      const auto [m, n] = mesh.edges[e];
      add(m, E, dx(n));
      add(n, E.transpose(), dx(m));
    }
    const auto upload = [](auto& to, const auto& from) {
      to.resize(from.size());
      copy(to, from);
    };
    upload(node_stiffness, host_nodes);
    upload(edge_stiffness, host_blocks);
    upload(edges, host_edges);
    upload(displacements, host_displacements);
    differentials.resize(mesh.nodes);
    poison();
  }

  void poison() {
    elasticity::NodeForceDifferentialArray<Real> host(mesh.nodes);
    for (index_t n = 0; n < mesh.nodes; ++n) {
      for (int k = 0; k < 3; ++k) host.view()[n].df()[k] = std::numeric_limits<Real>::quiet_NaN();
    }
    copy(differentials, host);
    synchronize();
  }
  [[nodiscard]] auto product() {
    return SymmetricProduct{node_stiffness.const_view(), edge_stiffness.const_view(), edges.const_view(),
                            displacements.const_view(), differentials.view()};
  }
  [[nodiscard]] elasticity::NodeForceDifferentialArray<Real> result() const {
    elasticity::NodeForceDifferentialArray<Real> host(mesh.nodes);
    copy(host, differentials);
    synchronize();
    return host;
  }
  void expect_right() const {
    constexpr double eps = std::numeric_limits<Real>::epsilon();
    const auto host = result();
    for (index_t n = 0; n < mesh.nodes; ++n) {
      const auto at = static_cast<std::size_t>(n);
      const Eigen::Vector3d df = host.view().get(n).df.template cast<double>();
      ASSERT_LE((df - expected[at]).cwiseAbs().maxCoeff(), 4 * eps * sizes[at]) << "node " << n;
    }
  }
};

/// Meshes whose edges meet in different ways: none, one tet, boxes, numbered at random (nodes with no edge as m, nodes
/// with many); on a GPU also such of more nodes than it has threads for at once.
inline std::vector<TetMesh> product_meshes(SpaceKind space = SpaceKind::host) {
  std::vector<TetMesh> meshes;
  meshes.push_back(make_tet_mesh(3, {}));
  meshes.push_back(make_tet_mesh(4, {{0, 1, 2, 3}}));
  meshes.push_back(make_box_mesh(3, 4, 5));
  meshes.push_back(make_box_mesh(17, 11, 13));
  meshes.push_back(renumbered(meshes.back(), random_numbering(meshes.back(), 5)));
  if (space == SpaceKind::cuda) {
    meshes.push_back(make_box_mesh(61, 62, 63));
    meshes.push_back(renumbered(meshes.back(), random_numbering(meshes.back(), 6)));
  }
  // One node in all tets: more edges than are multiplied at a time, on CUDA to more nodes than shared memory has room
  // for.
  const Index nodes = space == SpaceKind::cuda ? 10000 : 2000;
  std::vector<std::array<Index, 4>> fan;
  for (Index n = 1; n + 2 < nodes; ++n) fan.push_back({0, n, n + 1, n + 2});
  meshes.push_back(make_tet_mesh(nodes, fan));
  return meshes;
}

template <class Real, class Space, class EdgeLayout>
void check_products(SumOrder order, unsigned stream) {
  for (TetMesh& mesh : product_meshes(Space::kind)) {
    ProductScene<Real, Space, EdgeLayout> scene(std::move(mesh), stream);
    const EdgeSums sums(scene.mesh, Space::kind, sizeof(Real));
    multiply(Space{}, scene.product(), sums, order);
    scene.expect_right();
    if (order == SumOrder::any) continue;
    const auto first = scene.result();
    for (int run = 0; run < 5; ++run) {
      scene.poison();
      multiply(Space{}, scene.product(), sums, order);
      const auto again = scene.result();
      EXPECT_EQ(
          std::memcmp(first.untyped().base, again.untyped().base, static_cast<std::size_t>(first.untyped().bytes())), 0)
          << "the same bits on every run";
    }
  }
}

}  // namespace physgen::fem
