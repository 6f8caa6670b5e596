// The folds that come in pairs: the largest and the smallest term, and conditions of all and of any.
#pragma once

#include <physgen/config.h>

#include <concepts>
#include <limits>

namespace physgen::detail {

template <bool kLargest>
struct Extremum {
  template <class Number>
  using Value = Number;
  template <class Number>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr Number identity() {
    using Limits = std::numeric_limits<Number>;
    if constexpr (Limits::has_infinity) return kLargest ? -Limits::infinity() : Limits::infinity();
    return kLargest ? Limits::lowest() : Limits::max();
  }
  template <class Number>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr Number value(Number term, index_t /*i*/) {
    return term;
  }
  template <class Number>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr Number join(Number a, Number b) {
    const bool first = kLargest ? a > b : a < b;
    return (static_cast<int>(first) | static_cast<int>(a != a)) != 0 ? a : b;  // `first` is false where b is NaN
  }
};

template <bool kForAll>
struct Condition {
  template <class Number>
  using Value = bool;
  template <class Number>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr bool identity() {
    return kForAll;
  }
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr bool join(bool a, bool b) { return kForAll ? a && b : a || b; }
  template <std::same_as<bool> Term>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr bool value(Term term, index_t /*i*/) {
    return term;
  }
};

}  // namespace physgen::detail
