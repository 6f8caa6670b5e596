// A stand-in for one stored element, or for those of a SIMD pack, where no plain C++ reference exists: it converts
// to the value that code computes with, calculates, and takes a value by assignment.
//
// `auto x = view[i].m()` would be a number for one object and a stand-in, read later, for a pack. So only temporaries
// are read, and only temporaries and constants are assigned: what compiles means the same for every index and format.
#pragma once

#include <physgen/detail/deleted.h>
#include <physgen/detail/reference_rules.h>
#include <physgen/detail/stored_copy.h>
#include <physgen/format/probe_traits.h>

#include <type_traits>
#include <utility>

namespace physgen {

// One compound assignment of a reference `Ref`, such as `+=`, of a `Value` or, for a field that is scaled, a number. A
// pack of integers would cut a floating number down before it calculates, gathered lanes may name one object, and a
// named reference is not assigned: these are refused. field_ref.h undefines it.
#define PHYSGEN_COMPOUND_ASSIGNMENT(Ref, op, Operand, calculates)                                                     \
  PHYSGEN_FUNCTION const Ref& operator op## = (const Operand& value) const&                                           \
    requires(calculates)                                                                                              \
  {                                                                                                                   \
    return write(Value(read() op value));                                                                             \
  }                                                                                                                   \
  template <class Number>                                                                                             \
    requires(std::is_integral_v<T> && std::is_floating_point_v<Number>)                                               \
  detail::integers_calculate_with_integers_so_convert_first operator op## =                                           \
      (Number) const & PHYSGEN_DELETED(integers_calculate_with_integers_so_convert_first);                            \
  detail::a_named_reference_is_not_assigned_so_write_to_the_view_itself operator op## =                               \
      (const Operand&)&PHYSGEN_DELETED(a_named_reference_is_not_assigned_so_write_to_the_view_itself);                \
  detail::lanes_may_name_one_object_twice_so_use_add_of_the_kernels_own_index operator op## = (const Operand&) const& \
    requires(Cursor::gathered)                                                                                        \
  PHYSGEN_DELETED(lanes_may_name_one_object_twice_so_use_add_of_the_kernels_own_index);

/// @tparam Format of the element (format.h)
/// @tparam T the type computed with
/// @tparam Cursor stands on the object(s)
template <class Format, class T, class Cursor>
class ElementRef {
 public:
  using Value = typename Cursor::template Lanes<T>;
  using Lanes = Value;  ///< one element's
  using Element = T;    ///< of one object
  static constexpr bool of_a_local = requires { requires Cursor::of_a_local; };

  /// @param offset of the first element of its run in the record [bytes]
  /// @param k which element of the run
  PHYSGEN_FUNCTION ElementRef(const Cursor& at, int offset, int k) : at_(at), offset_(offset), k_(k) {}
  ElementRef(const ElementRef&) = default;
  ~ElementRef() = default;

  /// The value. For temporaries only: `const S m = view[i].m();`.
  [[nodiscard]] PHYSGEN_FUNCTION detail::ReadValue<Value> get() const&& { return read(); }
  PHYSGEN_FUNCTION operator Value() const&& { return read(); }  // NOLINT: implicit as a reference's conversion is
  detail::a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself get() const& PHYSGEN_DELETED(
      a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself);
  template <class Why = detail::a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself>
  operator Value() const& PHYSGEN_DELETED(a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself);

