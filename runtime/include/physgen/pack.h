// The kinds of index a kernel is called with, and the type that one element has under each: a plain index reads one
// object, a Pack reads W consecutive objects at once. (A SIMD batch of int32 gathers W objects; see simd_access.h.)
#pragma once

#include <physgen/config.h>

#include <type_traits>

namespace physgen {

/// W consecutive objects, starting at a multiple of W.
template <int W>
struct Pack {
  index_t begin;
};

/// What an element of type T becomes under an index of type I: T itself, or a SIMD batch. Specialised in simd_access.h.
template <class T, class I>
struct Lanes {
  static_assert(std::is_integral_v<I>, "SIMD access on the CPU needs <physgen/simd_access.h>");
  using type = T;
};
template <class T, class I>
using lanes_t = typename Lanes<T, I>::type;

/// The type with as many lanes as S has, but lanes of type T: float, int32_t -> int32_t. Specialised in simd_access.h.
template <class S, class T>
struct SameLanes {
  using type = T;
};
template <class S, class T>
using same_lanes_t = typename SameLanes<S, T>::type;

/// `value` in each lane of an S; in generated code, where S is not known to be a number or a SIMD batch.
template <class S>
[[nodiscard]] PHYSGEN_FUNCTION constexpr S all_lanes(double value) {
  if constexpr (std::is_arithmetic_v<S>) {
    return static_cast<S>(value);
  } else {
    return S(static_cast<typename S::value_type>(value));
  }
}

}  // namespace physgen
