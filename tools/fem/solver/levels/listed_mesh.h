// The lists of a mesh as a rank tells of them, by numbers of all of its objects.
#pragma once

#include <fem/mesh/at.h>
#include <fem/mesh/mesh.h>
#include <fem/solver/levels/layers_of_levels.h>
#include <fem/solver/levels/made_entries.h>

#include <array>

namespace physgen::fem {

/// The nodes that a tet names. @param mesh outlives the function @param listed what of all objects the mesh has
[[nodiscard]] inline auto nodes_of_tets(const TetMesh& mesh, const ListedLevel& listed) {
  return [&mesh, of = listed.tets, before = static_cast<Index>(listed.nodes.offset)](index_t tet) {
    std::array<Index, 4> nodes = mesh.tets[at(of.here(tet))];
    for (Index& node : nodes) node += before;
    return nodes;
  };
}

/// The entries of a row. @param list outlives the function @param rows whose list it is
/// @param make make(entry) is what an array has of an IncidenceEntry
template <class Make>
[[nodiscard]] auto entries_of(const IncidenceList& list, const ListedObjects& rows, const Make& make) {
  return [&list, rows, make](index_t number) {
    const std::size_t row = at(rows.here(number));
    return MadeEntries(list.first[row], list.first[row + 1],
                       [&list, make](index_t k) { return make(list.entries[at(k)]); });
  };
}

}  // namespace physgen::fem
