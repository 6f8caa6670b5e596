// A digest of numbers, by which the results of processes are compared.
#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>

namespace physgen::fem {

/// Of the bits of numbers, in their order.
class Digest {
 public:
  void add(double number) {
    hash_ = (hash_ ^ std::bit_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15;
    hash_ ^= hash_ >> 32;  // high bits of a number, such as its exponent, reach low ones
  }
  /// 16 hexadecimal digits
  [[nodiscard]] std::string text() const {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash_));
    return text;
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace physgen::fem
