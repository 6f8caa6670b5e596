// References to fields of more than one element: assignable stand-ins for an Eigen value whose elements lie a pitch
// apart.
#pragma once

#include <physgen/shape.h>

namespace physgen {

/// A field of one object: converts to its Eigen value and takes one by assignment. It refers to memory, so it stays
/// valid as long as the array does; copy with get().
template <class Shape, class T, class Cursor>
class FieldRef {
 public:
  using Scalar = typename Cursor::template Lanes<T>;
  using Value = typename Shape::template Value<Scalar>;

  /// @param at the object's cursor, moved to the field's first byte by nested()
  PHYSGEN_FUNCTION explicit FieldRef(const Cursor& at) : at_(at) {}
  FieldRef(const FieldRef&) = default;
  ~FieldRef() = default;

  /// The field's value.
  [[nodiscard]] PHYSGEN_FUNCTION Value get() const { return Shape::template value<Scalar>(*this); }
  PHYSGEN_FUNCTION operator Value() const { return get(); }  // NOLINT: implicit as a reference's conversion is

  /// Stores `value`.
  PHYSGEN_FUNCTION const FieldRef& operator=(const Value& value) const {
    Shape::template store<Scalar>(value, *this);
    return *this;
  }
  PHYSGEN_FUNCTION const FieldRef& operator=(const FieldRef& other) const { return *this = other.get(); }

  /// Element k in storage order: T& (const T& in a read-only array), or a stand-in for W of them under a SIMD index.
  PHYSGEN_FUNCTION decltype(auto) operator[](int k) const { return at_.template element<T>(0, k); }

  /// The stored element at row r, column c (of a vector: element r). Skew: r > c only.
  PHYSGEN_FUNCTION decltype(auto) operator()(int r, int c = 0) const { return (*this)[Shape::index(r, c)]; }

 private:
  Cursor at_;
};

}  // namespace physgen
