// Nodes are divided by planes, at the middle of the longest side of what they span, until a brick is left.
#include <fem/kernels/edge_bricks.h>
#include <physgen/error.h>
#include <physgen/storage.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <string>

namespace physgen::fem {

namespace {

using Points = std::vector<std::array<double, 3>>;

Index brick_count(Index nodes) {
  return nodes <= EdgeBricks::few_nodes ? 1 : (nodes + EdgeBricks::most_nodes - 1) / EdgeBricks::most_nodes;
}

/// The direction in which nodes reach farthest.
std::size_t longest_side(std::span<const Index> nodes, const Points& positions) {
  constexpr double far = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{far, far, far}, high{-far, -far, -far};
  for (const Index node : nodes) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], positions[static_cast<std::size_t>(node)][k]);
      high[k] = std::max(high[k], positions[static_cast<std::size_t>(node)][k]);
    }
  }
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (high[k] - low[k] > high[longest] - low[longest]) longest = k;
  }
  return longest;
}

/// Orders the nodes of the bricks first .. last-1, of which `order` has the places.
void divide(const EdgeBricks::View& bricks, Index first, Index last, std::span<Index> order, const Points& positions) {
  if (last - first == 1) {
    std::ranges::sort(order);
    return;
  }
  const Index middle = first + (last - first) / 2;
  const Index below = bricks.places_begin(middle) - bricks.places_begin(first);
  const std::size_t k = longest_side(order, positions);
  std::ranges::nth_element(order, order.begin() + below, [&](Index a, Index b) {
    const double at_a = positions[static_cast<std::size_t>(a)][k], at_b = positions[static_cast<std::size_t>(b)][k];
    return at_a != at_b ? at_a < at_b : a < b;
  });
  divide(bricks, first, middle, order.first(static_cast<std::size_t>(below)), positions);
  divide(bricks, middle, last, order.subspan(static_cast<std::size_t>(below)), positions);
}

}  // namespace

EdgeBricks::View EdgeBricks::view() const {
  const auto* lists = reinterpret_cast<const Index*>(lists_.data());
  const Index* begin = lists + nodes_;
  const Index* first = begin + nodes_ + 1;
  return {nodes_, bricks_, lists, begin, first, first + nodes_ + 1};
}

EdgeBricks::EdgeBricks(const TetMesh& mesh, const std::vector<std::array<double, 3>>& positions, SpaceKind space)
    : nodes_(mesh.nodes), bricks_(brick_count(mesh.nodes)) {
  const auto nodes = static_cast<std::size_t>(nodes_);
  if (positions.size() != nodes) {
    throw Error("a mesh of " + std::to_string(nodes) + " nodes was given " + std::to_string(positions.size()) +
                " positions; bricks of nodes need one for each");
  }
  std::vector<Index> lists(static_cast<std::size_t>(bytes_for(nodes_, index_t(mesh.edges.size()))) / sizeof(Index), 0);
  const std::span<Index> order(lists.data(), nodes), begin(lists.data() + nodes, nodes + 1),
      first(lists.data() + 2 * nodes + 1, nodes + 1), others(lists.data() + 3 * nodes + 2, mesh.edges.size());
  const View bricks{nodes_, bricks_, nullptr, nullptr, nullptr, nullptr};
  std::iota(order.begin(), order.end(), Index{0});
  divide(bricks, 0, bricks_, order, positions);

  for (const auto& edge : mesh.edges) ++first[static_cast<std::size_t>(edge[0]) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  const auto edges_of = [&](Index node) {
    return first[static_cast<std::size_t>(node) + 1] - first[static_cast<std::size_t>(node)];
  };
  std::vector<Index> place(nodes);
  for (std::size_t p = 0; p < nodes; ++p) {
    begin[p + 1] = begin[p] + edges_of(order[p]);
    place[static_cast<std::size_t>(order[p])] = static_cast<Index>(p);
  }
  for (Index b = 0; b < bricks_; ++b) {
    const Index from = bricks.places_begin(b), to = bricks.places_begin(b + 1);
    for (Index p = from; p < to; p += slice) {
      auto next = static_cast<std::size_t>(begin[static_cast<std::size_t>(p)]);
      const auto last = static_cast<std::size_t>(begin[static_cast<std::size_t>(std::min(p + slice, to))]);
      for (Index k = 0; next < last; ++k) {
        for (Index q = p; q < std::min(p + slice, to); ++q) {
          const Index node = order[static_cast<std::size_t>(q)];
          if (k >= edges_of(node)) continue;
          const auto edge = static_cast<std::size_t>(first[static_cast<std::size_t>(node)] + k);
          const Index other = mesh.edges[edge][1];
          const Index at = place[static_cast<std::size_t>(other)];
          others[next++] = from <= at && at < to ? ~(at - from) : other;
        }
      }
    }
  }
  const auto bytes = static_cast<index_t>(lists.size() * sizeof(Index));
  lists_ = Buffer(space, bytes, "bricks of " + std::to_string(nodes) + " nodes");
  copy_memory(lists_.data(), space, reinterpret_cast<const std::byte*>(lists.data()), SpaceKind::host, bytes);
}

}  // namespace physgen::fem
