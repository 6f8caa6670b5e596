// The lists of a box's mesh, which repeat from cell to cell. For box_mesh.cpp, boundary.cpp and levels of boxes.
#pragma once

#include <fem/mesh/alike_nodes.h>
#include <fem/mesh/mesh.h>

#include <array>
#include <span>
#include <vector>

namespace physgen::fem::detail {

/// Corners of the six tets of a cell that is mirrored along the axes of these bits: bit k of a corner is set where it
/// lies on the upper side along axis k.
[[nodiscard]] std::array<std::array<Index, 4>, 6> tets_of_cell(unsigned mirror);

/// make_box_mesh() without what make_tet_mesh() finds: tets alone.
/// @throws Error as it does
[[nodiscard]] TetMesh make_box_tets(const BoxCells& box);

inline constexpr Index tets_per_cell = 6;
/// Calls act(tet, corner) for the tets of a box that touch a node, ascending.
template <class Act>
void each_tet_of_box_node(const TetMesh& mesh, Index node, const Act& act) {
  each_cell_of_node(*mesh.box, place_of(*mesh.box, node), [&](Index cell, Index /*slot*/) {
    for (Index tet = tets_per_cell * cell; tet < tets_per_cell * (cell + 1); ++tet) {
      for (Index c = 0; c < 4; ++c) {
        if (mesh.tets[at(tet)][at(c)] == node) act(tet, c);
      }
    }
  });
}

/// Whether a box, which somebody may have written by hand, has at least one cell along each axis, so many nodes, and no
/// cell mirrored before the first.
[[nodiscard]] bool is_box_of(const BoxCells& box, Index nodes);

/// Whether a mesh has the tets that make_box_mesh() makes of its box.
[[nodiscard]] bool has_tets_of_box(const TetMesh& mesh);

/// Makes what make_tet_mesh() finds in the tets of make_box_mesh(): all of the mesh but these.
void write_box_lists(TetMesh& mesh);

/// edges_of_nodes() of edges between neighbours in a box.
/// @param reach edges are alike where cells are that are so far from their lower nodes (alike_nodes.h)
/// @param first per node: the first of its edges to higher nodes; and one more
[[nodiscard]] IncidenceList edges_of_box_nodes(const BoxCells& box, Index reach, std::span<const Index> first,
                                               std::span<const std::array<Index, 2>> edges);

/// What belongs to each edge from a node to a higher one, in a box.
/// @param each called as each(node, edge, act); calls act(entry) for the entries of an edge, of the first node of each
/// kind
/// @param move as move_rows() takes it
template <class Each, class Move>
[[nodiscard]] IncidenceList lists_of_box_edges(const AlikeNodes& nodes, std::span<const Index> first, const Each& each,
                                               const Move& move) {
  const auto no_scratch = [] { return 0; };
  HostList<Index> first_of_node;
  IncidenceList list;
  list.first.reserve(at(first.back()) + 1);
  move_rows(
      nodes, no_scratch,
      [&](index_t node, int /*scratch*/, std::vector<Index>& row) {
        for (Index e = first[at(node)]; e < first[at(node) + 1]; ++e) {
          row.push_back(0);
          each(static_cast<Index>(node), e, [&row](const IncidenceEntry& /*entry*/) { ++row.back(); });
        }
      },
      [](Index count, const AlikeNodes::Node& /*node*/) { return count; }, first_of_node, list.first);
  list.first.push_back(0);
  (void)exclusive_scan(Host{}, std::span(list.first));
  move_rows(
      nodes, no_scratch,
      [&](index_t node, int /*scratch*/, std::vector<IncidenceEntry>& row) {
        for (Index e = first[at(node)]; e < first[at(node) + 1]; ++e) {
          each(static_cast<Index>(node), e, [&row](const IncidenceEntry& entry) { row.push_back(entry); });
        }
      },
      move, first_of_node, list.entries);
  return list;
}

}  // namespace physgen::fem::detail
