// References to fields of more than one element: assignable stand-ins for an Eigen value whose elements lie a pitch
// apart, in any storage format. Read as temporaries only, as element_ref.h explains; elements of a named one are read
// by their numbers.
#pragma once

#include <physgen/detail/deleted.h>
#include <physgen/fields/checks.h>
#include <physgen/fields/element_ref.h>
#include <physgen/fields/shape.h>
#include <physgen/format.h>
#include <physgen/kernels/matrix_value.h>

#include <initializer_list>

namespace physgen {

/// A field of one object, or of those of a pack: converts to its Eigen value and takes one by assignment. It refers to
/// memory, so it stays valid as long as the array does; copy with get().
template <class Shape, class Format, class T, class Cursor>
class FieldRef {
  static constexpr bool is_rotation = std::is_same_v<Shape, shape::Rotation>;
  static constexpr bool calculates = !is_rotation && !Cursor::gathered;

 public:
  using Scalar = typename Cursor::template Lanes<T>;
  using Value = typename Shape::template Value<Scalar>;
  using Loaded = detail::ValueOf<Value>;
  using Lanes = Scalar;  ///< one element's
  static constexpr bool of_a_local = requires { requires Cursor::of_a_local; };

  /// @param at the object's cursor, moved to the field's first byte by nested()
  PHYSGEN_FUNCTION explicit FieldRef(const Cursor& at) : at_(at) {}
  FieldRef(const FieldRef&) = default;
  ~FieldRef() = default;

  /// The field's value. For temporaries only: `const auto x = view[i].x().get();`.
  [[nodiscard]] PHYSGEN_FUNCTION const Loaded get() const&& { return read(); }
  PHYSGEN_FUNCTION operator Loaded() const&& { return read(); }  // NOLINT: implicit as a reference's conversion is
  PHYSGEN_FUNCTION operator Value() const&& { return read(); }   // NOLINT: implicit as a reference's conversion is
  detail::a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself get() const& PHYSGEN_DELETED(
      a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself);
  template <class Why = detail::a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself>
  operator Loaded() const& PHYSGEN_DELETED(a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself);
  template <class Why = detail::a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself>
  operator Value() const& PHYSGEN_DELETED(a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself);

  /// Stores `value`.
  PHYSGEN_FUNCTION const FieldRef& operator=(const Value& value) const& { return write(value); }
  /// Copies the field, with the bits that are stored.
  PHYSGEN_FUNCTION const FieldRef& operator=(const FieldRef&& other) const& {
    if constexpr (detail::field_assigns_stored<Format, T, Cursor, Cursor>) return copy(other.at_);
    return write(other.read());
  }
  template <class Other>
    requires(detail::field_assigns_stored<Format, T, Cursor, Other> &&
             std::is_same_v<typename Other::template Lanes<T>, Scalar>)
  PHYSGEN_FUNCTION const FieldRef& operator=(const FieldRef<Shape, Format, T, Other>&& other) const& {
    return copy(other.at_);
  }
  PHYSGEN_COMPOUND_ASSIGNMENT(FieldRef, +, Value, calculates)
  PHYSGEN_COMPOUND_ASSIGNMENT(FieldRef, -, Value, calculates)
  PHYSGEN_COMPOUND_ASSIGNMENT(FieldRef, *, Scalar, calculates)
  PHYSGEN_COMPOUND_ASSIGNMENT(FieldRef, /, Scalar, calculates)
#undef PHYSGEN_COMPOUND_ASSIGNMENT
  PHYSGEN_FUNCTION const FieldRef& setZero() const&
    requires(!is_rotation)
  {
    return write(Value::Constant(Scalar(T(0))));
  }
  PHYSGEN_FUNCTION const FieldRef& setIdentity() const&
    requires is_rotation
  {
    Value identity = Value::Constant(Scalar(T(0)));
    for (int k = 0; k < 3; ++k) identity(k, k) = Scalar(T(1));
    return write(identity);
  }
  PHYSGEN_FUNCTION friend void swap(const FieldRef& a, const FieldRef& b) {
    if constexpr (detail::field_assigns_stored<Format, T, Cursor, Cursor>) {
      detail::move_stored(detail::SwapStored<Cursor>{a.at_, b.at_}, 0, 0, StoredAs<Shape, Format, T>());
    } else {
      const Value old = a.read();
      a.write(b.read());
      b.write(old);
    }
  }

