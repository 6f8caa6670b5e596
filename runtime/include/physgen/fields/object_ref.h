// The common part of all references to objects of an array. Generated code adds the accessors of the fields.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/cursor.h>
#include <physgen/detail/stored_copy.h>
#include <physgen/memory/space.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace physgen {

/// References to objects that are read as `Value`: of any layout and format.
template <class Ref, class Value>
concept ReadsAs = requires(const Ref& ref) {
  { ref.get() } -> std::same_as<const Value>;
};

namespace detail {

/// The cursors that references to objects stand on.
struct CursorOf;

}  // namespace detail

/// The base of generated accessors, which stands on their object(s).
template <class Cursor_>
class OnCursor {
 public:
  using Cursor = Cursor_;

 protected:
  PHYSGEN_FUNCTION explicit OnCursor(const Cursor& cursor) : at_(cursor) {}

  /// A reference to the field that begins at byte `offset` of the record.
  template <class Shape, class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION decltype(auto) field_(StoredAs<Shape, Format, T> /*as*/, int offset) const {
    return at_.template field<Shape, Format, T>(offset);
  }
  template <class Object, class Formats, class Real>
  [[nodiscard]] PHYSGEN_FUNCTION auto field_(NestedAs<Object, Formats, Real> /*as*/, int offset) const {
    return typename Object::template Ref<Real, Formats, Cursor>(at_.nested(offset));
  }

 private:
  friend detail::CursorOf;
  Cursor at_;
};

namespace detail {

struct CursorOf {
  template <class Ref>
  [[nodiscard]] PHYSGEN_FUNCTION static const typename Ref::Cursor& reference(const Ref& ref) {
    return static_cast<const OnCursor<typename Ref::Cursor>&>(ref).at_;
  }
};

/// References to objects whose assignment moves what is stored.
template <class To, class From>
concept StoredAlike = requires {
  requires assigns_stored<typename To::Cursor, typename From::Cursor, typename To::Record::fields_,
                          typename From::Record::fields_>();
};

template <class Object, class Real, class Layout, class Formats>
inline constexpr RecordSize record_size = [] {
  using Record = typename Object::template Record<Real, Formats>;
  constexpr int widest = sizeof(Real);
  return RecordSize{Record::bytes, Layout::record_bytes(Record::bytes, Record::alignment),
                    Record::bytes == 0 ? 0 : std::min(Record::alignment, widest)};
}();

/// The cursor on object(s) of an array. @tparam Real const for a read-only array
template <class Object, class Real, class Layout, class Formats, class I>
using CursorIn = Cursor<std::conditional_t<std::is_const_v<Real>, const std::byte, std::byte>, Layout,
                        record_size<Object, std::remove_const_t<Real>, Layout, Formats>, I>;

/// What a reference's arguments leave out: formats are the schema's, the cursor is that of an array.
template <class Object, class Real, class I, class Layout, class Formats = typename Object::template Formats<Host>,
          class Cursor = CursorIn<Object, Real, Layout, Formats, I>>
struct AccessorsOf {
  using type = typename Object::template Accessors<std::remove_const_t<Real>, Formats, Cursor>;
};

}  // namespace detail

/// A reference to one object of an array, or to those under a SIMD index. Assignment copies objects, as
/// `view[i] = view[j]` looks, with the bits that are stored where both have the same formats; a named reference that is
/// not const is not assigned, because std::swap and algorithms would take it for a value. Its accessors are those of a
/// generated class such as elasticity::StressRef<float, Formats, Cursor>: a function for each field, and get() and
/// put() for all of them.
/// @tparam Real const for a read-only array
/// @tparam Stored nothing, or the formats, where they are not the schema's, or these and the cursor, where it is not an
///         array's: in messages of compilers, types are short, and the name of a misspelt field stands behind them
template <class Object, class Real, class I, class Layout, class... Stored>
class ObjectRef : public detail::AccessorsOf<Object, Real, I, Layout, Stored...>::type {
  using Accessors = typename detail::AccessorsOf<Object, Real, I, Layout, Stored...>::type;

 public:
  using Value = typename Accessors::Value;

