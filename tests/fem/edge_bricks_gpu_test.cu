// Products by bricks of nodes on CUDA.
#include <fem/kernels/edge_bricks_cuda.h>
#include <fem/kernels/symmetric_product_cuda.h>

#include <random>

#include "symmetric_product_checks.h"

namespace physgen::fem {
namespace {

/// Into the order of bricks.
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
void check_products_by_bricks() {
  constexpr unsigned stream = 13;
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> number(-1, 1);
  for (TetMesh& mesh : product_meshes()) {
    ProductScene<Real, Cuda, Aosoa<32>> scene(std::move(mesh), stream);
    std::vector<std::array<double, 3>> points(static_cast<std::size_t>(scene.mesh.nodes));
    for (auto& point : points) point = {number(random), number(random), number(random)};
    const EdgeBricks bricks(scene.mesh, points, SpaceKind::cuda);
    auto ordered = scene.edge_stiffness;
    for_each_edge(Cuda{}, bricks.view(), CopyEdgeStiffness{scene.edge_stiffness.const_view(), ordered.view()});
    const auto x = scene.displacements.const_view();
    const auto y = scene.differentials.view();
    parallel_for(Cuda{}, scene.mesh.nodes, MultiplyNodes{scene.node_stiffness.const_view(), x, y});
    add_edges(Cuda{}, BrickProduct{bricks.view(), ordered.const_view(), x, y});
    scene.expect_right();
  }
}

TEST(BrickProductOnCuda, agrees_with_the_sum_in_double) {
  if (!cuda_available()) GTEST_SKIP() << "no CUDA device";
  check_products_by_bricks<float>();
  check_products_by_bricks<double>();
}

}  // namespace
}  // namespace physgen::fem
