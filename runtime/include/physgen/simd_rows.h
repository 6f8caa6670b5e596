// Rows of packs: see rows.h. All lanes take their k-th entry at once.
#pragma once

#include <physgen/rows.h>
#include <physgen/simd_lanes.h>

namespace physgen {

namespace detail {

/// Which rows of W have a k-th entry, as masks of lanes of T.
template <class T, int W>
class RowLengths {
 public:
  explicit RowLengths(const batch_t<std::int32_t, W>& lengths) {
    if constexpr (is_double) {
      alignas(64) std::array<std::int32_t, W> lanes;
      alignas(64) std::array<double, W> numbers;
      lengths.store_aligned(lanes.data());
      for (std::size_t l = 0; l < W; ++l) numbers[l] = lanes[l];
      lengths_ = batch_t<double, W>::load_aligned(numbers.data());
    } else {
      lengths_ = lengths;
    }
  }
  [[nodiscard]] typename batch_t<T, W>::batch_bool_type have(std::int32_t k) const {
    if constexpr (std::is_same_v<T, float>) {
      // A length may be no float, so the mask is made of integers: all bits set are a NaN.
      using Integers = batch_t<std::int32_t, W>;
      const Integers bits = xsimd::select(lengths_ > Integers(k), Integers(-1), Integers(0));
      const auto floats = xsimd::bitwise_cast<batch_t<float, W>>(bits);
      return xsimd::isnan(floats);
    } else {
      return lengths_ > batch_t<T, W>(static_cast<T>(k));
    }
  }

 private:
  static constexpr bool is_double = std::is_same_v<T, double>;
  static_assert(is_double || std::is_same_v<T, float> || std::is_same_v<T, std::int32_t>);
  batch_t<std::conditional_t<is_double, double, std::int32_t>, W> lengths_;
};

template <AnyPack I>
struct RowVisit<I> {
  static constexpr int W = I::width;
  using Integers = batch_t<std::int32_t, W>;

  template <class T, class Ranges, class Entries, class Body>
  [[gnu::flatten]] static void each(const Ranges& ranges, const Entries& entries, const I& i, const Body& body) {
    const auto range = ranges[i];
    const Integers begin = range.begin(), end = range.end();
    const Integers lengths = xsimd::select(wanted<std::int32_t>(i), end - begin, Integers(0));
    const std::int32_t longest = largest(i, lengths);
    if (longest <= 0) return;
    // The longest row has an entry at every step: lanes without one read that one.
    alignas(64) std::array<std::int32_t, W> begins, counts;
    begin.store_aligned(begins.data());
    lengths.store_aligned(counts.data());
    std::size_t last = 0;
    while (counts[last] != longest) ++last;
    const Integers of_longest(begins[last]);
    const RowLengths<std::int32_t, W> integers(lengths);
    const RowLengths<T, W> numbers(lengths);
    for (std::int32_t k = 0; k < longest; ++k) {
      const Integers at = xsimd::select(integers.have(k), begin, of_longest) + Integers(k);
      body(entries[at], numbers.have(k));
    }
  }

  /// to = active ? value : to, per lane.
  template <class Mask, class Value>
  static void replace_where(const Mask& active, Value& to, const Value& value) {
    if constexpr (requires { typename Value::PlainObject; }) {
      for (Eigen::Index k = 0; k < to.size(); ++k) replace_where(active, to.coeffRef(k), value.coeff(k));
    } else {
      to = xsimd::select(active, value, to);
    }
  }
};

}  // namespace detail

}  // namespace physgen
