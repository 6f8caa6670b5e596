// Boost.Graph orders the nodes of each connected part; the tets are sorted by the result.
#include <fem/mesh/renumber.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/cuthill_mckee_ordering.hpp>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <utility>

namespace physgen::fem {

namespace {

using Vertex = std::uint32_t;
using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                 boost::no_property, Vertex, std::uint32_t>;

std::vector<Index> counted_up(std::size_t count) {
  std::vector<Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), Index{0});
  return numbers;
}

template <class Visit>
void each_neighbour(const TetMesh& mesh, Index node, const Visit& visit) {
  const auto n = static_cast<std::size_t>(node);
  for (Index k = mesh.node_edges.first[n]; k < mesh.node_edges.first[n + 1]; ++k) {
    const auto [edge, side] = mesh.node_edges.entries[static_cast<std::size_t>(k)];
    visit(mesh.edges[static_cast<std::size_t>(edge)][static_cast<std::size_t>(1 - side)]);
  }
}

// All nodes, one connected part after the other: part p is nodes[first[p]] up to, not including, nodes[first[p + 1]].
// Parts by their lowest node, each in breadth-first order from there, so that later walks over it find it in the cache.
struct Parts {
  std::vector<Index> nodes;
  std::vector<std::size_t> first;  // one more than there are parts
};

Parts connected_parts(const TetMesh& mesh) {
  Parts parts;
  parts.nodes.reserve(static_cast<std::size_t>(mesh.nodes));
  std::vector<bool> reached(static_cast<std::size_t>(mesh.nodes));
  const auto reach = [&parts, &reached](Index node) {
    if (reached[static_cast<std::size_t>(node)]) return;
    reached[static_cast<std::size_t>(node)] = true;
    parts.nodes.push_back(node);
  };
  for (Index start = 0; start < mesh.nodes; ++start) {
    if (reached[static_cast<std::size_t>(start)]) continue;
    std::size_t next = parts.nodes.size();
    parts.first.push_back(next);
    reach(start);
    for (; next < parts.nodes.size(); ++next) each_neighbour(mesh, parts.nodes[next], reach);
  }
  parts.first.push_back(parts.nodes.size());
  return parts;
}

// The edges between the nodes of one part, both ways; vertex v is node part[v], and place[part[v]] is v.
Graph graph_of(const TetMesh& mesh, std::span<const Index> part, const std::vector<Vertex>& place) {
  std::vector<std::pair<Vertex, Vertex>> ends;
  for (std::size_t v = 0; v < part.size(); ++v) {
    each_neighbour(mesh, part[v], [&](Index neighbour) {
      ends.emplace_back(static_cast<Vertex>(v), place[static_cast<std::size_t>(neighbour)]);
    });
  }
  return {boost::edges_are_sorted, ends.begin(), ends.end(), static_cast<Vertex>(part.size()),
          static_cast<std::uint32_t>(ends.size())};
}

// Each part is a graph of its own, because Boost visits all vertices of a graph again for each of its parts: with many
// parts, such as loose nodes, one graph would take quadratic time.
std::vector<Index> reverse_cuthill_mckee(const TetMesh& mesh) {
  const Parts parts = connected_parts(mesh);
  std::vector<Vertex> place(parts.nodes.size());
  std::vector<Index> order;
  order.reserve(parts.nodes.size());
  for (std::size_t p = 0; p + 1 < parts.first.size(); ++p) {
    const auto part = std::span(parts.nodes).subspan(parts.first[p], parts.first[p + 1] - parts.first[p]);
    for (std::size_t v = 0; v < part.size(); ++v) place[static_cast<std::size_t>(part[v])] = static_cast<Vertex>(v);
    std::vector<Vertex> vertices(part.size());
    boost::cuthill_mckee_ordering(graph_of(mesh, part, place), vertices.rbegin());
    for (const Vertex v : vertices) order.push_back(part[v]);
  }
  return order;
}

// The new number of each old one, of which there are `count`.
// @throws Error when `order` does not name each of them once
std::vector<Index> inverse_of(const std::vector<Index>& order, std::size_t count, const std::string& name) {
  const auto refuse = [&](const std::string& what) {
    throw Error("renumbering: " + name + what + "; name each of the " + std::to_string(count) +
                " old numbers from 0 on once");
  };
  const auto entry = [&](std::size_t i) { return "[" + std::to_string(i) + "]"; };
  if (order.size() != count) refuse(" has " + std::to_string(order.size()) + " entries");
  constexpr Index none = -1;
  std::vector<Index> inverse(count, none);
  for (std::size_t i = 0; i < count; ++i) {
    const Index old = order[i];
    if (old < 0 || std::cmp_greater_equal(old, count)) {
      refuse(entry(i) + " is " + std::to_string(old) + ", which is not an old number");
    }
    Index& number = inverse[static_cast<std::size_t>(old)];
    if (number != none) {
      refuse(entry(i) + " is " + std::to_string(old) + ", as is " + name + entry(static_cast<std::size_t>(number)));
    }
    number = static_cast<Index>(i);
  }
  return inverse;
}

std::array<Index, 4> renumbered_tet(std::array<Index, 4> corners, const std::vector<Index>& new_node) {
  for (Index& corner : corners) corner = new_node[static_cast<std::size_t>(corner)];
  return corners;
}

std::vector<Index> tets_by_lowest_node(const TetMesh& mesh, const std::vector<Index>& new_node) {
  std::vector<std::pair<std::array<Index, 4>, Index>> keys;  // new corners, ascending, and the old number
  keys.reserve(mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    keys.emplace_back(renumbered_tet(mesh.tets[t], new_node), static_cast<Index>(t));
    std::ranges::sort(keys.back().first);
  }
  std::ranges::sort(keys);
  std::vector<Index> order;
  order.reserve(keys.size());
  for (const auto& [corners, tet] : keys) order.push_back(tet);
  return order;
}

}  // namespace

Renumbering renumber_for_locality(const TetMesh& mesh) {
  Renumbering numbers;
  numbers.node_order = reverse_cuthill_mckee(mesh);
  numbers.tet_order =
      tets_by_lowest_node(mesh, inverse_of(numbers.node_order, numbers.node_order.size(), "node_order"));
  return numbers;
}

Renumbering random_numbering(const TetMesh& mesh, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  // Fisher and Yates's shuffle spelt out, because std::shuffle differs between libraries.
  const auto shuffled = [&random](std::size_t count) {
    std::vector<Index> order = counted_up(count);
    for (std::size_t left = count; left > 1; --left) std::swap(order[left - 1], order[random() % left]);
    return order;
  };
  Renumbering numbers;
  numbers.node_order = shuffled(static_cast<std::size_t>(mesh.nodes));
  numbers.tet_order = shuffled(mesh.tets.size());
  return numbers;
}

TetMesh renumbered(const TetMesh& mesh, const Renumbering& numbers) {
  const auto new_node = inverse_of(numbers.node_order, static_cast<std::size_t>(mesh.nodes), "node_order");
  static_cast<void>(inverse_of(numbers.tet_order, mesh.tets.size(), "tet_order"));  // for its checks
  std::vector<std::array<Index, 4>> tets;
  tets.reserve(mesh.tets.size());
  for (const Index t : numbers.tet_order) {
    tets.push_back(renumbered_tet(mesh.tets[static_cast<std::size_t>(t)], new_node));
  }
  return make_tet_mesh(mesh.nodes, std::move(tets));
}

}  // namespace physgen::fem
