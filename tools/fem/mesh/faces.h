// The triangles of a list of tets, each once, with the tets that have it: what boundaries, neighbours and checks need.
#pragma once

#include <fem/mesh/mesh.h>

#include <algorithm>
#include <array>
#include <compare>
#include <span>
#include <vector>

namespace physgen::fem {

/// A face as one tet has it.
struct FaceUse {
  std::array<Index, 3> nodes;  ///< ascending
  Index opposite;              ///< the tet's fourth node
  IncidenceEntry use;          ///< the tet, and which of its corners lies opposite
  auto operator<=>(const FaceUse&) const = default;
};

/// The face of `tet` that lies opposite its given corner.
[[nodiscard]] inline FaceUse face_use(std::span<const std::array<Index, 4>> tets, Index tet, Index corner) {
  const auto& nodes = tets[static_cast<std::size_t>(tet)];
  const auto skipped = static_cast<std::size_t>(corner);
  FaceUse face{{}, nodes[skipped], {tet, corner}};
  for (std::size_t c = 0, k = 0; c < 4; ++c) {
    if (c != skipped) face.nodes[k++] = nodes[c];
  }
  std::ranges::sort(face.nodes);
  return face;
}

/// Calls visit(std::span<const FaceUse>) once for each face, faces ascending by their nodes: all its uses, ascending.
/// Takes linear time where no node has very many tets, and 16 bytes per tet for a while.
/// @pre corners in [0, nodes); fewer than 2^30 tets
template <class Visit>
void each_face(Index nodes, std::span<const std::array<Index, 4>> tets, const Visit& visit) {
  // Uses by the lowest node of their face: use 4 t + c is that of tet t opposite corner c.
  std::vector<std::uint32_t> first(static_cast<std::size_t>(nodes) + 1), uses(4 * tets.size());
  const auto each_use = [&tets](const auto& act) {
    for (std::size_t t = 0; t < tets.size(); ++t) {
      const auto lowest = static_cast<std::size_t>(std::ranges::min_element(tets[t]) - tets[t].begin());
      Index second = tets[t][lowest == 0 ? 1 : 0];
      for (std::size_t c = 0; c < 4; ++c) {
        if (c != lowest) second = std::min(second, tets[t][c]);
      }
      for (std::size_t c = 0; c < 4; ++c) {
        const Index low = c == lowest ? second : tets[t][lowest];
        act(static_cast<std::size_t>(low), static_cast<std::uint32_t>(4 * t + c));
      }
    }
  };
  each_use([&first](std::size_t node, std::uint32_t /*use*/) { ++first[node + 1]; });
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  each_use([&next, &uses](std::size_t node, std::uint32_t use) { uses[next[node]++] = use; });

  std::vector<FaceUse> faces;  // of one lowest node
  for (std::size_t node = 0; node + 1 < first.size(); ++node) {
    faces.clear();
    for (std::uint32_t k = first[node]; k < first[node + 1]; ++k) {
      faces.push_back(face_use(tets, static_cast<Index>(uses[k] / 4), static_cast<Index>(uses[k] % 4)));
    }
    std::ranges::sort(faces);
    for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
      while (end < faces.size() && faces[end].nodes == faces[begin].nodes) ++end;
      visit(std::span<const FaceUse>(faces).subspan(begin, end - begin));
    }
  }
}

}  // namespace physgen::fem
