// The common part of all references to objects of an array. Generated code adds the accessors of the fields.
#pragma once

#include <physgen/config.h>

#include <concepts>
#include <type_traits>

namespace physgen {

/// References to objects that are read as `Value`: of any layout and format.
template <class Ref, class Value>
concept ReadsAs = requires(const Ref& ref) {
  { ref.get() } -> std::same_as<const Value>;
};

/// A type that says how a field is stored: with this shape, in this format, computed with as T.
template <class Shape, class Format, class T>
struct StoredAs {};
/// The same of a nested object. @tparam Object its generated tag
template <class Object, class Formats, class Real>
struct NestedAs {};

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
  Cursor at_;
};

/// A reference to one object of an array, or to those under a SIMD index. Assignment copies objects, as
/// `view[i] = view[j]` looks; a named reference that is not const is not assigned, because std::swap and algorithms
/// would take it for a value.
/// @tparam Accessors a generated class such as elasticity::StressRef<float, Formats, Cursor>: a function for each
/// field,
///         and get() and put() for all of them
template <class Accessors>
class ObjectRef : public Accessors {
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
    this->put(other.get());
    return *this;
  }
};

/// Exchanges the objects that two references refer to: `swap(view[i], view[j])`.
template <class Ref>
  requires ReadsAs<Ref, typename Ref::Value>
PHYSGEN_FUNCTION void swap(const Ref& a, const Ref& b) {
  const auto before = a.get();
  a.put(b.get());
  b.put(before);
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
