// Rows that are made anew in the memory of old ones.
#pragma once

#include <physgen/detail/host_loop.h>
#include <physgen/row_arrays.h>

#include <span>
#include <string>
#include <type_traits>

namespace physgen::detail {

struct RowFill {
  /// Makes room for `count` entries that name objects of the set of the rows itself, of `size` objects. What rows and
  /// entries then hold is not said.
  template <class Space, class Ranges, class Entries>
  static void make_room(RowArrays<Ranges, Entries>& rows, index_t size, index_t count) {
    static_assert(std::is_same_v<typename Entries::Space, Space>,
                  "rows are made in place in the memory of the list: Host, or Cuda");
    static_assert(Entries::elements == 1, "the entries of neighbours have one field, an Index");
    using Precision = typename Entries::Precision;
    constexpr auto& field = Entries::Object::template fields<Precision, typename Entries::Formats>[0];
    static_assert(field.type == ElementType::int32, "the field of an entry that names an object is an Index");
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
  }

  /// Row i becomes the entries first[i] up to, not including, first[i + 1]. @pre there is room for them, on the host
  /// @param write called with a view of the entries; writes all of them, numbers that it knows to be right
  template <class Ranges, class Entries, class Write>
  static void fill(RowArrays<Ranges, Entries>& rows, std::span<const std::int32_t> first, const Write& write) {
    const auto ranges = rows.ranges_.view();
    for_each_index(0, rows.size(), [&](index_t i) {
      ranges[i].begin() = first[static_cast<std::size_t>(i)];
      ranges[i].end() = first[static_cast<std::size_t>(i) + 1];
    });
    write(rows.entries_.view());
  }
};

}  // namespace physgen::detail
