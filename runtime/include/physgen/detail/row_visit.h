// Visits and sums the entries of rows.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/arrays/view.h>

#include <type_traits>

namespace physgen::detail {

/// The index of an entry of a row: index_t, or where numbers are checked (check_numbers.h) the row's own.
template <class I>
using EntryIndex = std::conditional_t<std::is_signed_v<I>, index_t, I>;

/// Visits the entries of the row(s) at an index of type I. simd_rows.h has the form for packs.
template <class I>
struct RowVisit {
  static_assert(std::is_integral_v<I>, "rows of packs need <physgen/parallel_for.h>; a gathered index has no rows");

  /// @tparam Index I, or an Own that holds one
  template <class T, class Ranges, class Entries, class Index, class Body>
  [[gnu::flatten]] PHYSGEN_FUNCTION static void each(const Ranges& ranges, const Entries& entries, const Index& i,
                                                     const Body& body) {
    const auto range = ranges[i];
    const index_t begin = range.begin(), end = range.end();
    for (index_t k = begin; k < end; ++k) body(entries[static_cast<EntryIndex<I>>(k)], true);
  }
};

/// The same objects, to be read.
template <class Object, class Real, class Layout, class Formats, class Space>
[[nodiscard]] PHYSGEN_FUNCTION View<Object, const Real, Layout, Formats, Space> read_only(
    const View<Object, Real, Layout, Formats, Space>& view) {
  return view;
}

/// The type of a sum: a number, or a matrix of numbers, for which Eigen's expressions, such as Zero(), may stand.
template <class Value>
struct Summand {
  using type = Value;
  using Scalar = Value;
};
template <class Value>
  requires requires { typename Value::PlainObject; }
struct Summand<Value> {
  using type = typename Value::PlainObject;
  using Scalar = typename Value::Scalar;
};

/// The next total of a fold over a row, which must have the type of the total.
template <class Sum, class Next>
[[nodiscard]] PHYSGEN_FUNCTION Sum next_total(const Next& next) {
  static_assert(!std::is_arithmetic_v<Next> || std::is_same_v<Next, Sum>,
                "rows.fold(): `step` returns another type than that of `total`, to which it would be cut down");
  static_assert(returned_whole<Next>,
                "rows.fold(): `step` returns an expression of Eigen that refers to matrices of its own, which are gone "
                "by then; write its type, [&](const auto& total, const auto& entry) -> Vector { ... }");
  return next;
}

/// The same for the caller: a matrix as one that expressions hold by value.
template <class Sum>
[[nodiscard]] PHYSGEN_FUNCTION auto handed_out(const Sum& sum) {
  if constexpr (requires { typename Sum::PlainObject; }) {
    return value_of(sum);
  } else {
    return sum;
  }
}

/// @throw Error when rows that `of` names are not `size` rows of entries that name `targets` objects
void require_rows(const char* of, index_t rows, index_t row_targets, index_t size, index_t targets);

}  // namespace physgen::detail

#pragma pop_macro("I")