  PHYSGEN_FUNCTION const ElementRef& operator=(const Value& value) const& { return write(value); }
  /// Copies the element, with the bits that are stored.
  PHYSGEN_FUNCTION const ElementRef& operator=(const ElementRef&& other) const& {
    if constexpr (detail::field_assigns_stored<Format, T, Cursor, Cursor>) return copy(other);
    return write(other.read());
  }
  template <class Other>
    requires(detail::field_assigns_stored<Format, T, Cursor, Other> &&
             std::is_same_v<typename Other::template Lanes<T>, Value>)
  PHYSGEN_FUNCTION const ElementRef& operator=(const ElementRef<Format, T, Other>&& other) const& {
    return copy(other);
  }
  PHYSGEN_COMPOUND_ASSIGNMENT(ElementRef, +, Value, !Cursor::gathered)
  PHYSGEN_COMPOUND_ASSIGNMENT(ElementRef, -, Value, !Cursor::gathered)
  PHYSGEN_COMPOUND_ASSIGNMENT(ElementRef, *, Value, !Cursor::gathered)
  PHYSGEN_COMPOUND_ASSIGNMENT(ElementRef, /, Value, !Cursor::gathered)
  PHYSGEN_FUNCTION friend void swap(const ElementRef& a, const ElementRef& b) {
    if constexpr (detail::field_assigns_stored<Format, T, Cursor, Cursor>) {
      const auto old = a.stored(), other = b.stored();
      a.at_.template store_stored<Format, T>(a.offset_, a.k_, other);
      b.at_.template store_stored<Format, T>(b.offset_, b.k_, old);
    } else {
      const Value old = a.read();
      a.write(b.read());
      b.write(old);
    }
  }

  ElementRef& operator=(const ElementRef&) & = delete;
  detail::a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself operator=(
      const ElementRef&) const& PHYSGEN_DELETED(a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself);
  detail::a_named_reference_is_not_assigned_so_write_to_the_view_itself operator=(const Value&) &
      PHYSGEN_DELETED(a_named_reference_is_not_assigned_so_write_to_the_view_itself);

  /// The address of a probe's element, which any code may read and write. Nothing lies there.
  PHYSGEN_FUNCTION auto operator&() const&&
    requires(format::is_probe<Format>)
  {
    return at_.template address_of<Format, T>(offset_, k_);
  }

  /// Stores those lanes of `value` whose bits are set in `lanes`; see store_where() and add(). For packs.
  void write_where(std::uint64_t lanes, const Value& value) const {
    detail::refuse_masks<ElementRef>();
    at_.template store_where<Format, T>(offset_, k_, value, lanes);
  }
  /// Adds atomically; see add().
  template <class Range>
  PHYSGEN_FUNCTION void add(const Range& range, const Value& value) const {
    detail::refuse_sums<ElementRef>();
    if constexpr (format::is_probe<Format>) {
      write(Value(read() + value));
    } else {
      at_.template add<Format, T, 1>(range, offset_, k_, &value);
    }
  }

 private:
  template <class, class, class>
  friend class ElementRef;
  [[nodiscard]] PHYSGEN_FUNCTION auto stored() const { return at_.template load_stored<Format, T>(offset_, k_); }
  template <class Other>
  PHYSGEN_FUNCTION const ElementRef& copy(const ElementRef<Format, T, Other>& other) const {
    at_.template store_stored<Format, T>(offset_, k_, other.stored());
    return *this;
  }
  [[nodiscard]] PHYSGEN_FUNCTION Value read() const { return at_.template load<Format, T>(offset_, k_); }
  PHYSGEN_FUNCTION const ElementRef& write(const Value& value) const {
    at_.template store<Format, T>(offset_, k_, value);
    return *this;
  }

