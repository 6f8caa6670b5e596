// Runs a kernel over objects on the CPU: OpenMP threads, each over SIMD packs where the kernel can take them.
#pragma once

#include <physgen/host_loop.h>
#include <physgen/layout.h>
#include <physgen/simd_access.h>
#include <physgen/space.h>

#include <concepts>

namespace physgen {

namespace detail {

template <class Kernel>
constexpr int default_lanes() {
  if constexpr (requires { typename Kernel::Scalar; }) {
    constexpr int lanes = native_lanes<typename Kernel::Scalar>;
    if constexpr (std::invocable<const Kernel&, Pack<lanes>>) return lanes;
  }
  return 1;
}

}  // namespace detail

/// Calls kernel(i) for the objects 0 .. size-1, on all OpenMP threads, and returns when all are done.
///
/// A kernel with a member type Scalar and a templated call operator is called with Pack<W> for W objects at once, the
/// last pack running over the padding of its arrays; else with index_t. W can be chosen; W = 1 calls with index_t.
/// @pre size is the size of the arrays whose objects the kernel writes; no two calls write the same object
/// @throw what a call throws (the first to be caught), after all other calls have been made
template <int kLanes = 0, class Kernel>
void parallel_for(Host /*space*/, index_t size, const Kernel& kernel) {
  constexpr int width = kLanes == 0 ? detail::default_lanes<Kernel>() : kLanes;
  static_assert(padding_objects % width == 0);
  const index_t packs = (size + width - 1) / width;
  detail::RegionFailure failure;
#pragma omp parallel for schedule(static) if (size >= detail::worth_threads)
  for (index_t p = 0; p < packs; ++p) {
    failure.guard([&] {
      if constexpr (width == 1) {
        kernel(p);
      } else {
        kernel(Pack<width>{p * width});
      }
    });
  }
  failure.rethrow();
}

}  // namespace physgen
