// The uses that nvcc's compiler of the host finds in the solver on CUDA, and those that it does not see. No device is
// needed, and no kernel runs, so that there is nothing here for nvcc's compiler of the device.
#ifndef __CUDA_ARCH__
#include <fem/solver/linear/performed_steps.h>

#include "probe_solver.h"

namespace physgen::fem::test {
namespace {

TEST(ProbesOfTheSolver, say_which_steps_on_cuda_only_clang_reads) {
  ProbeExecutor<Cuda> on;
  solver_program<ProbeExecutor<Cuda>, float, StoredInHalf>(on);
  const auto is_unseen = [](const std::string& name) {
    const std::vector<std::string> names = probe::unseen();
    return std::ranges::find(names, name) != names.end();
  };
  for (const char* function :
       {"multiply", "add_edges", "run_rows", "cycle_at_once", "invert_coarsest", "factor_blocks", "apply_blocks"}) {
    const auto names_it = [&](const std::string& text) {
      return text.find("fem::" + std::string(function) + "<") != std::string::npos;
    };
    EXPECT_TRUE(std::ranges::any_of(probe::unseen(), names_it)) << function;
  }
  // Reads of steps of run() and reduce() are found, too; fields that those alone read are named.
  EXPECT_TRUE(fields_read_only().contains("body.tets.nodes"));
  EXPECT_FALSE(is_unseen("body.tets"));
  EXPECT_TRUE(is_unseen("schwarz.factors"));
}

}  // namespace
}  // namespace physgen::fem::test
#endif
