// Sums at objects that a kernel names by index: add(i, view[j].f(), value), right for equal lanes of a pack, for the
// lanes outside a range, for threads and on CUDA.
#pragma once

#include <physgen/detail/cursor.h>

namespace physgen {

/// Adds the values of the kernel's object(s) `own` to what `to` refers to. Other threads, and other lanes of the pack,
/// may add to the same object: each addition is atomic. In which order, and so with which last bits, is open; sums that
/// have the same bits on every run are gathers over Rows (rows.h).
/// @param own the kernel's own index: of a PartialPack, the lanes outside the range are left out
/// @param to a field that is stored as it is computed, of an object named by a gathered index or by `own`
template <class I, class Shape, class Format, class T, class Cursor>
PHYSGEN_FUNCTION void add(const I& own, const FieldRef<Shape, Format, T, Cursor>& to,
                          const std::type_identity_t<typename FieldRef<Shape, Format, T, Cursor>::Value>& value) {
  static_assert(std::is_same_v<lanes_t<T, I>, typename Cursor::template Lanes<T>>,
                "add(): the kernel's index is a pack and the object's index is not, so there is one sum for W values; "
                "name the object by a batch, view[lanes_t<std::int32_t, I>(0)], or return the term to sum()");
  to.add(lane_range(own), value);
}
template <class I, class Format, class T, class Cursor>
PHYSGEN_FUNCTION void add(const I& own, const ElementRef<Format, T, Cursor>&& to,
                          const std::type_identity_t<typename ElementRef<Format, T, Cursor>::Value>& value) {
  static_assert(std::is_same_v<lanes_t<T, I>, typename Cursor::template Lanes<T>>,
                "add(): the kernel's index is a pack and the object's index is not, so there is one sum for W values; "
                "name the object by a batch, view[lanes_t<std::int32_t, I>(0)], or return the term to sum()");
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
  static_assert(std::is_integral_v<detail::Bare<I>>,
                "add(): the kernel's index is a pack and the object's index is not, so there is one sum for W values; "
                "name the object by a batch, view[lanes_t<std::int32_t, I>(0)], or return the term to sum()");
  static_assert(std::is_floating_point_v<T> || !std::is_floating_point_v<Value>,
                "add(): the field holds integers, the value is not an integer; round it first");
  detail::add_atomically(to, static_cast<T>(value));
}

}  // namespace physgen
