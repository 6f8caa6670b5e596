// The symmetric product on CUDA, in both orders of sums.
#include <fem/kernels/symmetric_product_cuda.h>

#include "symmetric_product_checks.h"

namespace physgen::fem {
namespace {

TEST(SymmetricProductOnCuda, with_atomics_agrees_with_the_sum_in_double) {
  if (!cuda_available()) GTEST_SKIP() << "no CUDA device";
  constexpr unsigned stream = 11;
  check_products<float, Cuda, Aosoa<32>>(SumOrder::any, stream);
  check_products<float, Cuda, Aos>(SumOrder::any, stream);
  check_products<double, Cuda, Aosoa<32>>(SumOrder::any, stream);
}

TEST(SymmetricProductOnCuda, in_fixed_order_agrees_with_the_sum_in_double_and_repeats_its_bits) {
  if (!cuda_available()) GTEST_SKIP() << "no CUDA device";
  constexpr unsigned stream = 11;
  check_products<float, Cuda, Aosoa<32>>(SumOrder::fixed, stream);
  check_products<float, Cuda, Soa>(SumOrder::fixed, stream);
  check_products<double, Cuda, Aosoa<32>>(SumOrder::fixed, stream);
}

TEST(SymmetricProductOnCuda, of_nodes_and_then_of_edges_has_the_bits_of_the_whole) {
  if (!cuda_available()) GTEST_SKIP() << "no CUDA device";
  for (TetMesh& mesh : product_meshes(SpaceKind::cuda)) {
    ProductScene<float, Cuda, Aosoa<32>> scene(std::move(mesh), 12);
    const EdgeSums sums(scene.mesh, SpaceKind::cuda, sizeof(float));
    const auto product = scene.product();
    multiply(Cuda{}, product, sums, SumOrder::fixed);
    const auto whole = scene.result();
    scene.poison();
    parallel_for(Cuda{}, scene.mesh.nodes,
                 MultiplyNodes{product.node_stiffness, product.displacements, product.differentials});
    add_edges(Cuda{}, product, sums, SumOrder::fixed);
    const auto in_two = scene.result();
    EXPECT_EQ(
        std::memcmp(whole.untyped().base, in_two.untyped().base, static_cast<std::size_t>(whole.untyped().bytes())), 0)
        << scene.mesh.nodes << " nodes";
  }
}

}  // namespace
}  // namespace physgen::fem
