// The cursor of W objects named by an index batch. Included by host translation units only.
#pragma once

#include <physgen/detail/simd_cursor.h>
#include <physgen/error.h>

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
  alignas(64) std::array<U, W> index_;
};

}  // namespace physgen
