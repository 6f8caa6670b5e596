// Programs over the executor of the CPU.
#include <physgen/executor.h>

#include "executor_checks.h"

namespace physgen {
namespace {

TEST(HostExecutor, loops_end_when_done_or_after_their_rounds) {
  HostExecutor on;
  check_loops(on);
}

TEST(HostExecutor, values_are_of_one_object) {
  HostExecutor on;
  check_values(on);
}

}  // namespace
}  // namespace physgen
