#include "copies.h"

#include <fem/solver/linear_measurement.h>
#include <physgen/buffer.h>
#include <physgen/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <vector>
#ifdef PHYSGEN_TRUTHCUBE_HAS_CUDA
#include <physgen/cuda/check.h>
#endif

namespace physgen::truthcube {

namespace {

constexpr int copies_in_a_row = 20, repeats = 5;

template <class Copy, class Wait>
double median_of(const Copy& copy, const Wait& wait) {
  std::vector<double> seconds;
  for (int k = 0; k <= repeats; ++k) {
    wait();
    const auto start = std::chrono::steady_clock::now();
    for (int c = 0; c < copies_in_a_row; ++c) copy();
    wait();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    if (k > 0) seconds.push_back(took.count() / copies_in_a_row);
  }
  return fem::median(seconds);
}

/// By all threads, a piece each.
void copy_on_host(const Buffer& to, const Buffer& from) {
  constexpr index_t piece = index_t{1} << 20;
  const index_t pieces = (from.bytes() + piece - 1) / piece;
  parallel_for(Host{}, pieces, lanes<1>([&](index_t p) {
                 const index_t begin = p * piece, end = std::min(begin + piece, from.bytes());
                 std::memcpy(to.data() + begin, from.data() + begin, static_cast<std::size_t>(end - begin));
               }));
}

}  // namespace

double seconds_of_copy(fem::Device device, index_t bytes) {
  const SpaceKind space = device == fem::Device::cpu ? SpaceKind::host : SpaceKind::cuda;
  const Buffer from(space, bytes / 2, "the source of a copy"), to(space, bytes / 2, "the target of a copy");
#ifdef PHYSGEN_TRUTHCUBE_HAS_CUDA
  if (device == fem::Device::cuda) {
    const auto copy = [&] {
      cuda::check(
          cudaMemcpyAsync(to.data(), from.data(), static_cast<std::size_t>(from.bytes()), cudaMemcpyDeviceToDevice),
          "copying on the device");
    };
    return median_of(copy, [] { cuda::check(cudaDeviceSynchronize(), "waiting for a copy"); });
  }
#endif
  return median_of([&] { copy_on_host(to, from); }, [] {});
}

}  // namespace physgen::truthcube
