// Counts the 32-byte sectors that the warps of a kernel touch, from layout and access set alone: the kernel runs on the
// host over arrays whose cursors write down every address, 32 objects at a time, and what the 32 lanes of a warp ask
// for in one step is one request. It models what the hardware's counters count, without a profiler; check_coalescing.py
// compares.
#pragma once

#include <physgen/arrays/view.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "data/operands.h"

namespace physgen::bench {

/// Means over the global loads and stores of a kernel.
struct Sectors {
  double per_request = 0;       ///< distinct sectors of a warp's access
  double bytes_per_sector = 0;  ///< of its 32 bytes, those that the warp asked for
};

/// The accesses of one lane, in their order.
class Trace {
 public:
  struct Access {
    std::uintptr_t address;
    int bytes;
  };
  static void note(const void* address, int bytes) {
    current().push_back({reinterpret_cast<std::uintptr_t>(address), bytes});
  }
  static std::vector<Access>& current() {
    thread_local std::vector<Access> accesses;
    return accesses;
  }
};

/// Adds up requests of warps.
class SectorCount {
 public:
  static constexpr int warp = 32, sector = 32;

  /// @param lanes the accesses of each lane; the k-th ones of all lanes are one request
  void add(const std::vector<std::vector<Trace::Access>>& lanes) {
    std::size_t steps = 0;
    for (const auto& lane : lanes) steps = std::max(steps, lane.size());
    for (std::size_t k = 0; k < steps; ++k) {
      std::vector<std::uintptr_t> bytes, sectors;
      for (const auto& lane : lanes) {
        if (k >= lane.size()) continue;
        for (int b = 0; b < lane[k].bytes; ++b) bytes.push_back(lane[k].address + static_cast<std::uintptr_t>(b));
      }
      const auto count_distinct = [](std::vector<std::uintptr_t>& all) {
        std::ranges::sort(all);
        return std::ranges::unique(all).begin() - all.begin();
      };
      for (const std::uintptr_t byte : bytes) sectors.push_back(byte / sector);
      requests_ += 1;
      bytes_ += static_cast<double>(count_distinct(bytes));
      sectors_ += static_cast<double>(count_distinct(sectors));
    }
  }
  [[nodiscard]] Sectors result() const {
    if (requests_ == 0) return {};
    return {sectors_ / requests_, bytes_ / sectors_};
  }

 private:
  double requests_ = 0, sectors_ = 0, bytes_ = 0;
};

/// A layout whose accesses are traced.
template <class Layout>
struct Traced : Layout {};

/// Beside a traced array, those are traced whose layout is not measured.
template <class Layout, class Kept>
struct KeptBeside<Traced<Layout>, Kept> {
  using type = Traced<Kept>;
};

/// Runs `kernel`, whose views are traced, over whole warps spread over the objects. @pre objects >= 32
template <class Kernel>
Sectors count_sectors(const Kernel& kernel, index_t objects) {
  constexpr index_t most_warps = 256;
  const index_t warps = objects / SectorCount::warp, step = std::max<index_t>(1, warps / most_warps);
  SectorCount count;
  for (index_t w = 0; w < warps; w += step) {
    std::vector<std::vector<Trace::Access>> lanes;
    for (index_t i = w * SectorCount::warp; i < (w + 1) * SectorCount::warp; ++i) {
      Trace::current().clear();
      kernel(i);
      lanes.push_back(Trace::current());
    }
    count.add(lanes);
  }
  return count.result();
}

}  // namespace physgen::bench

namespace physgen {

/// As the cursor of one object, but every access is noted.
template <class Byte, class Layout, RecordSize kRecord, class I>
class Cursor<Byte, bench::Traced<Layout>, kRecord, I> {
  using Pitch = typename Layout::Pitch;

 public:
  template <class T>
  using Lanes = T;

  Cursor(Byte* base, Pitch pitch, I i, Losses* /*losses*/)
      : lane_(pitch.lane(static_cast<index_t>(i))),
        tile_(base +
              law::tile_begin(pitch.tile(static_cast<index_t>(i)), law::tile_bytes(pitch.value(), kRecord.stored))),
        pitch_(pitch) {}

  template <class Shape, class Format, class T>
  [[nodiscard]] auto field(int offset) const {
    if constexpr (Shape::is_scalar) {
      return element<Format, T>(offset);
    } else {
      return FieldRef<Shape, Format, T, Cursor>(nested(offset));
    }
  }
  template <class Format, class T>
  [[nodiscard]] auto element(int offset, int k = 0) const {
    return ElementRef<Format, T, Cursor>(*this, offset, k);
  }
  template <class Format, class T>
  [[nodiscard]] T load(int offset, int k) const {
    return Format::template decode<T>(*noted<typename Format::template Stored<T>>(offset, k));
  }
  template <class Format, class T>
  void store(int offset, int k, const T& value) const {
    *noted<typename Format::template Stored<T>>(offset, k) = Format::template encode<T>(value);
  }
  template <class T>
  void check_rotation(const Eigen::Matrix<T, 3, 3>& /*R*/) const {}
  [[nodiscard]] Cursor nested(int offset) const {
    Cursor inner = *this;
    inner.tile_ += law::channel_begin(offset, pitch_.value());
    inner.offset_ += offset;
    return inner;
  }

  // Words, as a kernel on a GPU joins elements to them.
  template <class T, int kCount>
  static constexpr bool joins_words = detail::made_of_words<Layout, kRecord, T, kCount>;
  template <class T, int kCount>
  [[nodiscard]] bool may_read_words() const {
    return detail::may_read_words<kRecord>(offset_, kCount * int{sizeof(T)});
  }
  template <class T, int kCount>
  [[nodiscard]] bool may_write_words() const {
    return detail::may_write_words<kRecord>(offset_, kCount * int{sizeof(T)});
  }
  template <class T, int kCount>
  void load_words(T* elements) const {
    each_word<T, kCount>([&](auto* word, int k) { std::memcpy(elements + k, word, 16); });
  }
  template <class T, int kCount>
  void store_words(const T* elements) const {
    each_word<T, kCount>([&](auto* word, int k) { std::memcpy(word, elements + k, 16); });
  }

 private:
  template <class Stored>
  [[nodiscard]] auto* noted(int offset, int k) const {
    using Element = std::conditional_t<std::is_const_v<Byte>, const Stored, Stored>;
    auto* address =
        reinterpret_cast<Element*>(tile_ + law::channel_begin(offset + k * index_t{sizeof(Stored)}, pitch_.value()) +
                                   law::lane_begin(lane_, sizeof(Stored)));
    bench::Trace::note(address, sizeof(Stored));
    return address;
  }

  // Calls visit(first byte, first element) for every word of a field.
  template <class T, int kCount, class Visit>
  void each_word(const Visit& visit) const {
    auto* begin = tile_ + law::lane_begin(lane_, kRecord.stored);
    for (int k = 0; k < kCount; k += 16 / int{sizeof(T)}) {
      auto* word = begin + k * int{sizeof(T)};
      bench::Trace::note(word, 16);
      visit(word, k);
    }
  }

  index_t lane_;
  Byte* tile_;
  Pitch pitch_;
  int offset_ = 0;
};

}  // namespace physgen
