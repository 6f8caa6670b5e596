// The scene force_chain on a CUDA device: see force_chain_case.h.
#include <physgen/cuda/executor.h>

#include "force_chain_case.h"

namespace physgen::test::force_chain {
namespace {

TEST(ForceChainOnCuda, gives_as_one_step_the_forces_that_its_kernels_give_one_by_one_over_ordinary_arrays) {
  if (!cuda_available()) GTEST_SKIP() << "no CUDA device here";
  CudaExecutor on(tets);
  expect_the_same_forces<float>(on);
  expect_the_same_forces<double>(on);
}

}  // namespace
}  // namespace physgen::test::force_chain
