// Whether a launcher of some MPI started this process, and as one of several.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

namespace physgen::detail {

/// The environment variable by which the launcher says that there are several, with its value; or nothing.
/// (Open MPI; MPICH, Intel MPI and others with its launcher; MVAPICH2.)
[[nodiscard]] inline std::string told_of_several_processes() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS", "MV2_COMM_WORLD_SIZE"}) {
    const char* const value = std::getenv(name);
    if (value != nullptr && std::atoi(value) > 1) return name + std::string("=") + value;
  }
  return {};
}

/// Whether the environment has a name that launchers and batch systems give to what they start. A process without one
/// was started by itself. Names are those above, and those of PMIx and PMI, Slurm, Flux, PALS and ALPS of Cray, jsrun.
[[nodiscard]] inline bool may_be_launched() {
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    for (const char* name : {"OMPI_COMM_WORLD_", "OMPI_UNIVERSE_", "PMIX_", "PMI_", "MPI_LOCAL", "MV2_COMM_",
                             "SLURM_PROCID", "SLURM_STEP", "FLUX_TASK", "PALS_", "ALPS_APP", "JSM_NAMESPACE"}) {
      if (std::string_view(*entry).starts_with(name)) return true;
    }
  }
  return false;
}

}  // namespace physgen::detail