  /// `= {}` would store an Eigen value that nothing has initialised.
  void operator=(std::initializer_list<detail::an_empty_value_so_use_setZero>) const& PHYSGEN_DELETED(
      an_empty_value_so_use_setZero);

  FieldRef& operator=(const FieldRef&) & = delete;
  detail::a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself operator=(const FieldRef&) const& =
      delete;
  detail::a_named_reference_is_not_assigned_so_write_to_the_view_itself operator=(const Value&) &
      PHYSGEN_DELETED(a_named_reference_is_not_assigned_so_write_to_the_view_itself);

  /// Element k in storage order: T& where memory holds T (const T& in a read-only array), else a stand-in.
  /// @pre 0 <= k < the number of stored elements
  PHYSGEN_FUNCTION decltype(auto) operator[](int k) const {
    static_assert(!format::is_quaternion<Format>,
                  "a rotation stored as a quaternion has no single elements; read it with get(), assign it as a whole");
    check_inner(k, Shape::count, "an element of a field");
    return at_.template element<Format, T>(0, k);
  }

  /// The stored element at row r, column c (of a vector: element r). Skew: r > c only.
  PHYSGEN_FUNCTION decltype(auto) operator()(int r, int c = 0) const {
    check_inner(r, Value::RowsAtCompileTime, "a row of a field");
    check_inner(c, Value::ColsAtCompileTime, "a column of a field");
    if constexpr (Shape::is_skew)
      check_inner(r > c ? 0 : -1, 1, "a skew-symmetric matrix's elements with row > column");
    return (*this)[Shape::index(r, c)];
  }

  /// Stores those lanes of `value` whose bits are set in `lanes`; see store_where(). For packs.
  void write_where(std::uint64_t lanes, const Value& value) const {
    detail::refuse_masks<FieldRef>();
    if constexpr (format::is_quaternion<Format>) {
      at_.check_rotation(value, lanes);
      const Quaternion<Scalar> q = unit_quaternion<Scalar>(value);
      for (int k = 0; k < 4; ++k) at_.template store_where<Element, T>(0, k, q[k], lanes);
    } else {
      Scalar elements[Shape::count];
      Shape::template store<Scalar>(value, static_cast<Scalar*>(elements));
      for (int k = 0; k < Shape::count; ++k) at_.template store_where<Format, T>(0, k, elements[k], lanes);
    }
  }
  /// Adds atomically; see add().
  template <class Range>
  PHYSGEN_FUNCTION void add(const Range& range, const Value& value) const {
    detail::refuse_sums<FieldRef>();
    static_assert(!is_rotation, "the sum of two rotations is not a rotation");
    if constexpr (format::is_probe<Format>) {
      write(Value(read() + value));
    } else {
      Scalar elements[Shape::count];
      Shape::template store<Scalar>(value, static_cast<Scalar*>(elements));
      at_.template add<Format, T, Shape::count>(range, 0, 0, static_cast<const Scalar*>(elements));
    }
  }

 private:
  template <class, class, class, class>
  friend class FieldRef;
  using Element = format::ElementFormat<Format>;
  static constexpr bool joins_words = format::is_plain<Format, T> && Cursor::template joins_words<T, Shape::count>;
  static constexpr int whole_words = align_up(Shape::count * int{sizeof(T)}, 16) / int{sizeof(T)};
  [[nodiscard]] PHYSGEN_FUNCTION Scalar element(int k) const { return at_.template element<Element, T>(0, k); }