  PHYSGEN_FUNCTION explicit ObjectRef(const typename Accessors::Cursor& cursor) : Accessors(cursor) {}
  ObjectRef(const ObjectRef&) = default;
  ~ObjectRef() = default;
  ObjectRef& operator=(const ObjectRef&) & = delete;
  PHYSGEN_FUNCTION const ObjectRef& operator=(const ObjectRef&& other) const& { return assign_(other); }
  template <ReadsAs<Value> Other>
  PHYSGEN_FUNCTION const ObjectRef& operator=(const Other&& other) const& {
    return assign_(other);
  }

 private:
  template <class Other>
  PHYSGEN_FUNCTION const ObjectRef& assign_(const Other& other) const {
    if constexpr (detail::StoredAlike<ObjectRef, Other>) {
      using detail::CursorOf;
      const detail::CopyStored<typename Accessors::Cursor, typename Other::Cursor> copy{CursorOf::reference(*this),
                                                                                        CursorOf::reference(other)};
      detail::move_all_stored(copy, 0, 0, typename Accessors::Record::fields_(), typename Other::Record::fields_());
    } else {
      this->put(other.get());
    }
    return *this;
  }
};

namespace detail {

/// The reference that stands on a cursor, with as few arguments as name it.
template <class Object, class Real, class Formats, class Cursor>
struct RefOf {
  using type = ObjectRef<Object, Real, void, void, Formats, Cursor>;
};
template <class Byte, class Real>
using RealIn = std::conditional_t<std::is_const_v<Byte>, const Real, Real>;
template <class Cursor, class Object, class Real, class Layout, class Formats, class I>
concept InArrayOf = std::same_as<Cursor, CursorIn<Object, Real, Layout, Formats, I>>;
template <class Formats, class Object>
concept OfSchema = std::same_as<Formats, typename Object::template Formats<Host>>;
template <class Object, class Real, class Formats, class Byte, class Layout, RecordSize kRecord, class I>
  requires InArrayOf<Cursor<Byte, Layout, kRecord, I>, Object, RealIn<Byte, Real>, Layout, Formats, I>
struct RefOf<Object, Real, Formats, Cursor<Byte, Layout, kRecord, I>> {
  using type = ObjectRef<Object, RealIn<Byte, Real>, I, Layout, Formats>;
};
template <class Object, class Real, class Formats, class Byte, class Layout, RecordSize kRecord, class I>
  requires InArrayOf<Cursor<Byte, Layout, kRecord, I>, Object, RealIn<Byte, Real>, Layout, Formats, I> &&
           OfSchema<Formats, Object>
struct RefOf<Object, Real, Formats, Cursor<Byte, Layout, kRecord, I>> {
  using type = ObjectRef<Object, RealIn<Byte, Real>, I, Layout>;
};

}  // namespace detail

namespace detail {

/// For `auto [x, v] = view[i]`, whose names would be references with a name.
template <class Ref>
[[nodiscard]] consteval std::size_t refuse_bindings() {
  static_assert(sizeof(Ref) == 0,
                "the names of a structured binding would be references to fields, which are read later than they look: "
                "write auto [x, v] = view[i].get(), whose names are values");
  return 0;
}

}  // namespace detail

/// Exchanges the objects that two references refer to: `swap(view[i], view[j])`.
template <class Ref>
  requires ReadsAs<Ref, typename Ref::Value>
PHYSGEN_FUNCTION void swap(const Ref& a, const Ref& b) {
  if constexpr (detail::StoredAlike<Ref, Ref>) {
    using Fields = typename Ref::Record::fields_;
    const detail::SwapStored<typename Ref::Cursor> swap{detail::CursorOf::reference(a), detail::CursorOf::reference(b)};
    detail::move_all_stored(swap, 0, 0, Fields(), Fields());
  } else {
    const auto before = a.get();
    a.put(b.get());
    b.put(before);
  }
}

/// Elements that are stored as they are computed, of single objects: `swap(view[i].m(), view[j].m())`.
template <class T>
  requires std::is_arithmetic_v<T>
PHYSGEN_FUNCTION void swap(T& a, T& b) {
  const T before = a;
  a = b;
  b = before;
}

}  // namespace physgen

template <class Object, class Real, class Index, class Layout, class... Stored>
struct std::tuple_size<physgen::ObjectRef<Object, Real, Index, Layout, Stored...>> {
  static constexpr std::size_t value =
      physgen::detail::refuse_bindings<physgen::ObjectRef<Object, Real, Index, Layout, Stored...>>();
};

#pragma pop_macro("I")
