// The cursors of packs: of a whole one, and of the first or last of a range. Included by host translation units only.
#pragma once

#include <physgen/detail/simd_cursor.h>

#include <array>
#include <cstring>

namespace physgen {

namespace detail {

/// The common base of the cursors of whole and of partial packs, which stand on W consecutive objects.
template <class Derived, class Byte, class Layout, RecordSize kRecord, int W>
class ConsecutiveCursor : public SimdCursor<Derived, W> {
 protected:
  using Base = SimdCursor<Derived, W>;
  using Pitch = typename Layout::Pitch;

  ConsecutiveCursor(Byte* base, Pitch pitch, index_t begin, Losses* losses)
      : Base(losses, begin),
        tile_(base + law::tile_begin(pitch.tile(begin), law::tile_bytes(pitch.value(), kRecord.stored))),
        lane_(pitch.lane(begin)),
        pitch_(pitch) {}

 public:
  [[nodiscard]] Derived nested(int offset) const {
    Derived inner = static_cast<const Derived&>(*this);
    inner.tile_ += law::channel_begin(offset, pitch_.value());
    inner.advance(offset);
    return inner;
  }

 protected:
  friend Base;
  [[nodiscard]] static index_t further(int l) { return l; }

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
  // A loop that stays one, and is not inlined: its code would stand at every store of a kernel, and runs seldom.
  template <class T>
  [[gnu::noinline]] void write_some_lanes(int offset, const std::array<T, W>& lanes, std::uint64_t which) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    for (int l = 0; l < W; ++l) {
      if (which >> l & 1) *address<T>(offset, l) = lanes[static_cast<std::size_t>(l)];
    }
  }

 private:
  Byte* tile_;
  index_t lane_;
  Pitch pitch_;
};

}  // namespace detail

/// On the W objects of a pack.
template <class Byte, class Layout, RecordSize kRecord, int W>
class Cursor<Byte, Layout, kRecord, Pack<W>>
    : public detail::ConsecutiveCursor<Cursor<Byte, Layout, kRecord, Pack<W>>, Byte, Layout, kRecord, W> {
  using Consecutive = detail::ConsecutiveCursor<Cursor, Byte, Layout, kRecord, W>;

 public:
  static constexpr bool gathered = false;
  static constexpr bool of_a_local = requires { Layout::of_locals; };
  /// Whether stores write all lanes.
  static constexpr bool whole = true;

  Cursor(Byte* base, typename Layout::Pitch pitch, Pack<W> pack, Losses* losses)
      : Consecutive(base, pitch, pack.begin, losses) {}

 private:
  friend Consecutive;
  friend typename Consecutive::Base;
  using Consecutive::address;
  [[nodiscard]] static constexpr std::uint64_t written() { return Consecutive::all_lanes; }

  // As a register.
  template <class T>
  [[nodiscard]] batch_t<T, W> read(int offset) const {
    if constexpr (Layout::contiguous(W)) {
      prefetch<T>(offset);
      return batch_t<T, W>::load_unaligned(this->template address<T>(offset, 0));
    } else {
      return Consecutive::Base::template read<T>(offset);
    }
  }
  template <class T>
  void write(int offset, const batch_t<T, W>& value) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    if constexpr (Layout::contiguous(W)) {
      value.store_unaligned(this->template address<T>(offset, 0));
    } else {
      alignas(64) std::array<T, W> lanes;
      value.store_aligned(lanes.data());
      this->write_lanes(offset, lanes);
    }
  }

  // As memory.
  template <class T>
  void read_lanes(int offset, std::array<T, W>& lanes) const {
    if constexpr (Layout::contiguous(W)) {
      prefetch<T>(offset);
      std::memcpy(lanes.data(), this->template address<T>(offset, 0), sizeof lanes);
    } else {
      PHYSGEN_UNROLL
      for (int l = 0; l < W; ++l) lanes[static_cast<std::size_t>(l)] = *this->template address<T>(offset, l);
    }
  }

  // Kernels stream, but over more arrays, with more skipped channels, than hardware prefetchers follow: the line that a
  // later pack will load is asked for now. Measured: dP from dF over Aosoa<16> 8.2 ms instead of 11.7, over
  // Aosoa<32> 9.2 instead of 17.5; one, three or four packs ahead are slower. The line may lie behind the array:
  // prefetches do not fault. (Locals have no later packs.)
  template <class T>
  void prefetch(int offset) const {
    if constexpr (of_a_local) return;
    constexpr index_t packs_ahead = 2;
    constexpr index_t pack_bytes = index_t{W} * (Layout::contiguous(1 << 20) ? int{sizeof(T)} : kRecord.stored);
    __builtin_prefetch(reinterpret_cast<const std::byte*>(this->template address<T>(offset, 0)) +
                       packs_ahead * pack_bytes);
  }
};

/// On the first or the last pack of a range.
template <class Byte, class Layout, RecordSize kRecord, int W>
class Cursor<Byte, Layout, kRecord, PartialPack<W>>
    : public detail::ConsecutiveCursor<Cursor<Byte, Layout, kRecord, PartialPack<W>>, Byte, Layout, kRecord, W> {
  using Consecutive = detail::ConsecutiveCursor<Cursor, Byte, Layout, kRecord, W>;

 public:
  static constexpr bool gathered = false;
  static constexpr bool of_a_local = requires { Layout::of_locals; };
  static constexpr bool whole = false;

  Cursor(Byte* base, typename Layout::Pitch pitch, const PartialPack<W>& pack, Losses* losses)
      : Consecutive(base, pitch, pack.begin, losses), pack_(pack) {}

 private:
  friend Consecutive;
  friend typename Consecutive::Base;
  [[nodiscard]] std::uint64_t written() const {
    return Consecutive::all_lanes >> (W - (pack_.last - pack_.first)) << pack_.first;
  }

  // A loop that stays one: this runs at most twice per range, and its code stands in every kernel.
  template <class T>
  [[gnu::noinline]] void read_lanes(int offset, std::array<T, W>& lanes) const {
    for (int l = 0; l < W; ++l) {
      lanes[static_cast<std::size_t>(l)] = *this->template address<T>(offset, pack_.lane(l));
    }
  }

  PartialPack<W> pack_;
};

}  // namespace physgen
