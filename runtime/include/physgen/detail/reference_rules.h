// The rules that references keep: what an operator calculates with, and what does not compile, where the name of a type
// is the message that compilers print.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/config.h>

#include <type_traits>
#include <utility>

namespace physgen {

template <class Format, class T, class Cursor>
class ElementRef;

namespace detail {

template <class T>
inline constexpr bool is_element_ref = false;
template <class Format, class T, class Cursor>
inline constexpr bool is_element_ref<ElementRef<Format, T, Cursor>> = true;

template <class T>
concept ElementReference = is_element_ref<std::remove_cvref_t<T>>;

/// Whether one of two operands is a reference with a name, which is not read.
template <class A, class B>
concept NamedReference =
    (ElementReference<A> && std::is_lvalue_reference_v<A>) || (ElementReference<B> && std::is_lvalue_reference_v<B>);

/// The operand that an operator calculates with: the value of a reference, anything else as it is.
template <class T>
[[nodiscard]] PHYSGEN_FUNCTION constexpr decltype(auto) operand(T&& value) {
  if constexpr (ElementReference<T>) {
    return typename std::remove_cvref_t<T>::Value(std::forward<T>(value));
  } else {
    return std::forward<T>(value);
  }
}
template <class T>
using Operand = decltype(operand(std::declval<T>()));

/// A value that get() returns: const where it is a class, so that `view[i].f().get() += x`, which would change a
/// temporary, does not compile.
template <class Value>
using ReadValue = std::conditional_t<std::is_class_v<Value>, const Value, Value>;

/// Plain numbers wider than floating lanes of type T: a double beside floats. One object would calculate in double, and
/// packs in float.
template <class T, class Number>
concept Wider = std::is_floating_point_v<T> && std::is_floating_point_v<Number> && (sizeof(Number) > sizeof(T));

/// Returned by deleted functions: their names are what compilers print.
struct a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it {};
struct a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself {};
struct integers_calculate_with_integers_so_convert_first {};
struct an_empty_value_so_use_setZero {};
struct a_named_reference_is_not_assigned_so_write_to_the_view_itself {};
struct lanes_may_name_one_object_twice_so_use_add_of_the_kernels_own_index;

/// These refuse what a local of a fused kernel (fuse.h) does not have.
template <class Ref>
PHYSGEN_FUNCTION constexpr void refuse_masks() {
  static_assert(!Ref::of_a_local,
                "store_where() to a local of fuse(): where the condition does not hold, the local would have no value; "
                "write all of it, local[i].m() = select(condition, value, other), or keep an array in its place");
}
template <class Ref>
PHYSGEN_FUNCTION constexpr void refuse_sums() {
  static_assert(!Ref::of_a_local,
                "add() to a local of fuse(): no other thread or lane knows it; write local[i].m() = value, or keep an "
                "array in its place");
}
/// Refuses add() where the kernel's index is a pack and the object's index names one object.
template <class I, class To, bool kAsMany>
PHYSGEN_FUNCTION constexpr void refuse_one_sum_for_a_pack() {
  static_assert(kAsMany,
                "add(): the kernel's index is a pack and the object's index is not, so there is one sum for W values; "
                "name the object by a batch, view[lanes_t<std::int32_t, I>(0)], or return the term to sum()");
}

}  // namespace detail

}  // namespace physgen

#pragma pop_macro("I")
