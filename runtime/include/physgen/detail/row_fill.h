// Rows that are made anew in the memory of old ones.
#pragma once

#include <physgen/detail/host_loop.h>
#include <physgen/row_arrays.h>

#include <span>
#include <string>

namespace physgen::detail {

struct RowFill {
  /// Row i becomes the entries first[i] up to, not including, first[i + 1], which name objects of the same set.
  /// @param write called with a view of the entries; writes all of them, numbers that it knows to be right
  template <class Ranges, class Entries, class Write>
  static void fill(RowArrays<Ranges, Entries>& rows, index_t size, std::span<const std::int32_t> first,
                   const Write& write) {
    static_assert(Entries::Space::kind == SpaceKind::host, "rows are made in place in memory of the host");
    using Precision = typename Entries::Precision;
    constexpr auto& field = Entries::Object::template fields<Precision, typename Entries::Formats>[0];
    static_assert(field.type == ElementType::int32, "the field of an entry that names an object is an Index");
    const index_t count = first.back();
    const bool more_entries = count > rows.entries_.capacity(), more_ranges = size > rows.ranges_.capacity();
    Entries entries;
    Ranges ranges_of_more;
    if (more_entries) entries.reserve(count + count / 8);
    if (more_ranges) ranges_of_more.reserve(size + size / 8);
    rows.targets_.field = field.name;
    // Behind this line nothing can fail, so that ranges and entries always belong together.
    if (more_entries) rows.entries_.swap(entries);
    if (more_ranges) rows.ranges_.swap(ranges_of_more);
    rows.entries_.resize(count);
    rows.ranges_.resize(size);
    rows.targets_.count = size;
    const auto ranges = rows.ranges_.view();
    for_each_index(0, size, [&](index_t i) {
      ranges[i].begin() = first[static_cast<std::size_t>(i)];
      ranges[i].end() = first[static_cast<std::size_t>(i) + 1];
    });
    write(rows.entries_.view());
  }
};

}  // namespace physgen::detail
