// The graph of a background grid's level: which of its nodes the stiffness connects, and from which
// blocks of the finer level. For hierarchy.cpp.
#pragma once

#include <fem/solver/hierarchy/graph_lists.h>
#include <fem/solver/mesh_level.h>

#include <algorithm>
#include <numeric>

namespace physgen::fem::detail {

/// Calls visit(A, B), A < B, for each two coarse nodes between which a block of fine nodes a and b, or of a alone, has
/// a part.
template <class Visit>
void for_each_grid_pair(const GridLocation& a, const GridLocation& b, const Visit& visit) {
  std::array<std::array<Index, 2>, 16> pairs{};
  auto end = pairs.begin();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (a.weights[i] == 0 || b.weights[j] == 0 || a.nodes[i] == b.nodes[j]) continue;
      *end++ = {std::min(a.nodes[i], b.nodes[j]), std::max(a.nodes[i], b.nodes[j])};
    }
  }
  std::sort(pairs.begin(), end);
  end = std::unique(pairs.begin(), end);
  std::for_each(pairs.begin(), end, [&](const auto& pair) { visit(pair[0], pair[1]); });
}

/// One node of each set of nodes that hang on the same parents; those of one tet of the grid, mostly.
[[nodiscard]] inline std::vector<Index> representatives(const std::vector<GridLocation>& parents) {
  std::vector<Index> order(parents.size()), first(parents.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto corners = [&](Index n) -> const std::array<Index, 4>& {
    return parents[static_cast<std::size_t>(n)].nodes;
  };
  std::ranges::sort(order,
                    [&](Index m, Index n) { return corners(m) != corners(n) ? corners(m) < corners(n) : m < n; });
  Index own = 0;
  for (const Index n : order) {
    if (corners(n) != corners(own)) own = n;
    first[static_cast<std::size_t>(n)] = own;
  }
  return first;
}

/// Coarse pairs that P^T K P of these edges may fill, ascending. Edges between the same two tets fill the same pairs.
[[nodiscard]] inline std::vector<std::array<Index, 2>> grid_pairs(std::vector<std::array<Index, 2>> edges,
                                                                  const std::vector<GridLocation>& parents) {
  const std::vector<Index> first = representatives(parents);
  for (auto& edge : edges) {
    for (Index& end : edge) end = first[static_cast<std::size_t>(end)];
    std::ranges::sort(edge);
  }
  for (const Index n : first) edges.push_back({n, n});
  sort_unique(edges);
  std::vector<std::array<Index, 2>> pairs;
  for (const auto& [a, b] : edges) {
    for_each_grid_pair(parents[static_cast<std::size_t>(a)], parents[static_cast<std::size_t>(b)],
                       [&](Index A, Index B) { pairs.push_back({A, B}); });
  }
  sort_unique(pairs);
  return pairs;
}

}  // namespace physgen::fem::detail
