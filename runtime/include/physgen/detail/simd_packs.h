// The cursor of packs: of whole ones, and of the first or last of a range. Included by host translation units only.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/simd_cursor.h>

#include <array>
#include <cstring>

namespace physgen {

/// On the W consecutive objects of a pack.
template <class Byte, class Layout, RecordSize kRecord, detail::AnyPack I>
class Cursor<Byte, Layout, kRecord, I> : public detail::SimdCursor<Cursor<Byte, Layout, kRecord, I>, I::width> {
  static constexpr int W = I::width;
  using Base = detail::SimdCursor<Cursor, W>;
  using Pitch = typename Layout::Pitch;

 public:
  static constexpr bool gathered = false;
  static constexpr bool of_a_local = requires { Layout::of_locals; };
  /// Whether stores write all lanes.
  static constexpr bool whole = std::is_same_v<I, Pack<W>>;

  Cursor(Byte* base, Pitch pitch, const I& pack, Losses* losses)
      : Base(losses, pack.begin),
        tile_(base + law::tile_begin(pitch.tile(pack.begin), law::tile_bytes(pitch.value(), kRecord.stored))),
        lane_(pitch.lane(pack.begin)),
        pitch_(pitch),
        pack_(pack) {}

  [[nodiscard]] Cursor nested(int offset) const {
    Cursor inner = *this;
    inner.tile_ += law::channel_begin(offset, pitch_.value());
    inner.advance(offset);
    inner.offset_ += offset;
    return inner;
  }

  template <class T, int kCount>
  static constexpr bool joins_words = whole && Base::template joins_words_of<Layout, kRecord, T, kCount>;
  template <class T, int kCount>
  void load_words(batch_t<T, W>* elements) const {
    this->template load_words_at<kRecord, T, kCount>(offset_, elements);
  }

 private:
  friend Base;
  [[nodiscard]] static index_t further(int l) { return l; }
  [[nodiscard]] std::uint64_t written() const {
    const LaneRange range = lane_range(pack_);
    return Base::all_lanes >> (W - (range.last - range.first)) << range.first;
  }

  // A pack never crosses the end of a tile that holds it whole; in narrower tiles lane l lies some tiles further on.
  template <class T>
  [[nodiscard]] auto* address(int offset, int l) const {
    using Element = std::conditional_t<std::is_const_v<Byte>, const T, T>;
    if constexpr (Layout::contiguous(W)) {
      return reinterpret_cast<Element*>(tile_ + law::channel_begin(offset, pitch_.value()) +
                                        law::lane_begin(lane_ + l, sizeof(T)));
    } else {
      return reinterpret_cast<Element*>(law::element(tile_, pitch_, kRecord.stored, l, offset, sizeof(T)));
    }
  }

  // As a register where the pack is whole, else by way of memory.
  template <class T>
  [[nodiscard]] batch_t<T, W> read(int offset) const {
    if constexpr (whole && Layout::contiguous(W)) {
      prefetch<T>(offset);
      return batch_t<T, W>::load_unaligned(address<T>(offset, 0));
    } else {
      return Base::template read<T>(offset);
    }
  }
  template <class T>
  void write(int offset, const batch_t<T, W>& value) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    if constexpr (!whole) {
      Base::template write<T>(offset, value);
    } else if constexpr (Layout::contiguous(W)) {
      value.store_unaligned(address<T>(offset, 0));
    } else {
      alignas(64) std::array<T, W> lanes;
      value.store_aligned(lanes.data());
      write_lanes(offset, lanes);
    }
  }

  // As memory.
  template <class T>
  void read_lanes(int offset, std::array<T, W>& lanes) const {
    if constexpr (!whole) {
      read_some_lanes(offset, lanes);
    } else if constexpr (Layout::contiguous(W)) {
      prefetch<T>(offset);
      std::memcpy(lanes.data(), address<T>(offset, 0), sizeof lanes);
    } else {
      PHYSGEN_UNROLL
      for (int l = 0; l < W; ++l) lanes[static_cast<std::size_t>(l)] = *address<T>(offset, l);
    }
  }
  template <class T>
  void write_lanes(int offset, const std::array<T, W>& lanes) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    if constexpr (Layout::contiguous(W)) {
      std::memcpy(address<T>(offset, 0), lanes.data(), sizeof lanes);
    } else {
      PHYSGEN_UNROLL
      for (int l = 0; l < W; ++l) *address<T>(offset, l) = lanes[static_cast<std::size_t>(l)];
    }
  }
  // Loops that stay loops, and are not inlined: their code would stand at every access of a kernel, and runs at most
  // twice per range, or where a condition holds.
  template <class T>
  [[gnu::noinline]] void read_some_lanes(int offset, std::array<T, W>& lanes) const {
    for (int l = 0; l < W; ++l) lanes[static_cast<std::size_t>(l)] = *address<T>(offset, pack_.lane(l));
  }
  template <class T>
  [[gnu::noinline]] void write_some_lanes(int offset, const std::array<T, W>& lanes, std::uint64_t which) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    for (int l = 0; l < W; ++l) {
      if (which >> l & 1) *address<T>(offset, l) = lanes[static_cast<std::size_t>(l)];
    }
  }

  // Kernels stream, but over more arrays, with more skipped channels, than hardware prefetchers follow: the line that a
  // later pack will load is asked for now. The line may lie behind the array: prefetches do not fault. (Locals have no
  // later packs.) It is fetched into the second cache: lines that are under way to the first one hold its few miss
  // buffers for as long as memory takes, and loads wait for these. Where a pack is a tile, its channels are whole lines
  // side by side, which hardware follows. What each of these gave stands in runtime/README.md.
  template <class T>
  void prefetch(int offset) const {
    constexpr int line_bytes = 64, line_lanes = line_bytes / int{sizeof(T)}, second_cache = 2;
    constexpr bool wide_channels = Layout::contiguous(2 * line_lanes);
    if constexpr (of_a_local || (!wide_channels && W == line_lanes)) return;
    constexpr index_t objects_ahead = wide_channels ? 2 * line_lanes : 2 * W;
    constexpr index_t bytes_ahead = objects_ahead * (Layout::contiguous(1 << 20) ? int{sizeof(T)} : kRecord.stored);
    const auto* later = reinterpret_cast<const std::byte*>(address<T>(offset, 0)) + bytes_ahead;
    if constexpr (wide_channels) {
      __builtin_prefetch(later, 0, second_cache);
    } else {
      __builtin_prefetch(later);  // into the first cache, which is faster for channels of half a line: measured
    }
  }

  Byte* tile_;
  index_t lane_;
  Pitch pitch_;
  int offset_ = 0;  ///< in the record, of tile_
  I pack_;
};

}  // namespace physgen

#pragma pop_macro("I")
