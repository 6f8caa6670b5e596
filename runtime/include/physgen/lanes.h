// Questions that a kernel asks of its index, in one form for single objects, packs and CUDA threads: which lanes are
// objects of its range, which numbers they have, and whether a condition holds for them. simd_lanes.h has the forms for
// packs.
#pragma once

#include <physgen/detail/check_number.h>
#include <physgen/element_ref.h>
#include <physgen/pack.h>

#include <concepts>

namespace physgen {

/// Tells which lanes of T are objects of the kernel's range: `true`, or for packs a mask. `wanted<Scalar>(i)`.
template <class T, std::integral I>
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool wanted(I /*i*/) {
  return true;
}

/// The number(s) of the object(s) at i, as 32-bit indices; a lane outside the range has the number of one inside.
/// @throw Error when a number exceeds 2^31 - 1
template <std::integral I>
[[nodiscard]] PHYSGEN_FUNCTION std::int32_t numbers(I i) {
  detail::check_number(static_cast<index_t>(i));
  return static_cast<std::int32_t>(i);
}

/// Whether a condition holds for any, for all objects at i.
template <std::integral I>
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool any(I /*i*/, bool condition) {
  return condition;
}
template <std::integral I>
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool all(I /*i*/, bool condition) {
  return condition;
}

/// The largest and the smallest value over the objects at i: of counts, the end of a loop that serves all of them.
template <std::integral I, class T>
  requires std::is_arithmetic_v<T>
[[nodiscard]] PHYSGEN_FUNCTION constexpr T largest(I /*i*/, T value) {
  return value;
}
template <std::integral I, class T>
  requires std::is_arithmetic_v<T>
[[nodiscard]] PHYSGEN_FUNCTION constexpr T smallest(I /*i*/, T value) {
  return value;
}

// The index of a fused kernel answers as the one that it holds.
template <class T, class I, class Frame>
[[nodiscard]] PHYSGEN_FUNCTION constexpr auto wanted(const Own<I, Frame>& i) {
  return wanted<T>(i.index);
}
template <class I, class Frame>
[[nodiscard]] PHYSGEN_FUNCTION auto numbers(const Own<I, Frame>& i) {
  return numbers(i.index);
}
template <class I, class Frame, class Mask>
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool any(const Own<I, Frame>& i, const Mask& condition) {
  return any(i.index, condition);
}
template <class I, class Frame, class Mask>
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool all(const Own<I, Frame>& i, const Mask& condition) {
  return all(i.index, condition);
}
template <class I, class Frame, class Numbers>
[[nodiscard]] PHYSGEN_FUNCTION constexpr auto largest(const Own<I, Frame>& i, const Numbers& value) {
  return largest(i.index, value);
}
template <class I, class Frame, class Numbers>
[[nodiscard]] PHYSGEN_FUNCTION constexpr auto smallest(const Own<I, Frame>& i, const Numbers& value) {
  return smallest(i.index, value);
}

/// Stores `value` where `condition` holds: `store_where(m > S(4), view[i].u(), S(100))`.
/// @param to what a view's accessor returns: a field or an element
template <class To, class Value>
PHYSGEN_FUNCTION void store_where(bool condition, To&& to, const Value& value) {
  if constexpr (requires { requires std::remove_cvref_t<To>::of_a_local; })
    detail::refuse_masks<std::remove_cvref_t<To>>();
  if (condition) static_cast<To&&>(to) = value;
}

}  // namespace physgen
