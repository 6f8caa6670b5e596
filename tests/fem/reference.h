// The common part of the tests of tools/fem: the run's seed, streams of random input from it, and the references they
// compare with, which share nothing with the code under test.
#pragma once

#include <fem/reference/jet.h>
#include <fem/reference/random.h>

#include <Eigen/Dense>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>

namespace physgen::fem::reference {

/// A fresh seed per run, printed; PHYSGEN_TEST_SEED repeats one.
inline std::uint64_t seed() {
  static const std::uint64_t value = [] {
    const char* given = std::getenv("PHYSGEN_TEST_SEED");
    const std::uint64_t s = given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device{}();
    std::cout << "PHYSGEN_TEST_SEED=" << s << "\n";
    return s;
  }();
  return value;
}

/// The run's seed, and a stream of it for each use.
class Random : public RandomMatrices {
 public:
  explicit Random(std::uint64_t stream) : RandomMatrices(seed() * 1000003 + stream) {}
};

}  // namespace physgen::fem::reference
