// Sums at objects that a kernel names by index: add(i, view[j].f(), value), right for equal lanes of a pack, for the
// lanes outside a range, for threads and on CUDA.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/cursor.h>

namespace physgen {

/// Adds the values of the kernel's object(s) `own` to what `to` refers to. Other threads of the process, and other
/// lanes of the pack, may add to the same object: each addition is atomic. In which order, and so with which last bits,
/// is open; sums that have the same bits on every run are gathers over Rows (rows.h).
/// @param own the kernel's own index: of a PartialPack, the lanes outside the range are left out
/// @param to a field that is stored as it is computed, of an object named by a gathered index or by `own`
template <class I, class To>
  requires(detail::SomeFieldReference<To> || (detail::ElementReference<To> && !std::is_lvalue_reference_v<To>))
PHYSGEN_FUNCTION void add(const I& own, To&& to, const typename std::remove_cvref_t<To>::Value& value) {
  using Lanes = typename std::remove_cvref_t<To>::Lanes;
  detail::refuse_one_sum_for_a_pack<I, To, std::is_same_v<lanes_t<lane_of_t<Lanes>, I>, Lanes>>();
  to.add(lane_range(own), value);
}
/// `auto m = view[j].m()` is a reference for packs and a number of its own for one object.
template <class I, class Format, class T, class Cursor>
detail::a_named_reference_is_not_assigned_so_write_to_the_view_itself add(
    const I& own, const ElementRef<Format, T, Cursor>& to,
    const std::type_identity_t<typename ElementRef<Format, T, Cursor>::Value>& value) = delete;
/// An element of one object. @pre own is not a pack, as above
template <class I, class T, class Value>
  requires std::is_arithmetic_v<T>
PHYSGEN_FUNCTION void add(const I& /*own*/, T& to, const Value& value) {
  detail::refuse_one_sum_for_a_pack<I, T, std::is_integral_v<detail::Bare<I>>>();
  static_assert(std::is_floating_point_v<T> || !std::is_floating_point_v<Value>,
                "add(): the field holds integers, the value is not an integer; round it first");
  detail::add_atomically(to, static_cast<T>(value));
}

}  // namespace physgen

#pragma pop_macro("I")
