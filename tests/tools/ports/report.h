// What both ports print of a run: a hash of its bits, and times.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstring>
#include <span>

namespace ports {

/// Seconds of a call.
template <class Call>
double seconds_of(const Call& call) {
  const auto begin = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// FNV-1a over the bits of numbers.
template <class Number>
std::uint64_t hash_of(std::span<const Number> numbers) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const Number& number : numbers) {
    unsigned char bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof(Number));
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3U;
  }
  return hash;
}

}  // namespace ports
