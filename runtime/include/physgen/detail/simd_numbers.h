// Plain numbers beside packs: where a number stands in one lane as it is, it calculates as it does beside one object;
// all others are refused, by types whose names compilers print.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/deleted.h>
#include <physgen/detail/reference_rules.h>
#include <physgen/detail/simd_registers.h>

#include <concepts>
#include <type_traits>
#include <xsimd/xsimd.hpp>

namespace physgen::detail {

/// Plain numbers that integer lanes of type T cannot hold: floating ones, wider integers and unsigned ones.
template <class T, class Number>
concept CutDown = std::is_integral_v<T> && std::is_arithmetic_v<Number> &&
                  (std::is_floating_point_v<Number> || sizeof(Number) > sizeof(T) ||
                   (std::is_unsigned_v<Number> && sizeof(Number) == sizeof(T)));
struct integer_lanes_beside_a_number_they_cannot_hold_so_use_to_real_of_S {};

}  // namespace physgen::detail

namespace xsimd {

// xsimd would cut a number down, or round it, to the lanes' type, while one object calculates in the number's type.
// These macros are undefined below.
#define PHYSGEN_REFUSED_ASSIGNMENT(op, Beside, refused) \
  template <class T, class A, class Number>             \
    requires physgen::detail::Beside<T, Number>         \
  physgen::detail::refused operator op(batch<T, A>&, Number) PHYSGEN_DELETED(refused);
#define PHYSGEN_REFUSED_OPERATOR(op, Beside, refused)                                        \
  template <class T, class A, class Number>                                                  \
    requires physgen::detail::Beside<T, Number>                                              \
  physgen::detail::refused operator op(const batch<T, A>&, Number) PHYSGEN_DELETED(refused); \
  template <class T, class A, class Number>                                                  \
    requires physgen::detail::Beside<T, Number>                                              \
  physgen::detail::refused operator op(Number, const batch<T, A>&) PHYSGEN_DELETED(refused);
#define PHYSGEN_REFUSED(Beside, refused)          \
  PHYSGEN_REFUSED_ASSIGNMENT(+=, Beside, refused) \
  PHYSGEN_REFUSED_ASSIGNMENT(-=, Beside, refused) \
  PHYSGEN_REFUSED_ASSIGNMENT(*=, Beside, refused) \
  PHYSGEN_REFUSED_ASSIGNMENT(/=, Beside, refused) \
  PHYSGEN_REFUSED_OPERATOR(+, Beside, refused)    \
  PHYSGEN_REFUSED_OPERATOR(-, Beside, refused)    \
  PHYSGEN_REFUSED_OPERATOR(*, Beside, refused)    \
  PHYSGEN_REFUSED_OPERATOR(/, Beside, refused)    \
  PHYSGEN_REFUSED_OPERATOR(<, Beside, refused)    \
  PHYSGEN_REFUSED_OPERATOR(>, Beside, refused)    \
  PHYSGEN_REFUSED_OPERATOR(<=, Beside, refused)   \
  PHYSGEN_REFUSED_OPERATOR(>=, Beside, refused)   \
  PHYSGEN_REFUSED_OPERATOR(==, Beside, refused)   \
  PHYSGEN_REFUSED_OPERATOR(!=, Beside, refused)
PHYSGEN_REFUSED(CutDown, integer_lanes_beside_a_number_they_cannot_hold_so_use_to_real_of_S)
PHYSGEN_REFUSED_ASSIGNMENT(%=, CutDown, integer_lanes_beside_a_number_they_cannot_hold_so_use_to_real_of_S)
PHYSGEN_REFUSED_OPERATOR(%, CutDown, integer_lanes_beside_a_number_they_cannot_hold_so_use_to_real_of_S)
PHYSGEN_REFUSED(Wider, a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it)
#undef PHYSGEN_REFUSED
#undef PHYSGEN_REFUSED_OPERATOR
#undef PHYSGEN_REFUSED_ASSIGNMENT

// Comparisons that begin with a plain number, `k < count`. `==` and `!=` need both orders: C++20 would make
// one of the other, and insist on a bool. PHYSGEN_COMPARISON is undefined below.
#define PHYSGEN_COMPARISON(op, reversed)                                             \
  template <class Number, class T, class A>                                          \
    requires(std::is_arithmetic_v<Number> && !physgen::detail::CutDown<T, Number> && \
             !physgen::detail::Wider<T, Number>)                                     \
  inline batch_bool<T, A> operator op(Number a, const batch<T, A>& b) {              \
    return b reversed batch<T, A>(static_cast<T>(a));                                \
  }
PHYSGEN_COMPARISON(<, >)
PHYSGEN_COMPARISON(>, <)
PHYSGEN_COMPARISON(<=, >=)
PHYSGEN_COMPARISON(>=, <=)
PHYSGEN_COMPARISON(==, ==)
PHYSGEN_COMPARISON(!=, !=)
#undef PHYSGEN_COMPARISON
template <class T, class A, class Number>
  requires(std::is_arithmetic_v<Number> && !physgen::detail::CutDown<T, Number> && !physgen::detail::Wider<T, Number>)
inline batch_bool<T, A> operator==(const batch<T, A>& a, Number b) {
  return a == batch<T, A>(static_cast<T>(b));
}
template <class T, class A, class Number>
  requires(std::is_arithmetic_v<Number> && !physgen::detail::CutDown<T, Number> && !physgen::detail::Wider<T, Number>)
inline batch_bool<T, A> operator!=(const batch<T, A>& a, Number b) {
  return a != batch<T, A>(static_cast<T>(b));
}

}  // namespace xsimd

#pragma pop_macro("I")
