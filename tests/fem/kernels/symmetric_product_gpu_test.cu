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

}  // namespace
}  // namespace physgen::fem
