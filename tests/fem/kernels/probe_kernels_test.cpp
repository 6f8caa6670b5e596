// The uses that g++ finds in the kernels, as programs on the CPU have them: one object at a time and in packs.
#include "probe_kernels.h"

namespace physgen::fem::test {
namespace {

TEST(ProbesOfKernels, find_what_the_kernels_say_on_the_host) {
  ProbeExecutor<Host> on;
  run_all_kernels(on);
  EXPECT_EQ(what_is_found(), what_kernels_do());
  EXPECT_EQ(what_kernels_do().size(), 122U);
}

}  // namespace
}  // namespace physgen::fem::test
