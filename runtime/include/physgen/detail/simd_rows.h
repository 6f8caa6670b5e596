// Rows of packs: see rows.h. All lanes take their k-th entry at once.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/rows.h>
#include <physgen/simd_lanes.h>

namespace physgen {

namespace detail {

template <AnyPack I>
struct RowVisit<I> {
  static constexpr int W = I::width;

  // Lane by lane where integers are compared: compilers vectorise these loops, and without optimization xsimd 8.1 has
  // no comparison of integers for AVX-512.
  template <class T, class Ranges, class Entries, class Index, class Body>
  [[gnu::flatten]] static void each(const Ranges& ranges, const Entries& entries, const Index& i, const Body& body) {
    using Integers = batch_t<std::int32_t, W>;
    using Numbers = batch_t<T, W>;
    const auto range = ranges[i];
    const Integers begin = range.begin(), end = range.end();
    alignas(64) std::array<std::int32_t, W> begins, lengths;
    begin.store_aligned(begins.data());
    Integers(end - begin).store_aligned(lengths.data());
    // The longest row has an entry at every step: lanes without one read that one.
    const LaneRange lanes = lane_range(i);
    int longest = lanes.first;
    // Lanes outside the range repeat one inside, also here: so they hold what that one holds, and agree with it.
    for (int l = 0; l < W; ++l) {
      if (at(lengths, l) > at(lengths, longest)) longest = l;
    }
    const std::int32_t steps = at(lengths, longest), spare = at(begins, longest);
    for (std::int32_t k = 0; k < steps; ++k) {
      alignas(64) std::array<std::int32_t, W> entry;
      alignas(64) std::array<T, W> active;
      [[maybe_unused]] std::uint64_t used = 0;
      for (int l = 0; l < W; ++l) {
        const bool has_one = k < at(lengths, l);
        if constexpr (checked_build) used |= std::uint64_t{has_one} << l;
        at(entry, l) = (has_one ? at(begins, l) : spare) + k;
        at(active, l) = static_cast<T>(has_one);
      }
#ifdef PHYSGEN_CHECKED
      const RunStep runs(of_lanes(used));  // a lane without an entry races with none
#endif
      body(entries[Integers::load_aligned(entry.data())], Numbers::load_aligned(active.data()) > Numbers(T(0)));
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

 private:
  template <class T>
  [[nodiscard]] static T& at(std::array<T, W>& lanes, int l) {
    return lanes[static_cast<std::size_t>(l)];
  }
};

}  // namespace detail

}  // namespace physgen

#pragma pop_macro("I")
