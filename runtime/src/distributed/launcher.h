// Whether a launcher of some MPI started this process as one of several.
#pragma once

#include <cstdlib>
#include <string>
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

}  // namespace physgen::detail
