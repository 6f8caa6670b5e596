// Kernels that assign objects from objects, and arrays of any bits, for host and CUDA memory.
#pragma once

#include <everything.physgen.h>

#include "test_objects.h"

namespace physgen::test {

/// Any bits at all: also those of numbers that are not, and of quaternions that are no rotations.
template <class AosArray>
void fill_with_random_bits(AosArray& array, std::mt19937& random) {
  const UntypedArray untyped = array.untyped();
  for (index_t byte = 0; byte < untyped.bytes(); ++byte) untyped.base[byte] = static_cast<std::byte>(random());
}

/// Object by object on the host: copy() of checked builds looks for values that formats cannot hold.
template <class ToArray, class FromArray>
void move_objects(ToArray& to, const FromArray& from) {
  for (index_t i = 0; i < to.size(); ++i) to.view()[i] = from.view()[i];
}

template <class To, class From>
struct CopyObjects {
  using Scalar = double;  // of packs as wide as the widest element's
  To to;
  From from;
  template <class I>
  PHYSGEN_FUNCTION void operator()(const I& i) const {
    to[i] = from[i];
  }
};
template <class To, class From, class Numbers>
struct GatherObjects {
  using Scalar = double;
  To to;
  From from;
  Numbers numbers;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    to[i] = from[numbers[i].element()];
  }
};
template <class View>
struct SwapObjects {
  View a, b;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    swap(a[i], b[i]);
  }
};

}  // namespace physgen::test
