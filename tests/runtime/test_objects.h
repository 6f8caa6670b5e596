// The common part of the runtime's tests: the object types they run over, random values, and every layout.
#pragma once

#include <elasticity.physgen.h>
#include <gtest/gtest.h>

#include <cstring>
#include <iostream>
#include <random>
#include <vector>

namespace physgen::test {

/// Seed of this run; printed, and set by PHYSGEN_TEST_SEED when a failure is to be replayed.
inline unsigned seed() {
  static const unsigned value = [] {
    const char* given = std::getenv("PHYSGEN_TEST_SEED");
    const unsigned chosen = given != nullptr ? static_cast<unsigned>(std::stoul(given)) : std::random_device{}();
    std::cout << "seed " << chosen << " (PHYSGEN_TEST_SEED replays it)\n";
    return chosen;
  }();
  return value;
}

/// The message of the Error that `action` throws.
template <class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

/// The law of addresses in the plainest form, against which the runtime's is held.
inline index_t address_by_law(index_t base_offset, index_t i, index_t pitch, index_t record_bytes, index_t size) {
  return (i / pitch) * pitch * record_bytes + base_offset * pitch + (i % pitch) * size;
}

// These functions work on arrays without their types: compiled once, not for each of the many types of arrays.

/// Random, nowhere zero bytes that are finite as float, double and int, for the elements of AoS records on the host.
inline void randomise(const UntypedArray& untyped, std::mt19937& random) {
  std::uniform_real_distribution<float> value(0.5F, 2.0F);
  for (index_t i = 0; i < untyped.size; ++i) {
    for (const FieldInfo& field : untyped.fields) {
      for (int k = 0; k < field.count; ++k) {
        std::byte* element = untyped.base + i * untyped.record_bytes + field.offset + k * element_bytes(field.type);
        const float drawn = value(random);
        if (field.type == ElementType::float64) {
          const double wide = drawn;
          std::memcpy(element, &wide, sizeof wide);
        } else if (field.type == ElementType::float32) {
          std::memcpy(element, &drawn, sizeof drawn);
        } else {
          const auto integer = static_cast<std::int32_t>(random() | 1U);
          std::memcpy(element, &integer, sizeof integer);
        }
      }
    }
  }
}
template <class AosArray>
void randomise(AosArray& array, std::mt19937& random) {
  randomise(array.untyped(), random);
}

/// Fills the memory of a host array with bytes that no test value has.
inline void poison(const UntypedArray& untyped) {
  if (untyped.bytes() > 0) std::memset(untyped.base, 0xA5, static_cast<std::size_t>(untyped.bytes()));
}
template <class HostArray>
void poison(HostArray& array) {
  poison(array.untyped());
}

/// Number of differing elements of two AoS arrays.
inline index_t count_different(const UntypedArray& x, const UntypedArray& y) {
  index_t different = 0;
  for (index_t i = 0; i < x.size; ++i) {
    for (const FieldInfo& field : x.fields) {
      const index_t at = i * x.record_bytes + field.offset;
      const auto bytes = static_cast<std::size_t>(field.count * element_bytes(field.type));
      if (std::memcmp(x.base + at, y.base + at, bytes) != 0) ++different;
    }
  }
  return different;
}
template <class A, class B>
index_t count_different(const A& a, const B& b) {
  return count_different(a.untyped(), b.untyped());
}

using AllLayouts = ::testing::Types<Aos, AosPadded, Soa, Aosoa<8>, Aosoa<32>, Aosoa<64>>;

struct LayoutName {
  template <class L>
  static std::string GetName(int /*index*/) {
    if constexpr (requires { L::tile; }) {
      return std::string(L::name) + std::to_string(L::tile);
    } else {
      return L::name;
    }
  }
};

}  // namespace physgen::test
