// Lists of what touches a node or an edge, in half the memory: an element and where in it, in one number of 32 bits.
#pragma once

#include <elasticity.physgen.h>
#include <fem/mesh/mesh.h>
#include <physgen/detail/host_loop.h>
#include <physgen/error.h>
#include <physgen/rows.h>
#include <quasistatic.physgen.h>

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

/// Stores an incidence list as packed rows, on several threads.
/// @param ranges of elasticity::IncidenceRange, entries of quasistatic::PackedIncidence: arrays in one space, as many
/// as the list has rows and entries; of an empty list, of any size
/// @param elements how many there are
/// @param name of the elements, for errors: "edges"
/// @throw Error when there are too many elements for the packing, or an entry does not fit it
template <class Packing, class Ranges, class Entries>
void put_packed(Ranges& ranges, Entries& entries, const IncidenceList& list, index_t elements, const char* name) {
  if (elements > Packing::most_elements) {
    throw Error("the mesh has " + std::to_string(elements) + " " + name + ", but the solver's lists can number only " +
                std::to_string(Packing::most_elements) + "; use fewer cells");
  }
  if constexpr (!host_accessible(Entries::View::Space::kind)) {
    elasticity::IncidenceRangeArray<float> host_ranges(ranges.size());
    quasistatic::PackedIncidenceArray<float> host_entries(entries.size());
    put_packed<Packing>(host_ranges, host_entries, list, elements, name);
    copy(ranges, host_ranges);
    copy(entries, host_entries);
    synchronize();
  } else {
    if (list.first.empty()) return;
    const auto fits = [elements](const IncidenceEntry& entry) {
      return entry.local >= 0 && entry.local < 1 << Packing::bits && entry.element >= 0 && entry.element < elements;
    };
    const auto range = contents_of(ranges).view();
    const auto entry = contents_of(entries).view();
    physgen::detail::for_each_index(0, ranges.size(), [&](index_t i) {
      range[i].begin() = list.first[static_cast<std::size_t>(i)];
      range[i].end() = list.first[static_cast<std::size_t>(i) + 1];
    });
    physgen::detail::host_loop(entries.size(), [&](index_t k) {
      const IncidenceEntry& from = list.entries[static_cast<std::size_t>(k)];
      if (!fits(from)) {
        throw Error("an entry of a list of " + std::to_string(elements) + " " + name + " names " +
                    std::to_string(from.element) + ", with the local number " + std::to_string(from.local) +
                    "; it is packed into " + std::to_string(Packing::bits) + " bits");
      }
      entry[k].code() = static_cast<Index>(from.element << Packing::bits | from.local);
    });
  }
}

}  // namespace physgen::fem
