// Numbers that are checked in place of one object's: a generic kernel that is launched over single objects is compiled
// over them, too, and never run (check_numbers.h). They calculate as plain numbers do, but refuse what packs of a CPU
// would compute otherwise: a float beside a double.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/deleted.h>
#include <physgen/detail/lanewise.h>
#include <physgen/detail/reference_rules.h>

#include <Eigen/Core>
#include <limits>
#include <type_traits>

namespace physgen::detail {

/// A float, double or integer of one object: `S` in a kernel. Nothing of it is defined that is not called by a
/// constructor.
template <class T>
struct one_lane_of_S {
  using value_type = T;
  using batch_bool_type = bool;
  static constexpr std::size_t size = 1;

  constexpr one_lane_of_S() = default;
  template <class Number>
    requires std::is_arithmetic_v<Number>
  constexpr one_lane_of_S(Number /*value*/) {}  // NOLINT: implicit, as a number's conversion is
  template <class U>
  explicit constexpr one_lane_of_S(const one_lane_of_S<U>& /*value*/) {}
  PHYSGEN_FUNCTION operator T() const;  // NOLINT: implicit, as a number's conversion is
  [[nodiscard]] PHYSGEN_FUNCTION T get(std::size_t lane) const;

  PHYSGEN_FUNCTION one_lane_of_S operator-() const;
  PHYSGEN_FUNCTION one_lane_of_S operator+() const;
  PHYSGEN_FUNCTION one_lane_of_S& operator++();
  PHYSGEN_FUNCTION one_lane_of_S& operator--();
  PHYSGEN_FUNCTION one_lane_of_S operator++(int);
  PHYSGEN_FUNCTION one_lane_of_S operator--(int);
};

/// A number that lies in memory as it is computed with, as T& of one object does.
template <class T>
struct lane_in_memory : one_lane_of_S<T> {
  using one_lane_of_S<T>::one_lane_of_S;
  lane_in_memory(const lane_in_memory&) = default;
  PHYSGEN_FUNCTION lane_in_memory(const one_lane_of_S<T>& value);  // NOLINT: implicit, as a number's copy is
  lane_in_memory& operator=(const lane_in_memory&) = default;
  PHYSGEN_FUNCTION lane_in_memory& operator=(const one_lane_of_S<T>& value);
  template <class Number>
    requires std::is_arithmetic_v<Number>
  PHYSGEN_FUNCTION lane_in_memory& operator=(Number value);
  PHYSGEN_FUNCTION T* operator&();
  PHYSGEN_FUNCTION const T* operator&() const;
};
template <class T>
PHYSGEN_FUNCTION void swap(lane_in_memory<T>& a, lane_in_memory<T>& b);

/// Plain numbers that calculate with one object's as they do with packs.
template <class Number, class T>
concept CalculatesBeside = std::is_arithmetic_v<Number> && !Wider<T, Number>;
template <class Number, class T>
concept WiderThan = Wider<T, Number>;

// nvcc names no types that functions return, so what they refuse is a template's argument, too. These macros are
// undefined below.
#define PHYSGEN_OPERATOR(op)                                                                              \
  template <class T>                                                                                      \
  PHYSGEN_FUNCTION one_lane_of_S<T> operator op(const one_lane_of_S<T>&, const one_lane_of_S<T>&);        \
  template <class T, CalculatesBeside<T> Number>                                                          \
  PHYSGEN_FUNCTION one_lane_of_S<decltype(T() op Number())> operator op(const one_lane_of_S<T>&, Number); \
  template <class T, CalculatesBeside<T> Number>                                                          \
  PHYSGEN_FUNCTION one_lane_of_S<decltype(Number() op T())> operator op(Number, const one_lane_of_S<T>&); \
  PHYSGEN_REFUSED(op)
#define PHYSGEN_ASSIGNMENT(op)                                                               \
  template <class T, class Value>                                                            \
    requires(std::is_arithmetic_v<Value> ? CalculatesBeside<Value, T>                        \
                                         : std::is_convertible_v<Value, one_lane_of_S<T>>)   \
  PHYSGEN_FUNCTION one_lane_of_S<T>& operator op(one_lane_of_S<T>&, const Value&);           \
  template <class T, WiderThan<T> Number,                                                    \
            class Refused = a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it> \
  Refused operator op(one_lane_of_S<T>&, Number)                                             \
      PHYSGEN_DELETED(a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it);
#define PHYSGEN_COMPARISON(op)                                                         \
  template <class T>                                                                   \
  PHYSGEN_FUNCTION bool operator op(const one_lane_of_S<T>&, const one_lane_of_S<T>&); \
  template <class T, CalculatesBeside<T> Number>                                       \
  PHYSGEN_FUNCTION bool operator op(const one_lane_of_S<T>&, Number);                  \
  template <class T, CalculatesBeside<T> Number>                                       \
  PHYSGEN_FUNCTION bool operator op(Number, const one_lane_of_S<T>&);                  \
  PHYSGEN_REFUSED(op)
#define PHYSGEN_REFUSED(op)                                                                  \
  template <class T, WiderThan<T> Number,                                                    \
            class Refused = a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it> \
  Refused operator op(const one_lane_of_S<T>&, Number)                                       \
      PHYSGEN_DELETED(a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it);      \
  template <class T, WiderThan<T> Number,                                                    \
            class Refused = a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it> \
  Refused operator op(Number, const one_lane_of_S<T>&)                                       \
      PHYSGEN_DELETED(a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it);
PHYSGEN_OPERATOR(+)
PHYSGEN_OPERATOR(-)
PHYSGEN_OPERATOR(*)
PHYSGEN_OPERATOR(/)
PHYSGEN_ASSIGNMENT(+=)
PHYSGEN_ASSIGNMENT(-=)
PHYSGEN_ASSIGNMENT(*=)
PHYSGEN_ASSIGNMENT(/=)
PHYSGEN_COMPARISON(<)
PHYSGEN_COMPARISON(>)
PHYSGEN_COMPARISON(<=)
PHYSGEN_COMPARISON(>=)
PHYSGEN_COMPARISON(==)
PHYSGEN_COMPARISON(!=)
#undef PHYSGEN_REFUSED
#undef PHYSGEN_COMPARISON
#undef PHYSGEN_ASSIGNMENT
#undef PHYSGEN_OPERATOR

// The functions of math.h, found by argument-dependent lookup as those of packs are. The macros are undefined below.
#define PHYSGEN_OF_ONE(result, function) \
  template <class T>                     \
  PHYSGEN_FUNCTION result function(const one_lane_of_S<T>&);
#define PHYSGEN_OF_TWO(function) \
  template <class T>             \
  PHYSGEN_FUNCTION one_lane_of_S<T> function(const one_lane_of_S<T>&, const one_lane_of_S<T>&);
PHYSGEN_OF_ONE(one_lane_of_S<T>, abs)
PHYSGEN_OF_ONE(one_lane_of_S<T>, acos)
PHYSGEN_OF_ONE(one_lane_of_S<T>, asin)
PHYSGEN_OF_ONE(one_lane_of_S<T>, atan)
PHYSGEN_OF_ONE(one_lane_of_S<T>, cbrt)
PHYSGEN_OF_ONE(one_lane_of_S<T>, ceil)
PHYSGEN_OF_ONE(one_lane_of_S<T>, cos)
PHYSGEN_OF_ONE(one_lane_of_S<T>, cosh)
PHYSGEN_OF_ONE(one_lane_of_S<T>, exp)
PHYSGEN_OF_ONE(one_lane_of_S<T>, expm1)
PHYSGEN_OF_ONE(one_lane_of_S<T>, floor)
PHYSGEN_OF_ONE(one_lane_of_S<T>, log)
PHYSGEN_OF_ONE(one_lane_of_S<T>, log1p)
PHYSGEN_OF_ONE(one_lane_of_S<T>, round)
PHYSGEN_OF_ONE(one_lane_of_S<T>, sin)
PHYSGEN_OF_ONE(one_lane_of_S<T>, sinh)
PHYSGEN_OF_ONE(one_lane_of_S<T>, sqrt)
PHYSGEN_OF_ONE(one_lane_of_S<T>, tan)
PHYSGEN_OF_ONE(one_lane_of_S<T>, tanh)
PHYSGEN_OF_ONE(one_lane_of_S<T>, trunc)
PHYSGEN_OF_ONE(bool, isfinite)
PHYSGEN_OF_ONE(bool, isinf)
PHYSGEN_OF_ONE(bool, isnan)
PHYSGEN_OF_TWO(atan2)
PHYSGEN_OF_TWO(copysign)
PHYSGEN_OF_TWO(fmod)
PHYSGEN_OF_TWO(hypot)
PHYSGEN_OF_TWO(max)
PHYSGEN_OF_TWO(min)
PHYSGEN_OF_TWO(pow)
#undef PHYSGEN_OF_TWO
#undef PHYSGEN_OF_ONE
template <class T>
PHYSGEN_FUNCTION one_lane_of_S<T> fma(const one_lane_of_S<T>&, const one_lane_of_S<T>&, const one_lane_of_S<T>&);

}  // namespace physgen::detail

