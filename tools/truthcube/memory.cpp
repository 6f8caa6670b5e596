#include "memory.h"

#include <physgen/error.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#ifdef PHYSGEN_TRUTHCUBE_HAS_CUDA
#include <cuda_runtime_api.h>
#endif

namespace physgen::truthcube {

std::int64_t host_memory() {
  std::int64_t bytes = std::int64_t{sysconf(_SC_PHYS_PAGES)} * std::int64_t{sysconf(_SC_PAGESIZE)};
  std::int64_t allowed = 0;  // of a container; "max" is no number
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> allowed) bytes = std::min(bytes, allowed);
  rlimit own{};
  if (getrlimit(RLIMIT_AS, &own) == 0 && own.rlim_cur != RLIM_INFINITY) {
    bytes = std::min(bytes, static_cast<std::int64_t>(own.rlim_cur));
  }
  return bytes;
}

std::int64_t cuda_memory() {
#ifdef PHYSGEN_TRUTHCUBE_HAS_CUDA
  std::size_t free = 0, total = 0;
  if (const cudaError_t error = cudaMemGetInfo(&free, &total); error != cudaSuccess) {
    throw Error(std::string("no GPU can be used: ") + cudaGetErrorString(error) + "; use --device cpu");
  }
  return static_cast<std::int64_t>(free);
#else
  throw Error("this build has no CUDA; configure it with -DPHYSGEN_CUDA=ON, or use --device cpu");
#endif
}

std::string gigabytes(std::int64_t bytes) {
  std::array<char, 32> text{};
  const int length = std::snprintf(text.data(), text.size(), "%.2f GB", static_cast<double>(bytes) / 1e9);
  return {text.data(), static_cast<std::size_t>(length)};
}

void require_memory(const std::string& who, std::int64_t needed, const std::string& where, std::int64_t there_is,
                    const std::string& remedy) {
  if (needed <= there_is) return;
  throw Error(who + " takes " + gigabytes(needed) + " (" + std::to_string(needed) + " bytes), and " + where + " has " +
              gigabytes(there_is) + "; " + remedy);
}

}  // namespace physgen::truthcube
