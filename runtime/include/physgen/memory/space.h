// Memory spaces: where an array's bytes lie and who may touch them.
#pragma once

#include <physgen/config.h>

#include <concepts>

struct CUstream_st;  // CUDA's stream, so that host code needs no CUDA headers

namespace physgen {

/// A memory space as a value, for code that decides at run time.
enum class SpaceKind : std::uint8_t { host, pinned, cuda };

/// Ordinary host memory.
struct Host {
  static constexpr SpaceKind kind = SpaceKind::host;
};

/// Page-locked host memory: transfers to and from a GPU run at full rate and asynchronously.
struct PinnedHost {
  static constexpr SpaceKind kind = SpaceKind::pinned;
};

/// Memory of the current CUDA device.
struct Cuda {
  static constexpr SpaceKind kind = SpaceKind::cuda;
};

/// Whether host code may dereference pointers of this space.
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool host_accessible(SpaceKind space) { return space != SpaceKind::cuda; }

/// Whether device code may dereference pointers of this space.
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool device_accessible(SpaceKind space) { return space != SpaceKind::host; }

/// An executor that runs its steps in this space, for functions that do a step in a way of its own there.
template <class On, class Space>
concept RunsIn = std::same_as<typename On::Space, Space>;

/// The name of a space as messages and benchmark names print it.
[[nodiscard]] constexpr const char* name(SpaceKind space) {
  switch (space) {
    case SpaceKind::host:
      return "host";
    case SpaceKind::pinned:
      return "pinned";
    case SpaceKind::cuda:
      return "cuda";
  }
  return "?";
}

/// A CUDA stream (cudaStream_t); null is the default stream. device.h says what order it gives.
using Stream = CUstream_st*;

}  // namespace physgen