namespace physgen::math {

template <class T>
struct ScalarTraits<physgen::detail::one_lane_of_S<T>> {
  using S = physgen::detail::one_lane_of_S<T>;
  using Real = T;
  static constexpr int width = 1;
  PHYSGEN_FUNCTION static S inverse_sqrt(const S& x);
  PHYSGEN_FUNCTION static S rough_inverse_sqrt(const S& x);
  PHYSGEN_FUNCTION static S rough_inverse(const S& x);
  PHYSGEN_FUNCTION static PowerOfTwo<S> normalising_scale(const S& x);
  PHYSGEN_FUNCTION static MantissaExponent<S> split(const S& x);
};
template <class To, class T>
struct detail::Cast<To, physgen::detail::one_lane_of_S<T>> {
  using type = physgen::detail::one_lane_of_S<To>;
  PHYSGEN_FUNCTION static type of(const physgen::detail::one_lane_of_S<T>& x);
};

}  // namespace physgen::math

template <class T>
struct std::numeric_limits<physgen::detail::one_lane_of_S<T>> : std::numeric_limits<T> {};

namespace Eigen {

template <class T>
struct NumTraits<physgen::detail::one_lane_of_S<T>> : NumTraits<T> {
  using Real = physgen::detail::one_lane_of_S<T>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = T;
};
template <class T, class BinaryOp>
struct ScalarBinaryOpTraits<physgen::detail::one_lane_of_S<T>, T, BinaryOp> {
  using ReturnType = physgen::detail::one_lane_of_S<T>;
};
template <class T, class BinaryOp>
struct ScalarBinaryOpTraits<T, physgen::detail::one_lane_of_S<T>, BinaryOp> {
  using ReturnType = physgen::detail::one_lane_of_S<T>;
};

}  // namespace Eigen

#pragma pop_macro("I")
