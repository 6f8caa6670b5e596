// Stands on W objects that a batch of indices names. Only translation units of the host include it. Where the objects
// follow each other, as neighbours of a grid do, tiles and SoA are read by one or two registers, else lane by lane.
#pragma once

#include <physgen/detail/simd_cursor.h>
#include <physgen/error.h>

#include <limits>
#include <string>

namespace physgen {

/// On W objects gathered by index.
template <class Byte, class Layout, RecordSize kRecord, class U, class A>
class Cursor<Byte, Layout, kRecord, xsimd::batch<U, A>>
    : public detail::SimdCursor<Cursor<Byte, Layout, kRecord, xsimd::batch<U, A>>,
                                static_cast<int>(xsimd::batch<U, A>::size)> {
  static_assert(std::is_integral_v<U>, "objects are named by integers: convert the batch first");
  static constexpr int W = static_cast<int>(xsimd::batch<U, A>::size);
  using Base = detail::SimdCursor<Cursor, W>;
  using Pitch = typename Layout::Pitch;

 public:
  static constexpr bool gathered = true;
  static constexpr bool whole = false;

  Cursor(Byte* base, Pitch pitch, const xsimd::batch<U, A>& index, Losses* losses)
      : Base(losses, 0), base_(base), pitch_(pitch) {
    index.store_aligned(index_.data());
    if constexpr (reads_runs) run_ = is_run(index);
  }

  [[nodiscard]] Cursor nested(int offset) const {
    Cursor inner = *this;
    inner.base_ += law::channel_begin(offset, pitch_.value());
    inner.advance(offset);
    inner.offset_ += offset;
    return inner;
  }

  template <class T, int kCount>
  static constexpr bool joins_words = Base::template joins_words_of<Layout, kRecord, T, kCount>;
  template <class T, int kCount>
  void load_words(batch_t<T, W>* elements) const {
    this->template load_words_at<kRecord, T, kCount>(offset_, elements);
  }

 private:
  friend Base;
  [[nodiscard]] index_t further(int l) const { return index_[static_cast<std::size_t>(l)]; }

  /// Whether elements of W objects that follow each other lie in at most two pieces.
  static constexpr bool reads_runs = [] {
    if constexpr (requires { std::integral_constant<index_t, Pitch::value()>(); }) return Pitch::value() >= W;
    return std::is_same_v<Pitch, WholePitch>;
  }();
  /// Whether lane l names object index[0] + l, and none of these numbers overflows.
  [[nodiscard]] bool is_run(const xsimd::batch<U, A>& index) const {
    const auto counted = std::bit_cast<xsimd::batch<U, A>>(detail::counting_register<U, W>());
    const U first = index_[0];
    return xsimd::all(index == counted + xsimd::batch<U, A>(first)) &&
           first <= std::numeric_limits<U>::max() - U{W - 1};
  }
  template <class T>
  [[nodiscard]] batch_t<T, W> read(int offset) const {
    if constexpr (reads_runs) {
      if (run_) return read_run<T>(offset);
    }
    return [&]<int... l>(std::integer_sequence<int, l...>) {  // by way of memory, it would wait for all its lanes
      return std::bit_cast<batch_t<T, W>>(detail::register_t<T, W>{*address<T>(offset, l)...});
    }(std::make_integer_sequence<int, W>());
  }
  /// The piece in the first object's tile, and that in the last one's. Each load begins or ends with elements of
  /// others, of these two tiles, which are thrown away; other threads may be writing them.
  template <class T>
  [[nodiscard]] batch_t<T, W> read_run(int offset) const {
    const auto low = batch_t<T, W>::load_unaligned(address<T>(offset, 0));
    if constexpr (std::is_same_v<Pitch, WholePitch>) {
      return low;
    } else {
      const index_t lane = pitch_.lane(further(0));
      if (lane <= pitch_.value() - W) return low;
      const auto high = batch_t<T, W>::load_unaligned(address<T>(offset, W - 1) - (W - 1));
      using Bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
      using Lanes = detail::register_t<Bits, W>;
      const Lanes first = detail::counting_register<Bits, W>() < Lanes{} + static_cast<Bits>(pitch_.value() - lane);
      return std::bit_cast<batch_t<T, W>>((std::bit_cast<Lanes>(low) & first) | (std::bit_cast<Lanes>(high) & ~first));
    }
  }

  template <class T>
  void read_lanes(int offset, std::array<T, W>& lanes) const {
    PHYSGEN_UNROLL
    for (int l = 0; l < W; ++l) lanes[static_cast<std::size_t>(l)] = *address<T>(offset, l);
  }
  [[nodiscard]] static std::uint64_t written() {
    const LaneRange range = detail::running_lanes.of(W);
    return Base::all_lanes >> (W - (range.last - range.first)) << range.first;
  }
  // Lane by lane in order: of equal indices the last lane wins. Checked builds refuse them.
  template <class T>
  void write_some_lanes(int offset, const std::array<T, W>& lanes, std::uint64_t which) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    if constexpr (checked_build) check_distinct(which);
    for (int l = 0; l < W; ++l) {
      if (which >> l & 1) *address<T>(offset, l) = lanes[static_cast<std::size_t>(l)];
    }
  }
  void check_distinct(std::uint64_t which) const {
    for (std::size_t l = 0; l < W; ++l) {
      for (std::size_t before = 0; before < l; ++before) {
        if ((which >> l & which >> before & 1) == 0 || index_[l] != index_[before]) continue;
        throw Error("a store through gathered indices: lanes " + std::to_string(before) + " and " + std::to_string(l) +
                    " of a pack both name object " + std::to_string(index_[l]) +
                    ", and only one of their values would stay; add(i, view[j].field(), value) adds both");
      }
    }
  }

  template <class T>
  [[nodiscard]] auto* address(int offset, int l) const {
    using Element = std::conditional_t<std::is_const_v<Byte>, const T, T>;
    const index_t i = index_[static_cast<std::size_t>(l)];
    return reinterpret_cast<Element*>(law::element(base_, pitch_, kRecord.stored, i, offset, sizeof(T)));
  }

  Byte* base_;
  Pitch pitch_;
  int offset_ = 0;  ///< in the record, of base_
  bool run_ = false;
  alignas(64) std::array<U, W> index_;
};

}  // namespace physgen
