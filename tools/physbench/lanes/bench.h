// Measures a kernel with one lane, in full packs and as a plain loop over structs, in turns.
#pragma once

#include <physgen/parallel_for.h>
#include <physgen/parallel_reduce.h>
#include <physgen/row_arrays.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <functional>
#include <random>
#include <string_view>
#include <vector>

#include "lane_kernels.h"

namespace physgen::lane_kernels {

namespace o = lane_objects;

template <class Real, class Entries>
using RowsOf = RowArrays<o::RangeArray<Real>, Entries>;

constexpr std::size_t u(auto n) { return static_cast<std::size_t>(n); }

/// A sum of all bits of an array.
template <class Array>
std::uint64_t bits(const Array& array) {
  const auto all = array.untyped();
  std::uint64_t sum = 0;
  for (index_t i = 0; i < all.size * all.record_bytes / 4; ++i) {
    std::uint32_t word;
    std::memcpy(&word, all.base + 4 * i, 4);
    sum = sum * 31 + word;
  }
  return sum;
}
/// The same objects, as structs one after the other.
template <class Array>
auto structs(const Array& array) {
  std::vector<typename Array::Value> all;
  for (index_t i = 0; i < array.size(); ++i) all.push_back(array.const_view().get(i));
  return all;
}
/// Numbers from 0.5 to 2 in all fields but those of integers.
template <class Array>
void randomise(Array& array, std::mt19937& random) {
  using Real = typename Array::Precision;
  std::uniform_real_distribution<double> value(0.5, 2.0);
  const auto all = array.untyped();
  const index_t pitch = array.const_view().pitch();
  constexpr index_t size = sizeof(Real);
  for (const FieldInfo& field : all.fields) {
    if (field.type == ElementType::int32) continue;
    for (index_t i = 0; i < all.size; ++i) {
      for (int k = 0; k < field.count; ++k) {
        const Real drawn = static_cast<Real>(value(random));
        std::memcpy(law::element(all.base, AnyPitch{pitch}, all.record_bytes, i, field.offset + k * size, size), &drawn,
                    sizeof drawn);
      }
    }
  }
}

class Bench {
 public:
  /// @param only kernels whose names have this in them
  /// @param seconds for each kernel
  Bench(std::string_view only, double seconds) : only_(only), seconds_(seconds) {}

  /// Prints a line of JSON.
  /// @param plain the loop over structs
  /// @param result the bits of the output, which are compared
  template <class Real, class Kernel, class Plain, class Bits>
  void row(const char* name, index_t n, const Kernel& kernel, const Plain& plain, const Bits& result) const {
    constexpr int full = physgen::detail::pack_lanes<Real>(), chosen = physgen::detail::lanes_of_calls<Kernel>();
    if (std::string_view(name).find(only_) == std::string_view::npos) return;
    const auto one_lane = [&] { run(n, lanes<1>(kernel)); };
    const auto packs = [&] { run(n, lanes<full>(kernel)); };
    one_lane();
    const auto bits_of_one = result();
    packs();
    const bool same = bits_of_one == result();
    const auto [one_ms, packs_ms, plain_ms] = alternate({one_lane, packs, plain});
    const double ours = chosen == 1 ? one_ms : packs_ms;
    std::printf(
        "{\"kernel\": \"%s\", \"real\": \"%s\", \"lanes\": %d, \"one_ms\": %.3f, \"packs_ms\": %.3f, "
        "\"plain_ms\": %.3f, \"chosen\": %d, \"of_best\": %.2f, \"of_plain\": %.2f, \"same_bits\": %s}\n",
        name, sizeof(Real) == 4 ? "float" : "double", full, one_ms, packs_ms, plain_ms, chosen,
        std::min(one_ms, packs_ms) / ours, plain_ms / ours, same ? "true" : "false");
    std::fflush(stdout);
  }

 private:
  template <class Kernel>
  static void run(index_t n, const Kernel& kernel) {
    if constexpr (std::is_void_v<std::invoke_result_t<const Kernel&, index_t>>) {
      parallel_for(Host{}, n, kernel);
    } else {
      static volatile double total;
      total = sum(Host{}, n, kernel);
    }
  }
  /// The least time of each [ms].
  [[nodiscard]] std::array<double, 3> alternate(const std::array<std::function<void()>, 3>& work) const {
    using Clock = std::chrono::steady_clock;
    std::array<double, 3> least{1e9, 1e9, 1e9};
    const auto begin = Clock::now();
    for (int round = 0; round < 4 || std::chrono::duration<double>(Clock::now() - begin).count() < seconds_; ++round) {
      for (std::size_t k = 0; k < work.size(); ++k) {
        const auto start = Clock::now();
        work[k]();
        least[k] = std::min(least[k], std::chrono::duration<double, std::milli>(Clock::now() - start).count());
      }
    }
    return least;
  }

  std::string_view only_;
  double seconds_;
};

}  // namespace physgen::lane_kernels
