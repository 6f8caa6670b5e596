// Programs over the executor of CUDA, whose loops the device decides on; or the host, for tools that cannot follow.
#include <physgen/cuda/executor.h>

#include <cstdlib>

#include "executor_checks.h"
#include "gpu_fixture.h"

namespace physgen {
namespace {

class CudaExecutorTest : public test::GpuTest {};

TEST_F(CudaExecutorTest, loops_end_when_done_or_after_their_rounds) {
  CudaExecutor on(5000);
  check_loops(on);
}

TEST_F(CudaExecutorTest, loops_on_the_host_do_the_same) {
  ASSERT_EQ(setenv("PHYSGEN_LOOPS_ON_HOST", "1", 1), 0);
  CudaExecutor on(5000);
  unsetenv("PHYSGEN_LOOPS_ON_HOST");
  check_loops(on);
}

TEST_F(CudaExecutorTest, values_are_of_one_object) {
  CudaExecutor on(1);
  check_values(on);
}

}  // namespace
}  // namespace physgen
