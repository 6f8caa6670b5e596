// Windows of a state: so many nodes or tets at once that what is made of them fits the bytes of a window.
#pragma once

#include <fem/mesh/mesh.h>
#include <physgen/detail/host_loop.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "body_state.h"

namespace physgen::truthcube {

/// How many a window has: half of its bytes are for nodes, half for tets, since some are made of both. A node has its
/// number, its place at rest and now, which the first rank has twice while it comes, and four fields with what they are
/// averaged by. A tet has up to four nodes that no other has, its stress, twice, and eight fields.
class WindowSizes {
 public:
  explicit WindowSizes(std::size_t bytes) : bytes_(bytes) {}
  [[nodiscard]] std::size_t nodes() const { return std::max<std::size_t>(bytes_ / 2 / bytes_of_node, 1); }
  [[nodiscard]] std::size_t tets() const { return std::max<std::size_t>(bytes_ / 2 / bytes_of_tet, 1); }
  /// What windows take at most of so many nodes and tets.
  [[nodiscard]] std::size_t bytes(std::size_t nodes_of_all, std::size_t tets_of_all) const {
    return bytes_of_node * std::min(nodes(), nodes_of_all) + bytes_of_tet * std::min(tets(), tets_of_all);
  }

 private:
  static constexpr std::size_t bytes_of_node = 128, bytes_of_tet = 512;
  std::size_t bytes_;
};

/// Calls body(numbers) with the numbers begin .. end-1, at most `most` of them each time, in ascending order.
template <class Body>
void each_window(std::size_t begin, std::size_t end, std::size_t most, const Body& body) {
  std::vector<fem::Index> numbers;
  for (std::size_t first = begin; first < end; first += most) {
    numbers.resize(std::min(most, end - first));
    std::iota(numbers.begin(), numbers.end(), static_cast<fem::Index>(first));
    body(std::span<const fem::Index>(numbers));
  }
}

/// A tet in a state.
struct TetState {
  std::array<fem::Point, 4> rest, positions;  ///< of its corners [m]
  std::array<double, 9> stress;               ///< as of BodyState
};

/// Calls visit(i, state) for tets[i], by several threads at once, on the rank that gets numbers.
/// @param tets those of a window
template <class Visit>
void each_tet(BodyState& state, const fem::TetMesh& mesh, std::span<const fem::Point> rest,
              std::span<const fem::Index> tets, const Visit& visit) {
  if (tets.empty()) return;
  const auto corners = [&](fem::Index tet) -> auto& { return mesh.tets[static_cast<std::size_t>(tet)]; };
  fem::Index low = mesh.nodes, high = -1;
  for (const fem::Index tet : tets) {
    const auto [least, most] = std::ranges::minmax(corners(tet));
    low = std::min(low, least), high = std::max(high, most);
  }
  const auto at = [low](fem::Index node) { return static_cast<std::size_t>(node - low); };
  std::vector<fem::Index> place(at(high) + 1, -1), nodes;
  for (const fem::Index tet : tets) {
    for (const fem::Index n : corners(tet)) place[at(n)] = 0;
  }
  for (fem::Index n = low; n <= high; ++n) {
    if (place[at(n)] < 0) continue;
    place[at(n)] = static_cast<fem::Index>(nodes.size());
    nodes.push_back(n);
  }
  const std::vector<fem::Point> positions = state.positions(0, nodes);
  const std::vector<std::array<double, 9>> stresses = state.stresses(tets);
  if (!state.is_here()) return;
  detail::host_loop(static_cast<index_t>(tets.size()), [&](index_t k) {
    const auto i = static_cast<std::size_t>(k);
    TetState tet;
    for (std::size_t c = 0; c < 4; ++c) {
      const fem::Index n = corners(tets[i])[c];
      tet.rest[c] = rest[static_cast<std::size_t>(n)];
      tet.positions[c] = positions[static_cast<std::size_t>(place[at(n)])];
    }
    tet.stress = stresses[i];
    visit(i, tet);
  });
}

}  // namespace physgen::truthcube
