// Questions that a kernel asks of its index, in one form for single objects, packs and CUDA threads: which lanes are
// objects of its range, which numbers they have, and whether a condition holds for them. simd_lanes.h has the forms for
// packs.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/check_number.h>
#include <physgen/fields/element_ref.h>
#include <physgen/kernels/pack.h>

#include <concepts>

namespace physgen {

/// Tells which lanes of T are objects of the kernel's range: `true`, or for packs a mask. `wanted<Scalar>(i)`.
template <class T, detail::OfOneObject I>
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool wanted(const I& /*i*/) {
  return true;
}

/// The number(s) of the object(s) at i, as 32-bit indices; a lane outside the range has the number of one inside.
/// @throw Error when a number exceeds 2^31 - 1
template <detail::OfOneObject I>
[[nodiscard]] PHYSGEN_FUNCTION lanes_t<std::int32_t, I> numbers(const I& i) {
  detail::check_number(static_cast<index_t>(detail::bare(i)));
  return static_cast<std::int32_t>(detail::bare(i));
}

/// The number of the one object at i. What it names are other objects, as far as types tell; view[i] is the own one.
template <SingleObject I>
[[nodiscard]] PHYSGEN_FUNCTION constexpr index_t object_number(const I& i) {
  return static_cast<index_t>(detail::bare(i));
}

/// The object(s) first + i, where a kernel is called for the objects of a part that begins at `first`: the own ones,
/// too. It is an index for views, not a number to calculate with; numbers(i) is one.
/// @param first the same in all calls of a launch
/// @throw Error in packs, when a number exceeds 2^31 - 1
template <detail::OfOneObject I>
[[nodiscard]] PHYSGEN_FUNCTION constexpr auto object_of_part(index_t first, const I& i) {
  if constexpr (std::same_as<I, detail::OwnObject>) {
    return I{first + i.index, i.frame};
  } else if constexpr (std::same_as<detail::Bare<I>, detail::CheckedIndex>) {
    return numbers(i) + static_cast<std::int32_t>(first);
  } else if constexpr (detail::is_own<I>) {
    return Own<index_t, detail::FrameOfPart>{first + static_cast<index_t>(detail::bare(i)), nullptr};
  } else {
    return first + static_cast<index_t>(i);
  }
}

/// Whether a condition holds for any, for all objects at i.
template <detail::OfOneObject I>
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool any(const I& /*i*/, bool condition) {
  return condition;
}
template <detail::OfOneObject I>
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool all(const I& /*i*/, bool condition) {
  return condition;
}

/// The largest and the smallest value over the objects at i: of counts, the end of a loop that serves all of them.
template <detail::OfOneObject I, class T>
  requires std::is_arithmetic_v<T>
[[nodiscard]] PHYSGEN_FUNCTION constexpr T largest(const I& /*i*/, T value) {
  return value;
}
template <detail::OfOneObject I, class T>
  requires std::is_arithmetic_v<T>
[[nodiscard]] PHYSGEN_FUNCTION constexpr T smallest(const I& /*i*/, T value) {
  return value;
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

#pragma pop_macro("I")