  Cursor at_;
  int offset_;
  int k_;
};

namespace detail {

/// Plain numbers that are wider than the lanes of a reference's value. Those of one object are plain numbers, too.
template <class Ref, class Number>
concept WiderThanLanes = Wider<typename std::remove_cvref_t<Ref>::Element, Number> &&
                         !std::is_arithmetic_v<typename std::remove_cvref_t<Ref>::Value>;

}  // namespace detail

// Arithmetic and comparison of references read from a view, among themselves and with anything that calculates with
// their values. PHYSGEN_ELEMENT_OPERATOR is undefined below.
#define PHYSGEN_ELEMENT_OPERATOR(op)                                                                          \
  template <class A, class B>                                                                                 \
    requires((detail::ElementReference<A> || detail::ElementReference<B>) && !detail::NamedReference<A, B> && \
             requires(detail::Operand<A> a, detail::Operand<B> b) { a op b; })                                \
  PHYSGEN_FUNCTION auto operator op(A&& a, B&& b) {                                                           \
    return detail::operand(std::forward<A>(a)) op detail::operand(std::forward<B>(b));                        \
  }                                                                                                           \
  template <class A, class B>                                                                                 \
    requires detail::NamedReference<A, B>                                                                     \
  detail::a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself operator op(A&&, B&&)         \
      PHYSGEN_DELETED(a_named_reference_is_read_later_than_it_looks_so_read_the_view_itself);
PHYSGEN_ELEMENT_OPERATOR(+)
PHYSGEN_ELEMENT_OPERATOR(-)
PHYSGEN_ELEMENT_OPERATOR(*)
PHYSGEN_ELEMENT_OPERATOR(/)
PHYSGEN_ELEMENT_OPERATOR(<)
PHYSGEN_ELEMENT_OPERATOR(<=)
PHYSGEN_ELEMENT_OPERATOR(>)
PHYSGEN_ELEMENT_OPERATOR(>=)
PHYSGEN_ELEMENT_OPERATOR(==)
PHYSGEN_ELEMENT_OPERATOR(!=)
#undef PHYSGEN_ELEMENT_OPERATOR

// A double beside the floats of a reference, which is refused as beside their values; the argument of the template is
// what nvcc prints. PHYSGEN_REFUSED_OPERATOR and PHYSGEN_REFUSED_ASSIGNMENT are undefined below.
#define PHYSGEN_REFUSED_OPERATOR(op)                                                               \
  template <detail::ElementReference A, class Number,                                              \
            class = detail::a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it>       \
    requires detail::WiderThanLanes<A, Number>                                                     \
  detail::a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it operator op(A&&, Number) \
      PHYSGEN_DELETED(a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it);            \
  template <class Number, detail::ElementReference A,                                              \
            class = detail::a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it>       \
    requires detail::WiderThanLanes<A, Number>                                                     \
  detail::a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it operator op(Number, A&&) \
      PHYSGEN_DELETED(a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it);
#define PHYSGEN_REFUSED_ASSIGNMENT(op)                                                             \
  template <detail::ElementReference A, class Number,                                              \
            class = detail::a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it>       \
    requires detail::Wider<typename std::remove_cvref_t<A>::Element, Number>                       \
  detail::a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it operator op(A&&, Number) \
      PHYSGEN_DELETED(a_double_beside_floats_has_other_bits_in_packs_so_write_S_of_it);
PHYSGEN_REFUSED_OPERATOR(+)
PHYSGEN_REFUSED_OPERATOR(-)
PHYSGEN_REFUSED_OPERATOR(*)
PHYSGEN_REFUSED_OPERATOR(/)
PHYSGEN_REFUSED_OPERATOR(<)
PHYSGEN_REFUSED_OPERATOR(<=)
PHYSGEN_REFUSED_OPERATOR(>)
PHYSGEN_REFUSED_OPERATOR(>=)
PHYSGEN_REFUSED_OPERATOR(==)
PHYSGEN_REFUSED_OPERATOR(!=)
PHYSGEN_REFUSED_ASSIGNMENT(+=)
PHYSGEN_REFUSED_ASSIGNMENT(-=)
PHYSGEN_REFUSED_ASSIGNMENT(*=)
PHYSGEN_REFUSED_ASSIGNMENT(/=)
#undef PHYSGEN_REFUSED_ASSIGNMENT
#undef PHYSGEN_REFUSED_OPERATOR

/// Exchanges elements that are stored in two formats.
template <detail::ElementReference A, detail::ElementReference B>
  requires(!std::is_same_v<std::remove_cvref_t<A>, std::remove_cvref_t<B>>)
PHYSGEN_FUNCTION void swap(A&& a, B&& b) {
  const auto old = detail::operand(std::forward<A>(a));
  std::forward<A>(a) = detail::operand(std::forward<B>(b));
  std::forward<B>(b) = old;
}

template <detail::ElementReference A>
PHYSGEN_FUNCTION auto operator-(A&& a) {
  return -detail::operand(std::forward<A>(a));
}

}  // namespace physgen
