// Products by slices of nodes on CUDA, by one thread block.
#include <fem/kernels/edge_slices_cuda.h>
#include <fem/kernels/symmetric_product_cuda.h>

#include "symmetric_product_checks.h"

namespace physgen::fem {
namespace {

/// Into the order of slices.
template <class FromView, class ToView>
struct CopyEdgeStiffness {
  FromView from;
  ToView to;
  __device__ void operator()(index_t edge, index_t place) const {
    const Matrix3<typename ToView::Precision> E = from[edge].E();
    to[place].E() = E;
  }
};
template <class... Views>
CopyEdgeStiffness(Views...) -> CopyEdgeStiffness<Views...>;

template <class Real>
void check_products_by_slices() {
  constexpr unsigned stream = 13;
  std::vector<TetMesh> meshes = product_meshes();
  meshes.push_back(make_box_mesh(9, 9, 9));  // 1000 nodes
  meshes.push_back(renumbered(meshes.back(), random_numbering(meshes.back(), 5)));
  for (TetMesh& mesh : meshes) {
    if (mesh.nodes > EdgeSlices::most_nodes) continue;
    ProductScene<Real, Cuda, Aosoa<32>> scene(std::move(mesh), stream);
    const EdgeSlices slices(scene.mesh, SpaceKind::cuda);
    auto ordered = scene.edge_stiffness;
    for_each_edge(Cuda{}, slices.view(), CopyEdgeStiffness{scene.edge_stiffness.const_view(), ordered.view()});
    const auto x = scene.displacements.const_view();
    const auto y = scene.differentials.view();
    parallel_for(Cuda{}, scene.mesh.nodes, MultiplyNodes{scene.node_stiffness.const_view(), x, y});
    add_edges(Cuda{}, SliceProduct{slices.view(), ordered.const_view(), x, y});
    scene.expect_right();
  }
}

TEST(SliceProductOnCuda, agrees_with_the_sum_in_double) {
  if (!cuda_available()) GTEST_SKIP() << "no CUDA device";
  check_products_by_slices<float>();
  check_products_by_slices<double>();
}

}  // namespace
}  // namespace physgen::fem
