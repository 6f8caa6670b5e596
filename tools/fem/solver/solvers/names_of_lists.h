// What the objects of lists name, by numbers of all, where a rank has lists of a part: for connect() and
// connect_rows().
#pragma once

#include <fem/solver/levels/layers_of_levels.h>
#include <fem/solver/levels/made_entries.h>

#include <array>
#include <cstddef>

namespace physgen::fem {

/// Adds to the number of a code. @tparam Packing of it
template <class Packing>
inline constexpr auto add_to_code = [](auto& entry, Index number) { entry.code += number << Packing::bits; };

/// The entries of each row, by numbers of all.
/// @param objects, elements those that have rows, and that entries name
/// @param add add(entry, number) adds to the number of what an entry names
template <class Ranges, class Entries, class Add>
[[nodiscard]] auto rows_of(const Ranges& ranges, const Entries& entries, const ListedObjects& objects,
                           const ListedObjects& elements, const Add& add) {
  return [=, ranges = ranges.const_view(), entries = entries.const_view()](index_t number) {
    const auto row = ranges[objects.here(number)];
    return MadeEntries(row.begin(), row.end(), [=](index_t k) {
      auto entry = entries.get(k);
      add(entry, static_cast<Index>(elements.offset));
      return entry;
    });
  };
}
/// The same where the rows of all are here.
template <class Ranges, class Entries>
[[nodiscard]] auto rows_of(const Ranges& ranges, const Entries& entries) {
  return rows_of(ranges, entries, {}, {}, [](auto& /*entry*/, Index /*number*/) {});
}
/// The nodes that an object names, by numbers of all.
template <int kCount, class Array>
[[nodiscard]] auto nodes_of(const Array& array, const ListedObjects& objects = {}, const ListedObjects& nodes = {}) {
  return [=, view = array.const_view()](index_t number) {
    const auto object = view[objects.here(number)];
    std::array<Index, kCount> named{};
    for (int k = 0; k < kCount; ++k) {
      named[static_cast<std::size_t>(k)] = object.nodes()[k] + static_cast<Index>(nodes.offset);
    }
    return named;
  };
}
/// The patch that an object names, likewise.
template <class Array>
[[nodiscard]] auto patch_of(const Array& array, const ListedObjects& objects, const ListedObjects& patches) {
  return [=, view = array.const_view()](index_t number) {
    return std::array<Index, 1>{view[objects.here(number)].patch() + static_cast<Index>(patches.offset)};
  };
}

}  // namespace physgen::fem
