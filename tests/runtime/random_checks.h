// Random numbers of objects, on the host and on a device: one source for both. Included behind parallel_for.h or
// cuda/parallel_for.h.
#pragma once

#include <physgen/kernel.h>
#include <physgen/random.h>

#include "test_objects.h"

namespace physgen::test {

/// Each object draws three uniform numbers.
template <class Real, class View>
struct DrawThree {
  using Scalar = Real;
  View out;
  std::uint64_t seed;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    RandomNumbers numbers(seed, i, 5);
    for (int k = 0; k < 3; ++k) out[i].f()[k] = numbers.uniform<Real>();
  }
};

/// What each object draws in a kernel is what the host computes for it alone.
template <class Real, class Space, class Run>
void check_random_numbers(const Run& run) {
  constexpr std::uint64_t seed = 0xFEDCBA9876543210;
  constexpr index_t size = 1000;
  Array<elasticity::NodeForceObject, Real, Space, Soa> array(size);
  run(0, size, DrawThree<Real, decltype(array.view())>{array.view(), seed});
  Array<elasticity::NodeForceObject, Real, Host, Aos> there(size);
  copy(there, array);
  synchronize();
  for (index_t i = 0; i < size; ++i) {
    RandomNumbers numbers(seed, i, 5);
    for (int k = 0; k < 3; ++k) ASSERT_EQ(Real(there.const_view()[i].f()[k]), numbers.uniform<Real>()) << i;
  }
}

}  // namespace physgen::test
