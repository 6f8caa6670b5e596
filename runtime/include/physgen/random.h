// Random numbers that belong to objects: each is a function of a seed, an object's number and a use, so that it depends
// neither on the number of threads nor on the order of objects, and is the same on the host and on a CUDA device.
#pragma once

#include <physgen/config.h>

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace physgen {

/// Philox4x32-10, a bijection of counters for each key, whose values pass for random.
/// @return four words of 32 independent bits. Source: Salmon et al. 2011, "Parallel random numbers: as easy as 1, 2, 3"
[[nodiscard]] PHYSGEN_FUNCTION constexpr std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                                                                 std::array<std::uint32_t, 2> key) {
  constexpr std::uint64_t multiplier_0 = 0xD2511F53, multiplier_1 = 0xCD9E8D57;
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t product_0 = multiplier_0 * counter[0], product_1 = multiplier_1 * counter[2];
    counter = {static_cast<std::uint32_t>(product_1 >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(product_1),
               static_cast<std::uint32_t>(product_0 >> 32) ^ counter[3] ^ key[1],
               static_cast<std::uint32_t>(product_0)};
    key = {key[0] + 0x9E3779B9U, key[1] + 0xBB67AE85U};
  }
  return counter;
}

/// The sequence of random numbers of one object. A kernel makes one for its object where it needs some:
/// `RandomNumbers numbers(seed, i, step);  const S x = numbers.uniform<S>();`
///
/// Sequences of different seeds, objects or uses are independent. A sequence has 2^34 words of 32 bits and begins anew
/// then. Kernels that use it run over single objects: `lanes<1>` on the host.
class RandomNumbers {
 public:
  /// @param object the number of the object, such as a kernel's index; a number that stays with the object where
  /// objects are sorted or moved
  /// @param use tells apart what one object draws at several places or in several steps
  template <std::integral Number>
  PHYSGEN_FUNCTION constexpr RandomNumbers(std::uint64_t seed, Number object, std::uint32_t use = 0)
      : counter_{0, use, static_cast<std::uint32_t>(static_cast<std::uint64_t>(object)),
                 static_cast<std::uint32_t>(static_cast<std::uint64_t>(object) >> 32)},
        key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)} {}

  /// The next 32 bits of the sequence: four of each counter.
  [[nodiscard]] PHYSGEN_FUNCTION constexpr std::uint32_t bits() {
    if (used_ == 4) {
      words_ = philox4x32(counter_, key_);
      ++counter_[0];
      used_ = 0;
    }
    return words_[static_cast<std::size_t>(used_++)];
  }

  /// A number of [0, 1), of 2^24 equally likely ones in float (it takes 32 bits), and of 2^53 in double (64 bits). The
  /// host and devices have the same.
  template <std::floating_point Real>
  [[nodiscard]] PHYSGEN_FUNCTION constexpr Real uniform() {
    static_assert(std::is_same_v<Real, float> || std::is_same_v<Real, double>,
                  "random numbers are float or double: uniform<double>()");
    if constexpr (std::is_same_v<Real, float>) {
      return static_cast<float>(bits() >> 8) * 0x1p-24F;
    } else {
      const std::uint64_t high = bits(), low = bits();
      return static_cast<double>((high << 32 | low) >> 11) * 0x1p-53;
    }
  }

  /// A number of the normal distribution of mean 0 and variance 1, by Box and Muller's method from two of uniform().
  /// Its last bits depend on the logarithm and the cosine of the host or device.
  template <std::floating_point Real>
  [[nodiscard]] PHYSGEN_FUNCTION Real normal() {
    const Real radius = std::sqrt(Real(-2) * std::log(Real(1) - uniform<Real>()));
    return radius * std::cos(static_cast<Real>(6.283185307179586476925) * uniform<Real>());
  }

 private:
  std::array<std::uint32_t, 4> counter_;
  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> words_{};
  int used_ = 4;
};

}  // namespace physgen
