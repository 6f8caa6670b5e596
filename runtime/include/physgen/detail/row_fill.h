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
    // The old entries are gone before there are new ones, so that no memory is needed twice and nothing is copied.
    const index_t count = first.back();
    if (count > rows.entries_.capacity()) {
      Entries entries;
      entries.reserve(count + count / 8);
      rows.entries_.swap(entries);
    }
    if (size > rows.ranges_.capacity()) rows.ranges_ = Ranges(size);
    rows.entries_.resize(count);
    rows.ranges_.resize(size);
    rows.targets_.field = field.name;
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
