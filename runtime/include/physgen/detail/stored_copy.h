// Copies and exchanges of objects and fields as their formats store them, between references of one format: the bits
// stay, where a value read and stored again would be rounded a second time, or a rotation take another quaternion.
#pragma once

#include <physgen/fields/object_info.h>

namespace physgen {

// The fields of a record (record.h).
template <class... Field>
struct RecordFields;

/// A type that says how a field is stored: with this shape, in this format, computed with as T.
template <class Shape, class Format, class T>
struct StoredAs {};
/// The same of a nested object. @tparam Object its generated tag
template <class Object, class Formats, class Real>
struct NestedAs {};

namespace detail {

/// The fields of an object's record, as a type.
template <class Object, class Formats, class Real>
using FieldsOf = typename Object::template Record<Real, Formats>::fields_;

/// Whether elements of this format may be moved as they are stored: not those whose reads and writes are looked for, or
/// of which there is nothing.
template <class Format>
inline constexpr bool moves_as_stored =
    !format::is_probe<format::ElementFormat<Format>> && !format::StoresNothing<format::ElementFormat<Format>>;

// Whether a field is stored alike on both sides, and may be moved so.
template <class A, class B>
[[nodiscard]] constexpr bool stored_alike(A /*to*/, B /*from*/) {
  return false;
}
template <class Shape, class Format, class T>
[[nodiscard]] constexpr bool stored_alike(StoredAs<Shape, Format, T> /*to*/, StoredAs<Shape, Format, T> /*from*/) {
  return moves_as_stored<Format>;
}
template <class... A, class... B>
[[nodiscard]] constexpr bool all_stored_alike(RecordFields<A...> to, RecordFields<B...> from);
template <class Object, class FormatsA, class FormatsB, class Real>
[[nodiscard]] constexpr bool stored_alike(NestedAs<Object, FormatsA, Real> /*to*/,
                                          NestedAs<Object, FormatsB, Real> /*from*/) {
  return all_stored_alike(FieldsOf<Object, FormatsA, Real>(), FieldsOf<Object, FormatsB, Real>());
}
template <class... A, class... B>
[[nodiscard]] constexpr bool all_stored_alike(RecordFields<A...> /*to*/, RecordFields<B...> /*from*/) {
  const bool alike[] = {stored_alike(typename A::As(), typename B::As())...};
  for (const bool field : alike)
    if (!field) return false;
  return true;
}

// Whether memory holds what is computed with, so that a value that is read and stored again keeps its bits.
template <class Shape, class Format, class T>
[[nodiscard]] constexpr bool is_plain_field(StoredAs<Shape, Format, T> /*as*/) {
  return format::is_plain<Format, T>;
}
template <class... Field>
[[nodiscard]] constexpr bool all_plain(RecordFields<Field...> fields);
template <class Object, class Formats, class Real>
[[nodiscard]] constexpr bool is_plain_field(NestedAs<Object, Formats, Real> /*as*/) {
  return all_plain(FieldsOf<Object, Formats, Real>());
}
template <class... Field>
[[nodiscard]] constexpr bool all_plain(RecordFields<Field...> /*fields*/) {
  const bool plain[] = {is_plain_field(typename Field::As())...};
  for (const bool field : plain)
    if (!field) return false;
  return true;
}

/// Cursors that give elements as they are stored: on objects that exist.
template <class Cursor>
concept GivesStored = requires { requires Cursor::gives_stored; };

/// Elements kFirst .. of at most this many are read before the first of them is written.
inline constexpr int stored_batch = 16;

/// Element by element, `to` becomes what `from` stores.
template <class To, class From>
struct CopyStored {
  const To& to;
  const From& from;

  template <class Element, class T, int kCount>
  PHYSGEN_FUNCTION void elements(int to_offset, int from_offset) const {
    using Stored = decltype(from.template load_stored<Element, T>(0, 0));
    if constexpr (kCount <= stored_batch) {
      Stored stored[kCount];
      PHYSGEN_UNROLL
      for (int k = 0; k < kCount; ++k) stored[k] = from.template load_stored<Element, T>(from_offset, k);
      PHYSGEN_UNROLL
      for (int k = 0; k < kCount; ++k) to.template store_stored<Element, T>(to_offset, k, stored[k]);
    } else {
      for (int k = 0; k < kCount; ++k)
        to.template store_stored<Element, T>(to_offset, k, from.template load_stored<Element, T>(from_offset, k));
    }
  }
};
/// Both exchange what they store.
template <class Cursor>
struct SwapStored {
  const Cursor& a;
  const Cursor& b;

  template <class Element, class T, int kCount>
  PHYSGEN_FUNCTION void elements(int a_offset, int b_offset) const {
    for (int k = 0; k < kCount; ++k) {
      const auto of_a = a.template load_stored<Element, T>(a_offset, k);
      const auto of_b = b.template load_stored<Element, T>(b_offset, k);
      a.template store_stored<Element, T>(a_offset, k, of_b);
      b.template store_stored<Element, T>(b_offset, k, of_a);
    }
  }
};

/// Moves one field whose elements begin at these offsets of the records.
template <class Move, class Shape, class Format, class T>
PHYSGEN_FUNCTION void move_stored(const Move& move, int to, int from, StoredAs<Shape, Format, T> /*as*/) {
  move.template elements<format::ElementFormat<Format>, T, stored_count<Shape, Format>>(to, from);
}
template <class Move, class... A, class... B>
PHYSGEN_FUNCTION void move_all_stored(const Move& move, int to, int from, RecordFields<A...> /*to_fields*/,
                                      RecordFields<B...> /*from_fields*/);

template <class A, class B, class Move, class Shape, class Format, class T>
PHYSGEN_FUNCTION void move_entry(const Move& move, int to, int from, StoredAs<Shape, Format, T> as) {
  move_stored(move, to, from, as);
}
template <class A, class B, class Move, class Object, class Formats, class Real>
PHYSGEN_FUNCTION void move_entry(const Move& move, int to, int from, NestedAs<Object, Formats, Real> /*as*/) {
  move_all_stored(move, to, from, typename A::Inner::fields_(), typename B::Inner::fields_());
}
template <class A, class B, class Move>
PHYSGEN_FUNCTION int move_entries(const Move& move, int to, int from) {
  for (int entry = 0; entry < A::slot.entries; ++entry)
    move_entry<A, B>(move, to + A::offset + entry * A::stride, from + B::offset + entry * B::stride, typename A::As());
  return 0;
}
template <class Move, class... A, class... B>
PHYSGEN_FUNCTION void move_all_stored(const Move& move, int to, int from, RecordFields<A...> /*to_fields*/,
                                      RecordFields<B...> /*from_fields*/) {
  const int moved[] = {move_entries<A, B>(move, to, from)...};  // one after the other; a fold nests too deep for clang
  (void)moved;
}

/// Whether assignment between two references moves what is stored: where it is stored alike, and not as computed.
template <class ToCursor, class FromCursor, class ToFields, class FromFields>
[[nodiscard]] constexpr bool assigns_stored() {
  if constexpr (GivesStored<ToCursor> && GivesStored<FromCursor>) {
    return all_stored_alike(ToFields(), FromFields()) && !all_plain(ToFields());
  } else {
    return false;
  }
}
/// The same for one field.
template <class Format, class T, class ToCursor, class FromCursor>
inline constexpr bool field_assigns_stored =
    GivesStored<ToCursor> && GivesStored<FromCursor> && moves_as_stored<Format> && !format::is_plain<Format, T>;

}  // namespace detail

}  // namespace physgen
