// A kernel in the widest packs that it may have, whatever the library chooses for it.
#pragma once

#include <physgen/parallel_for.h>

namespace physgen::test {

template <class Kernel>
auto in_packs(const Kernel& kernel) {
  return lanes<detail::pack_lanes<typename Kernel::Scalar>()>(kernel);
}

}  // namespace physgen::test
