// The parts of fill_rows() and append_rows(): what threads share, and the order of a row.
#pragma once

#include <physgen/detail/launch.h>
#include <physgen/detail/scan.h>
#include <physgen/memory/host_list.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace physgen::detail {

/// What threads need while they work, as many as there are at work at once.
template <class Scratch>
class Spares {
 public:
  /// Calls work(scratch) with one that no other thread has.
  template <class Make, class Work>
  void lend(const Make& make, const Work& work) {
    std::unique_ptr<Scratch> scratch;
    {
      const std::lock_guard lock(mutex_);
      if (!spares_.empty()) {
        scratch = std::move(spares_.back());
        spares_.pop_back();
      }
    }
    if (!scratch) scratch = std::make_unique<Scratch>(make());
    work(*scratch);
    const std::lock_guard lock(mutex_);
    spares_.push_back(std::move(scratch));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Scratch>> spares_;
};

/// Sorts a row, which is short or nearly sorted, mostly.
template <class Entry>
void sort_row(Entry* begin, Entry* end) {
  constexpr index_t most_inserted = 64;
  if (end - begin > most_inserted) {
    if (!std::is_sorted(begin, end)) std::sort(begin, end);
    return;
  }
  for (Entry* next = begin; next < end; ++next) {
    const Entry entry = *next;
    Entry* place = next;
    for (; place > begin && entry < place[-1]; --place) *place = place[-1];
    *place = entry;
  }
}

/// The next number of a row to count, or to place at.
template <bool kAtomic>
std::int32_t add_to_row(std::int32_t& row, std::int32_t change) {
  if constexpr (kAtomic) return std::atomic_ref(row).fetch_add(change, std::memory_order_relaxed);
  return std::exchange(row, row + change);
}

template <bool kAtomic, class Entry, class Visit>
void fill_rows(index_t items, const Visit& visit, HostList<std::int32_t>& first, HostList<Entry>& entries) {
  for_each_index<4>(0, items, [&](index_t i) {
    visit(i,
          [&](index_t row, const Entry& /*entry*/) { add_to_row<kAtomic>(first[static_cast<std::size_t>(row)], 1); });
  });
  entries.resize(static_cast<std::size_t>(scan<true>(std::span(first))));
  // Rows are filled from their ends, which become their beginnings; items come in descending order for that.
  for_each_index<8>(0, items, [&](index_t i) {
    visit(items - 1 - i, [&](index_t row, const Entry& entry) {
      const std::int32_t place = add_to_row<kAtomic>(first[static_cast<std::size_t>(row)], -1) - 1;
      entries[static_cast<std::size_t>(place)] = entry;
    });
  });
}

}  // namespace physgen::detail
