// Questions that a kernel asks of its index, for packs: see lanes.h. Lanes outside the kernel's range have no say.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/simd_casts.h>
#include <physgen/kernels/lanes.h>
#include <physgen/simd/simd_access.h>

namespace physgen {

template <class T, detail::OfPack I>
[[nodiscard]] auto wanted(const I& i) {
  constexpr int W = detail::Bare<I>::width;
  using Mask = typename batch_t<T, W>::batch_bool_type;
  if constexpr (std::is_same_v<detail::Bare<I>, Pack<W>>) {
    return Mask(true);
  } else {  // By memory: without optimization, xsimd 8.1 has no comparison of integers for AVX-512.
    const LaneRange range = lane_range(i);
    alignas(64) std::array<bool, W> lanes;
    for (int l = 0; l < W; ++l) lanes[static_cast<std::size_t>(l)] = l >= range.first && l < range.last;
    return Mask::load_unaligned(lanes.data());
  }
}

template <detail::OfPack I>
[[nodiscard]] auto numbers(const I& i) {
  constexpr int W = detail::Bare<I>::width;
  using Numbers = batch_t<std::int32_t, W>;
  const auto& pack = detail::bare(i);
  detail::check_number(pack.begin + lane_range(i).last - 1);
  if constexpr (std::is_same_v<detail::Bare<I>, Pack<W>>) {
    return detail::counting<std::int32_t, W>() + Numbers(static_cast<std::int32_t>(pack.begin));
  } else {
    alignas(64) std::array<std::int32_t, W> lanes;
    for (int l = 0; l < W; ++l) {
      lanes[static_cast<std::size_t>(l)] = static_cast<std::int32_t>(pack.begin + pack.lane(l));
    }
    return Numbers::load_aligned(lanes.data());
  }
}

template <detail::OfPack I>
[[nodiscard]] auto object_of_part(index_t first, const I& i) {
  detail::check_number(first + detail::bare(i).begin + lane_range(i).last - 1);
  const auto objects = numbers(i) + static_cast<std::int32_t>(first);
  return Own<std::remove_const_t<decltype(objects)>, detail::FrameOfPart>{objects, nullptr};
}

template <detail::OfPack I, class T, class A>
[[nodiscard]] bool any(const I& i, const xsimd::batch_bool<T, A>& condition) {
  static_assert(xsimd::batch_bool<T, A>::size == std::size_t{detail::Bare<I>::width},
                "any() and all(): the condition has as many lanes as the index");
  const LaneRange range = lane_range(i);
  return (detail::bits_of(condition) >> range.first & (~std::uint64_t{0} >> (64 - (range.last - range.first)))) != 0;
}
template <detail::OfPack I, class T, class A>
[[nodiscard]] bool all(const I& i, const xsimd::batch_bool<T, A>& condition) {
  return !any(i, !condition);
}

namespace detail {

template <class I, class T, class A, class Better>
[[nodiscard]] T best(const I& i, const xsimd::batch<T, A>& value, const Better& better) {
  constexpr std::size_t width = xsimd::batch<T, A>::size;
  static_assert(width == std::size_t{Bare<I>::width},
                "largest() and smallest(): the value has as many lanes as the index");
  alignas(64) std::array<T, width> lanes;
  value.store_aligned(lanes.data());
  const LaneRange range = lane_range(i);
  T found = lanes[static_cast<std::size_t>(range.first)];
  for (int l = range.first + 1; l < range.last; ++l) {
    const T other = lanes[static_cast<std::size_t>(l)];
    if (better(other, found)) found = other;
  }
  return found;
}

}  // namespace detail

template <detail::OfPack I, class T, class A>
[[nodiscard]] T largest(const I& i, const xsimd::batch<T, A>& value) {
  return detail::best(i, value, [](T a, T b) { return a > b; });
}
template <detail::OfPack I, class T, class A>
[[nodiscard]] T smallest(const I& i, const xsimd::batch<T, A>& value) {
  return detail::best(i, value, [](T a, T b) { return a < b; });
}

template <class T, class A, class To>
void store_where(const xsimd::batch_bool<T, A>& condition, To&& to,
                 const typename std::remove_cvref_t<To>::Value& value) {
  using Lanes = typename std::remove_cvref_t<To>::Lanes;
  static_assert(!std::is_lvalue_reference_v<To> || !detail::ElementReference<To>,
                "store_where(): `auto m = view[i].m()` is a reference for packs and a number of its own for one "
                "object; write to view[i].m() itself");
  static_assert(xsimd::batch_bool<T, A>::size == Lanes::size, "store_where(): condition and field have as many lanes");
  to.write_where(detail::bits_of(condition), value);
}

}  // namespace physgen

#pragma pop_macro("I")
