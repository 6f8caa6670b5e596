// Products by rows of nodes on CUDA, a row by eight lanes.
#include <fem/solver/preconditioners/multigrid/small_levels_cuda.h>

#include "edge_rows_checks.h"

namespace physgen::fem {
namespace {

TEST(RowProductOnCuda, agrees_with_the_sum_in_double_and_repeats_its_bits) {
  if (!cuda_available()) GTEST_SKIP() << "no CUDA device";
  CudaExecutor on(1);
  check_products_by_rows<float, Cuda>(on);
  check_products_by_rows<double, Cuda>(on);
}

}  // namespace
}  // namespace physgen::fem
