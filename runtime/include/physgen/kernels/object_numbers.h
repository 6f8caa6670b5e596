// The numbers of objects as values, such as those that random numbers are made of: the same on any number of ranks.
#pragma once

#include <physgen/kernels/lanes.h>

namespace physgen {

/// A member of kernels. On several ranks an object has a number by which a kernel finds it, object_number(i), and one
/// that it has on all ranks, which this gives. In a kernel of a part it is of(object_of_part(first, i)).
struct ObjectNumbers {
  const index_t* global = nullptr;  ///< by number; null where both are the same

  [[nodiscard]] PHYSGEN_FUNCTION index_t of(SingleObject auto i) const {
    const index_t number = object_number(i);
    return global == nullptr ? number : global[number];
  }
};

/// Of the objects of an array that a program's executor knows. @throw Error when it has several ranks and does not
template <class On, class Array>
[[nodiscard]] ObjectNumbers numbers_of(On& on, const Array& array) {
  if constexpr (requires { on.numbers_of(array); }) {
    return on.numbers_of(array);
  } else {
    return {};
  }
}

}  // namespace physgen
