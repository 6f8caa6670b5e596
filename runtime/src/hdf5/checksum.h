// Finds damage in files. For 32-bit words w[0] .. w[n-1] it is the sum of all w[i] and the sum of all (n - i) w[i],
// both modulo 2^64: any two wrong bits change it, and so do words that change places. Source: the sums of Fletcher
// 1982, wide enough to need no other modulus.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace physgen::h5 {

/// The checksum of bytes that are added in order; a last word is filled with zeros.
class Checksum {
 public:
  Checksum() = default;
  explicit Checksum(std::span<const std::byte> bytes);
  /// Adds what follows. @pre all that was added before were whole words
  void append(const Checksum& next);
  [[nodiscard]] const std::array<std::uint64_t, 2>& value() const { return sums_; }

 private:
  std::array<std::uint64_t, 2> sums_{};
  std::uint64_t words_ = 0;
};

}  // namespace physgen::h5
