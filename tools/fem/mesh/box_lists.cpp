// What lies around a node depends on which of its eight cells there are and how they are mirrored: for the first node
// of each of the few kinds it is found among the tets, and moved to the others.
#include <fem/mesh/box_lists.h>
#include <fem/mesh/stages.h>

#include <algorithm>
#include <bit>

namespace physgen::fem::detail {

namespace {

void write_node_tets(TetMesh& mesh, const AlikeNodes& nodes) {
  InStage stage("rows of tets");
  move_rows(
      nodes, [] { return 0; },
      [&mesh](index_t n, int /*scratch*/, std::vector<IncidenceEntry>& row) {
        each_tet_of_box_node(mesh, static_cast<Index>(n),
                             [&](Index tet, Index corner) { row.push_back({tet, corner}); });
      },
      [&nodes](const IncidenceEntry& entry, const AlikeNodes::Node& node) {
        return IncidenceEntry{entry.element + tets_per_cell * nodes.cells_beyond(node), entry.local};
      },
      mesh.node_tets.first, mesh.node_tets.entries);
  stage.moves(mesh.node_tets.first, mesh.node_tets.entries);
}

// Calls act(other, entry) for the edges of a node's tets to higher nodes, tets ascending.
template <class Act>
void each_edge_of_tets(const TetMesh& mesh, Index node, const Act& act) {
  for (Index k = mesh.node_tets.first[at(node)]; k < mesh.node_tets.first[at(node) + 1]; ++k) {
    const Index tet = mesh.node_tets.entries[at(k)].element;
    for (Index local = 0; local < 6; ++local) {
      const Index a = mesh.tets[at(tet)][at(tet_edges[at(local)][0])];
      const Index b = mesh.tets[at(tet)][at(tet_edges[at(local)][1])];
      if (std::min(a, b) == node) act(std::max(a, b), IncidenceEntry{tet, a < b ? local : local + 6});
    }
  }
}

/// @return the first edge of each node to a higher one, and one more
HostList<Index> write_edges(TetMesh& mesh, const AlikeNodes& nodes) {
  InStage stage("edges and their tets");
  HostList<Index> first;
  move_rows(
      nodes, [] { return std::vector<Index>(); },
      [&mesh](index_t n, std::vector<Index>& higher, std::vector<std::array<Index, 2>>& row) {
        const auto node = static_cast<Index>(n);
        higher.clear();
        each_edge_of_tets(mesh, node, [&](Index other, const IncidenceEntry& /*entry*/) { higher.push_back(other); });
        std::ranges::sort(higher);
        const auto repeated = std::ranges::unique(higher);
        higher.erase(repeated.begin(), repeated.end());
        for (const Index other : higher) row.push_back({node, other});
      },
      [&nodes](const std::array<Index, 2>& edge, const AlikeNodes::Node& node) {
        return std::array{node.number, edge[1] + nodes.nodes_beyond(node)};
      },
      first, mesh.edges);
  mesh.edge_tets = lists_of_box_edges(
      nodes, first,
      [&mesh](Index node, Index edge, const auto& act) {
        each_edge_of_tets(mesh, node, [&](Index other, const IncidenceEntry& entry) {
          if (other == mesh.edges[at(edge)][1]) act(entry);
        });
      },
      [&nodes](const IncidenceEntry& entry, const AlikeNodes::Node& node) {
        return IncidenceEntry{entry.element + tets_per_cell * nodes.cells_beyond(node), entry.local};
      });
  stage.moves(mesh.edges, mesh.edge_tets.first, mesh.edge_tets.entries);
  return first;
}

}  // namespace

std::array<std::array<Index, 4>, 6> tets_of_cell(unsigned mirror) {
  // The six paths from corner 0 to corner 7 of a cell along its edges; odd ones have two corners exchanged, which turns
  // their volume positive.
  std::array<std::array<Index, 4>, 6> tets{
      {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 3, 2, 7}, {0, 5, 1, 7}, {0, 6, 4, 7}}};
  for (auto& tet : tets) {
    for (Index& corner : tet) corner ^= static_cast<Index>(mirror);
    if (std::popcount(mirror) % 2 != 0) std::swap(tet[1], tet[2]);  // a mirror turns volumes negative
  }
  return tets;
}

IncidenceList edges_of_box_nodes(const BoxCells& box, Index reach, std::span<const Index> first,
                                 std::span<const std::array<Index, 2>> edges) {
  InStage stage("rows of edges");
  const AlikeNodes nodes(box, reach + 1);  // those of lower neighbours, too
  // Of the first node of a kind: the lower node of an edge, twice its number among the edges of that, and the side.
  const auto visit = [&](index_t n, int /*scratch*/, std::vector<IncidenceEntry>& row) {
    const auto node = static_cast<Index>(n);
    const std::array<Index, 3> place = place_of(box, node);
    for (Index step = 0; step < 13; ++step) {  // to lower neighbours, ascending
      const std::array<Index, 3> lower{place[0] + step % 3 - 1, place[1] + step / 3 % 3 - 1, place[2] + step / 9 - 1};
      bool exists = true;
      for (std::size_t k = 0; k < 3; ++k) exists = exists && lower[k] >= 0 && lower[k] <= box.cells[k];
      if (!exists) continue;
      const Index m = lower[0] + (box.cells[0] + 1) * (lower[1] + (box.cells[1] + 1) * lower[2]);
      for (Index e = first[at(m)]; e < first[at(m) + 1]; ++e) {
        if (edges[at(e)][1] == node) row.push_back({m, 2 * (e - first[at(m)]) + 1});
      }
    }
    for (Index k = 0; k < first[at(n) + 1] - first[at(n)]; ++k) row.push_back({node, 2 * k});
  };
  const auto move = [&](const IncidenceEntry& entry, const AlikeNodes::Node& node) {
    const Index lower = entry.element + nodes.nodes_beyond(node);
    return IncidenceEntry{first[at(lower)] + (entry.local >> 1), entry.local & 1};
  };
  IncidenceList list;
  move_rows(nodes, [] { return 0; }, visit, move, list.first, list.entries);
  stage.moves(edges, list.first, list.entries);
  return list;
}

void write_box_lists(TetMesh& mesh) {
  const AlikeNodes nodes(*mesh.box, 1);
  write_node_tets(mesh, nodes);
  const HostList<Index> first = write_edges(mesh, nodes);
  mesh.node_edges = edges_of_box_nodes(*mesh.box, 1, first, mesh.edges);
}

}  // namespace physgen::fem::detail
