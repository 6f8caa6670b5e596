// A cursor stands on one object of an array (or on the objects of a SIMD pack) and turns byte offsets of the record
// into addresses. This file holds the one line of address arithmetic; generated accessors and kernels only use it.
#pragma once

#include <physgen/field_ref.h>
#include <physgen/pack.h>

#include <type_traits>

namespace physgen {

/// @tparam Byte std::byte, or const std::byte for a read-only array
/// @tparam Layout Aos, AosPadded, Soa or Aosoa<W>
/// @tparam kRecordBytes bytes of a record in an array of this layout
/// @tparam kLaneBytes bytes of the elements that most fields of the object have
/// @tparam I the kind of index; integral here, SIMD packs in simd_access.h
template <class Byte, class Layout, int kRecordBytes, int kLaneBytes, class I>
class Cursor {
  static_assert(std::is_integral_v<I>, "SIMD access on the CPU needs <physgen/simd_access.h>");
  using Pitch = typename Layout::Pitch;

 public:
  /// An element of type T as code sees it: const in a read-only array.
  template <class T>
  using Element = std::conditional_t<std::is_const_v<Byte>, const T, T>;
  template <class T>
  using Lanes = T;

  /// Stands on object i of the array at `base`.
  PHYSGEN_FUNCTION Cursor(Byte* base, Pitch pitch, I i)
      : lane_(pitch.lane(static_cast<index_t>(i))),
        object_(base + pitch.tile(static_cast<index_t>(i)) * pitch.value() * kRecordBytes + lane_ * kLaneBytes),
        pitch_(pitch) {}

  /// Address of the T at byte `offset` of the record.
  template <class T>
  [[nodiscard]] PHYSGEN_FUNCTION Element<T>* address(int offset) const {
    constexpr index_t correction = index_t{sizeof(T)} - kLaneBytes;
    return reinterpret_cast<Element<T>*>(object_ + offset * pitch_.value() + lane_ * correction);
  }

  /// A reference to the field that begins at byte `offset` of the record: T& for one element, else a FieldRef.
  template <class Shape, class T>
  [[nodiscard]] PHYSGEN_FUNCTION decltype(auto) field(int offset) const {
    if constexpr (Shape::is_scalar) {
      return element<T>(offset);
    } else {
      return FieldRef<Shape, T, Cursor>(nested(offset));
    }
  }

  /// Element k of those of type T that follow each other from byte `offset` of the record on.
  template <class T>
  [[nodiscard]] PHYSGEN_FUNCTION Element<T>& element(int offset, int k = 0) const {
    return address<T>(offset)[k * pitch_.value()];
  }

  /// The cursor of an object nested at byte `offset` of this one.
  [[nodiscard]] PHYSGEN_FUNCTION Cursor nested(int offset) const {
    Cursor inner = *this;
    inner.object_ += offset * pitch_.value();
    return inner;
  }

 private:
  // All fields of an object share object_; computed per field, compilers would not find what is common.
  index_t lane_;  // the object's place in its tile
  Byte* object_;  // where the element at offset 0 lies, were it kLaneBytes wide
  Pitch pitch_;
};

}  // namespace physgen
