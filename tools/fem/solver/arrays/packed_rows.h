// Lists of what touches a node or an edge, in half the memory: an element and where in it, in one number of 32 bits.
#pragma once

#include <elasticity.physgen.h>
#include <fem/mesh/mesh.h>
#include <physgen/error.h>
#include <physgen/row_arrays.h>
#include <quasistatic.physgen.h>

#include <string>
#include <vector>

namespace physgen::fem {

template <class Space>
using PackedRows =
    RowArrays<elasticity::IncidenceRangeArray<float, Space>, quasistatic::PackedIncidenceArray<float, Space>>;

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

/// An incidence list in packed rows.
/// @param elements how many there are
/// @param name of the elements, for errors: "edges"
/// @throw Error when there are too many elements for the packing, or an entry does not fit it
template <class Packing>
[[nodiscard]] PackedRows<Host> packed_rows(const IncidenceList& list, index_t elements, const char* name) {
  if (elements > Packing::most_elements) {
    throw Error("the mesh has " + std::to_string(elements) + " " + name + ", but the solver's lists can number only " +
                std::to_string(Packing::most_elements) + "; use fewer cells");
  }
  std::vector<typename PackedRows<Host>::Value> entries;
  entries.reserve(list.entries.size());
  for (const auto [element, local] : list.entries) {
    if (local < 0 || local >= 1 << Packing::bits) {
      throw Error("an entry of a list of " + std::string(name) + " has the local number " + std::to_string(local) +
                  " in its element; it is packed into " + std::to_string(Packing::bits) + " bits");
    }
    entries.push_back({static_cast<Index>(element << Packing::bits | local)});
  }
  return PackedRows<Host>::from_offsets({"code", elements << Packing::bits}, list.first, entries);
}

}  // namespace physgen::fem
