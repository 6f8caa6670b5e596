#include <fem/mesh/at.h>
#include <fem/solver/loads/pressed_faces.h>
#include <physgen/error.h>

#include <algorithm>
#include <string>

namespace physgen::fem {

namespace {

/// The node that two edges of the coarser mesh share, or -1.
Index common(const std::array<Index, 2>& a, const std::array<Index, 2>& b) {
  if (a[0] == b[0] || a[0] == b[1]) return a[0];
  if (a[1] == b[0] || a[1] == b[1]) return a[1];
  return -1;
}

/// Rows of entries in the order in which they are given. @param rows of each entry
IncidenceList rows_of(Index count, std::span<const Index> rows, std::span<const IncidenceEntry> entries) {
  IncidenceList list;
  list.first.assign(at(count) + 1, 0);
  for (const Index row : rows) ++list.first[at(row) + 1];
  for (std::size_t r = 0; r < at(count); ++r) list.first[r + 1] += list.first[r];
  std::vector<Index> next(list.first.begin(), list.first.end() - 1);
  list.entries.resize(entries.size());
  for (std::size_t k = 0; k < entries.size(); ++k) list.entries[at(next[at(rows[k])]++)] = entries[k];
  return list;
}

}  // namespace

std::vector<PressedFace> pressed_faces(std::span<const FollowingPressure> pressures) {
  std::vector<PressedFace> faces;
  for (const FollowingPressure& pressure : pressures) {
    for (const Face& face : pressure.faces) faces.push_back({face, pressure.pressure});
  }
  return faces;
}

std::vector<PressedFace> coarser_faces(std::span<const PressedFace> faces,
                                       std::span<const std::array<Index, 2>> parents) {
  std::vector<PressedFace> coarser;
  for (const PressedFace& face : faces) {
    const auto middles = [&](std::size_t k) { return parents[at(face.nodes[k])]; };
    if (!std::ranges::all_of(face.nodes, [&](Index n) { return parents[at(n)][0] != parents[at(n)][1]; })) continue;
    const Face corners{common(middles(2), middles(0)), common(middles(0), middles(1)), common(middles(1), middles(2))};
    if (std::ranges::find(corners, -1) == corners.end()) coarser.push_back({corners, face.pressure});
  }
  if (4 * coarser.size() != faces.size()) {
    throw Error("a pressure that follows the surface pushes " + std::to_string(faces.size()) +
                " faces, which have to be quarters of those of the next coarser mesh, and are so of " +
                std::to_string(coarser.size()) + "; make levels by refine(), or take no nested steps");
  }
  return coarser;
}

FaceLists lists_of(std::span<const PressedFace> faces, Index nodes, std::span<const std::array<Index, 2>> edges) {
  std::vector<Index> corners, sides;
  std::vector<IncidenceEntry> entries;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Face& face = faces[f].nodes;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(face[(k + 1) % 3], face[(k + 2) % 3]);
      const auto edge = std::ranges::lower_bound(edges, std::array{low, high});
      if (edge == edges.end() || *edge != std::array{low, high}) {
        throw Error("a pressure that follows the surface pushes a face with the nodes " + std::to_string(low) +
                    " and " + std::to_string(high) + ", which no tet has as an edge; give faces of the mesh's surface");
      }
      corners.push_back(face[k]);
      sides.push_back(static_cast<Index>(edge - edges.begin()));
      entries.push_back({static_cast<Index>(f), static_cast<Index>(k)});
    }
  }
  return {rows_of(nodes, corners, entries), rows_of(static_cast<Index>(edges.size()), sides, entries)};
}

}  // namespace physgen::fem
