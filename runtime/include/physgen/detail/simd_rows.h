// Rows of packs: see rows.h. All lanes take their k-th entry at once.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/transposed.h>
#include <physgen/rows.h>
#include <physgen/simd/simd_lanes.h>

#include <bit>

namespace physgen {

namespace detail {

template <AnyPack I>
struct RowVisit<I> {
  static constexpr int W = I::width;

  // With the compiler's own vectors: without optimization xsimd 8.1 has no comparison of integers for AVX-512. Nothing
  // goes by way of memory in lanes: a register that is loaded from them waits until all that was stored before is done.
  template <class T, class Ranges, class Entries, class Index, class Body>
  [[gnu::flatten]] static void each(const Ranges& ranges, const Entries& entries, const Index& i, const Body& body) {
    using Integers = batch_t<std::int32_t, W>;
    using Numbers = batch_t<T, W>;
    using Lanes = register_t<std::int32_t, W>;
    const auto range = ranges[i];
    const Integers begin = range.begin(), end = range.end();
    const auto begins = std::bit_cast<Lanes>(begin), lengths = std::bit_cast<Lanes>(Integers(end - begin));
    // The longest row has an entry at every step: lanes without one read that one.
    const LaneRange lanes = lane_range(i);
    int longest = lanes.first;
    // Lanes outside the range repeat one inside, also here: so they hold what that one holds, and agree with it.
    for (int l = 0; l < W; ++l) {
      if (lengths[l] > lengths[longest]) longest = l;
    }
    const std::int32_t steps = lengths[longest];
    const Lanes spare = Lanes{} + begins[longest];
    for (std::int32_t k = 0; k < steps; ++k) {
      const Lanes has_one = lengths > Lanes{} + k;  // -1 where it has, 0 elsewhere
      const Lanes entry = ((begins & has_one) | (spare & ~has_one)) + k;
#ifdef PHYSGEN_CHECKED
      std::uint64_t used = 0;
      for (int l = 0; l < W; ++l) used |= std::uint64_t{has_one[l] != 0} << l;
      const RunStep runs(of_lanes(used));  // a lane without an entry races with none
#endif
      body(entries[std::bit_cast<Integers>(entry)],
           std::bit_cast<Numbers>(__builtin_convertvector(has_one, register_t<T, W>)) < Numbers(T(0)));
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

#pragma pop_macro("I")
