// Lists of what touches a node or an edge, in half the memory: an element and where in it, in one number of 32 bits.
#pragma once

#include <elasticity.physgen.h>
#include <fem/mesh/mesh.h>
#include <physgen/detail/host_loop.h>
#include <physgen/error.h>
#include <physgen/rows.h>
#include <quasistatic.physgen.h>

#include <algorithm>
#include <span>
#include <string>

namespace physgen::fem {

/// A way to pack the entries of a list. @tparam kBits of IncidenceEntry::local, which is 0 to 2^kBits - 1
template <int kBits>
struct PackedEntry {
  static constexpr int bits = kBits;
  static constexpr index_t most_elements = index_t{1} << (31 - kBits);

  /// @param entry of type quasistatic::PackedIncidence
  template <class Entry>
  [[nodiscard]] PHYSGEN_FUNCTION static index_t element(const Entry& entry) {
    const int code = entry.code();
    return code >> kBits;
  }
  template <class Entry>
  [[nodiscard]] PHYSGEN_FUNCTION static int local(const Entry& entry) {
    const int code = entry.code();
    return code & ((1 << kBits) - 1);
  }
};
using NodeTetEntry = PackedEntry<2>;    ///< tet, corner
using EdgeTetEntry = PackedEntry<4>;    ///< tet, local edge + 6 if it runs from n to m
using NodeEdgeEntry = PackedEntry<1>;   ///< edge, side
using NodePatchEntry = PackedEntry<3>;  ///< patch, slot
using EdgePatchEntry = PackedEntry<6>;  ///< patch, slot of m + 8 slot of n
using ChildEntry =
    PackedEntry<2>;  ///< fine node, how many of its two parents are this node; or which of its grid parents is
using EdgeTermEntry = PackedEntry<3>;  ///< fine node or edge, galerkin_code()

/// The array itself where a scene's programs may only read it.
template <class Array>
[[nodiscard]] auto& contents_of(Array& array) {
  if constexpr (requires { array.contents(); }) {
    return array.contents();
  } else {
    return array;
  }
}

/// Stores incidences as packed rows.
/// @param ranges of elasticity::IncidenceRange, entries of quasistatic::PackedIncidence: arrays in one space, as many
/// as there are rows and entries; where there is no row, of any size
/// @param first where each row begins, and the last one ends
/// @param visit called as visit(put); calls put(begin, part) with all entries, a part of them from entry `begin` on at
/// a time, in any order and on several threads
/// @param elements how many there are
/// @param name of the elements, for errors: "edges"
/// @throw Error when there are too many elements for the packing, or an entry does not fit it
template <class Packing, class Ranges, class Entries, class Visit>
void put_packed_parts(Ranges& ranges, Entries& entries, std::span<const Index> first, const Visit& visit,
                      index_t elements, const char* name) {
  if (elements > Packing::most_elements) {
    throw Error("the mesh has " + std::to_string(elements) + " " + name + ", but the solver's lists can number only " +
                std::to_string(Packing::most_elements) + "; use fewer cells");
  }
  if constexpr (!host_accessible(Entries::View::Space::kind)) {
    elasticity::IncidenceRangeArray<float> host_ranges(ranges.size());
    quasistatic::PackedIncidenceArray<float> host_entries(entries.size());
    put_packed_parts<Packing>(host_ranges, host_entries, first, visit, elements, name);
    copy(ranges, host_ranges);
    copy(entries, host_entries);
    synchronize();
  } else {
    if (first.empty()) return;
    const auto fits = [elements](const IncidenceEntry& entry) {
      return entry.local >= 0 && entry.local < 1 << Packing::bits && entry.element >= 0 && entry.element < elements;
    };
    const auto range = contents_of(ranges).view();
    const auto entry = contents_of(entries).view();
    physgen::detail::for_each_index(0, ranges.size(), [&](index_t i) {
      range[i].begin() = first[static_cast<std::size_t>(i)];
      range[i].end() = first[static_cast<std::size_t>(i) + 1];
    });
    visit([&](index_t begin, std::span<const IncidenceEntry> part) {
      for (const IncidenceEntry& from : part) {
        if (!fits(from)) {
          throw Error("an entry of a list of " + std::to_string(elements) + " " + name + " names " +
                      std::to_string(from.element) + ", with the local number " + std::to_string(from.local) +
                      "; it is packed into " + std::to_string(Packing::bits) + " bits");
        }
        entry[begin++].code() = static_cast<Index>(from.element << Packing::bits | from.local);
      }
    });
  }
}

/// The same of a list, on several threads. @param list an IncidenceList, or MeshRows
template <class Packing, class Ranges, class Entries, class List>
void put_packed(Ranges& ranges, Entries& entries, const List& list, index_t elements, const char* name) {
  const std::span<const IncidenceEntry> all = list.entries;
  const auto visit = [all](const auto& put) {
    constexpr index_t most = 4096;
    const auto size = static_cast<index_t>(all.size());
    physgen::detail::host_loop((size + most - 1) / most, [&](index_t p) {
      const index_t begin = p * most, end = std::min(size, begin + most);
      put(begin, all.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin)));
    });
  };
  put_packed_parts<Packing>(ranges, entries, list.first, visit, elements, name);
}

}  // namespace physgen::fem
