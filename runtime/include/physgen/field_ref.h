// References to fields of more than one element: assignable stand-ins for an Eigen value whose elements lie a pitch
// apart, in any storage format.
#pragma once

#include <physgen/element_ref.h>
#include <physgen/format.h>
#include <physgen/shape.h>

namespace physgen {

/// A field of one object: converts to its Eigen value and takes one by assignment. It refers to memory, so it stays
/// valid as long as the array does; copy with get().
template <class Shape, class Format, class T, class Cursor>
class FieldRef {
 public:
  using Scalar = typename Cursor::template Lanes<T>;
  using Value = typename Shape::template Value<Scalar>;

  /// @param at the object's cursor, moved to the field's first byte by nested()
  PHYSGEN_FUNCTION explicit FieldRef(const Cursor& at) : at_(at) {}
  FieldRef(const FieldRef&) = default;
  ~FieldRef() = default;

  /// The field's value.
  [[nodiscard]] PHYSGEN_FUNCTION Value get() const {
    if constexpr (format::is_quaternion<Format>) {
      const Quaternion<Scalar> q{element(0), element(1), element(2), element(3)};
      if constexpr (sizeof(typename Element::template Stored<T>) >= sizeof(T)) {
        return rotation_matrix<Scalar>(q);
      } else {
        return rotation_matrix_of_direction<Scalar>(q);
      }
    } else {
      if constexpr (joins_words) {
        if (at_.template may_read_words<T, Shape::count>()) {
          T elements[whole_words];
          at_.template load_words<T, Shape::count>(elements);
          return Shape::template value<Scalar>(elements);
        }
      }
      return Shape::template value<Scalar>(*this);
    }
  }
  PHYSGEN_FUNCTION operator Value() const { return get(); }  // NOLINT: implicit as a reference's conversion is

  /// Stores `value`.
  PHYSGEN_FUNCTION const FieldRef& operator=(const Value& value) const {
    if constexpr (format::is_quaternion<Format>) {
      at_.check_rotation(value);
      const Quaternion<Scalar> q = unit_quaternion<Scalar>(value);
      PHYSGEN_UNROLL
      for (int k = 0; k < 4; ++k) at_.template element<Element, T>(0, k) = Scalar(q[k]);
    } else {
      if constexpr (joins_words) {
        if (at_.template may_write_words<T, Shape::count>()) {
          T elements[whole_words] = {};
          Shape::template store<Scalar>(value, static_cast<T*>(elements));
          at_.template store_words<T, Shape::count>(elements);
          return *this;
        }
      }
      Shape::template store<Scalar>(value, *this);
    }
    return *this;
  }
  PHYSGEN_FUNCTION const FieldRef& operator=(const FieldRef& other) const { return *this = other.get(); }

  /// Element k in storage order: T& where memory holds T (const T& in a read-only array), else a stand-in.
  PHYSGEN_FUNCTION decltype(auto) operator[](int k) const {
    static_assert(!format::is_quaternion<Format>,
                  "a rotation stored as a quaternion has no single elements; read it with get(), assign it as a whole");
    return at_.template element<Format, T>(0, k);
  }

  /// The stored element at row r, column c (of a vector: element r). Skew: r > c only.
  PHYSGEN_FUNCTION decltype(auto) operator()(int r, int c = 0) const { return (*this)[Shape::index(r, c)]; }

 private:
  using Element = format::ElementFormat<Format>;
  static constexpr bool joins_words = format::is_plain<Format, T> && Cursor::template joins_words<T, Shape::count>;
  static constexpr int whole_words = align_up(Shape::count * int{sizeof(T)}, 16) / int{sizeof(T)};
  [[nodiscard]] PHYSGEN_FUNCTION Scalar element(int k) const { return at_.template element<Element, T>(0, k); }

  Cursor at_;
};

}  // namespace physgen