  /// The elements by number, without the check of operator[].
  struct Elements {
    const Cursor& at;
    PHYSGEN_FUNCTION decltype(auto) operator[](int k) const { return at.template element<Format, T>(0, k); }
  };

  [[nodiscard]] PHYSGEN_FUNCTION Value read() const {
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
          Scalar elements[whole_words];
          at_.template load_words<T, Shape::count>(elements);
          return Shape::template value<Scalar>(elements);
        }
      }
      return Shape::template value<Scalar>(Elements{at_});
    }
  }

  template <class Other>
  PHYSGEN_FUNCTION const FieldRef& copy(const Other& from) const {
    detail::move_stored(detail::CopyStored<Cursor, Other>{at_, from}, 0, 0, StoredAs<Shape, Format, T>());
    return *this;
  }

  PHYSGEN_FUNCTION const FieldRef& write(const Value& value) const {
    if constexpr (format::is_quaternion<Format>) {
      at_.check_rotation(value);
      const Quaternion<Scalar> q = unit_quaternion<Scalar>(value);
      PHYSGEN_UNROLL
      for (int k = 0; k < 4; ++k) at_.template element<Element, T>(0, k) = Scalar(q[k]);
    } else {
      if constexpr (joins_words && std::is_same_v<Scalar, T>) {
        if (at_.template may_write_words<T, Shape::count>()) {
          T elements[whole_words] = {};
          Shape::template store<Scalar>(value, static_cast<T*>(elements));
          at_.template store_words<T, Shape::count>(elements);
          return *this;
        }
      }
      Shape::template store<Scalar>(value, Elements{at_});
    }
    return *this;
  }

  Cursor at_;
};

namespace detail {

template <class T>
inline constexpr bool is_field_ref = false;
template <class Shape, class Format, class T, class Cursor>
inline constexpr bool is_field_ref<FieldRef<Shape, Format, T, Cursor>> = true;

template <class A, class B = int>
concept SomeFieldReference = is_field_ref<std::remove_cvref_t<A>> || is_field_ref<std::remove_cvref_t<B>>;

struct a_field_is_no_value_so_calculate_with_what_its_get_returns {};  // complete: clang 14 asks for that

}  // namespace detail

/// Exchanges fields of one shape that are stored in two formats.
template <class Shape, class FormatA, class FormatB, class T, class CursorA, class CursorB>
  requires(!std::is_same_v<FormatA, FormatB>)
PHYSGEN_FUNCTION void swap(FieldRef<Shape, FormatA, T, CursorA>&& a, FieldRef<Shape, FormatB, T, CursorB>&& b) {
  const auto old = std::move(a).get();
  std::move(a) = std::move(b).get();
  std::move(b) = old;
}

// Fields do not calculate; PHYSGEN_REFUSED_OPERATOR is undefined below.
#define PHYSGEN_REFUSED_OPERATOR(op)                                                       \
  template <class A, class B>                                                              \
    requires detail::SomeFieldReference<A, B>                                              \
  detail::a_field_is_no_value_so_calculate_with_what_its_get_returns operator op(A&&, B&&) \
      PHYSGEN_DELETED(a_field_is_no_value_so_calculate_with_what_its_get_returns);
PHYSGEN_REFUSED_OPERATOR(+)
PHYSGEN_REFUSED_OPERATOR(-)
PHYSGEN_REFUSED_OPERATOR(*)
PHYSGEN_REFUSED_OPERATOR(/)
#undef PHYSGEN_REFUSED_OPERATOR
template <detail::SomeFieldReference A>
detail::a_field_is_no_value_so_calculate_with_what_its_get_returns operator-(A&&)
    PHYSGEN_DELETED(a_field_is_no_value_so_calculate_with_what_its_get_returns);

}  // namespace physgen
