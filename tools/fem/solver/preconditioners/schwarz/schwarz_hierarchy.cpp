#include <fem/mesh/at.h>
#include <fem/solver/preconditioners/schwarz/schwarz_hierarchy.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace physgen::fem {

namespace {

using Pair = std::array<Index, 2>;

Index whole_blocks(Index slots) { return (slots + schwarz_slots - 1) / schwarz_slots; }

/// Two bits between each two of the lowest 21 bits.
std::uint64_t spread(std::uint64_t bits) {
  bits &= 0x1fffffULL;
  bits = (bits | bits << 32U) & 0x1f00000000ffffULL;
  bits = (bits | bits << 16U) & 0x1f0000ff0000ffULL;
  bits = (bits | bits << 8U) & 0x100f00f00f00f00fULL;
  bits = (bits | bits << 4U) & 0x10c30c30c30c30c3ULL;
  return (bits | bits << 2U) & 0x1249249249249249ULL;
}

/// Nodes with a free component along a Morton curve through their bounding cube.
std::vector<Index> morton_order(const LevelGraph& graph, const std::vector<Point>& rest) {
  Point low{}, high{};
  for (std::size_t k = 0; k < 3 && !rest.empty(); ++k) {
    const auto [least, most] = std::ranges::minmax(rest, {}, [k](const Point& x) { return x[k]; });
    low[k] = least[k];
    high[k] = most[k];
  }
  const double side = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  constexpr double cells = 1 << 21;
  std::vector<std::pair<std::uint64_t, Index>> keys;
  for (Index n = 0; n < graph.nodes; ++n) {
    if (graph.fixed[at(n)] == 7) continue;
    std::uint64_t key = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double cell = side > 0 ? (rest[at(n)][k] - low[k]) / side * cells : 0;
      key |= spread(static_cast<std::uint64_t>(std::clamp(cell, 0.0, cells - 1))) << k;
    }
    keys.emplace_back(key, n);
  }
  std::ranges::sort(keys);
  std::vector<Index> order;
  order.reserve(keys.size());
  for (const auto& [key, node] : keys) order.push_back(node);
  return order;
}

/// Entries under the objects they belong to; objects ascend from call to call of append().
void append(SchwarzList& list, std::size_t objects, const std::vector<Index>& object, const std::vector<Pair>& entry) {
  if (list.first.empty()) list.first.push_back(0);
  const std::size_t old = list.first.size() - 1, begin = list.entries.size();
  list.first.resize(old + objects + 1, 0);
  for (const Index o : object) ++list.first[old + at(o) + 1];
  std::partial_sum(list.first.begin() + static_cast<std::ptrdiff_t>(old), list.first.end(),
                   list.first.begin() + static_cast<std::ptrdiff_t>(old));
  std::vector<Index> next(list.first.begin() + static_cast<std::ptrdiff_t>(old), list.first.end() - 1);
  list.entries.resize(begin + entry.size());
  for (std::size_t k = 0; k < entry.size(); ++k) list.entries[at(next[at(object[k])]++)] = entry[k];
}

/// One level while the next is made of it. Members are numbered on their level from 0.
struct Level {
  std::vector<Index> members;     ///< per slot of the level, in whole blocks; -1: none
  std::vector<Index> places;      ///< per member: its slot on the level; -1: none
  std::vector<Pair> edges;        ///< of members
  std::vector<Index> components;  ///< per slot: the first slot that it is connected with inside its block

  [[nodiscard]] Index blocks() const { return static_cast<Index>(members.size()) / schwarz_slots; }

  /// Finds components, and sorts the slots of each block so that those of one component lie side by side.
  void order_by_components() {
    components.resize(members.size());
    std::iota(components.begin(), components.end(), Index{0});
    const auto root = [&](Index s) {
      while (components[at(s)] != s) s = components[at(s)] = components[at(components[at(s)])];
      return s;
    };
    for (const auto& [m, n] : edges) {
      const Index a = places[at(m)], b = places[at(n)];
      if (a < 0 || b < 0 || a / schwarz_slots != b / schwarz_slots) continue;
      const Index p = root(a), q = root(b);
      components[at(std::max(p, q))] = std::min(p, q);
    }
    std::vector<std::array<Index, 3>> sorted;  // whether empty and first slot of the component; slot; member
    for (Index s = 0; s < static_cast<Index>(members.size()); ++s) {
      const bool empty = members[at(s)] < 0;
      sorted.push_back({empty ? std::numeric_limits<Index>::max() : root(s), s, members[at(s)]});
    }
    for (Index b = 0; b < blocks(); ++b) {
      const auto begin = sorted.begin() + std::ptrdiff_t{b} * schwarz_slots, end = begin + schwarz_slots;
      std::sort(begin, end);
      Index first = b * schwarz_slots;
      for (Index k = 0; k < schwarz_slots; ++k) {
        const Index slot = b * schwarz_slots + k;
        const auto& [component, before, member] = begin[k];
        if (k > 0 && component != begin[k - 1][0]) first = slot;
        members[at(slot)] = member;
        components[at(slot)] = first;
        if (member >= 0) places[at(member)] = slot;
      }
    }
  }
};

/// The supernodes of a level, numbered so that those of one block lie in one block of the next level.
/// @param parents per slot of `level`, written
Level make_next(const Level& level, std::vector<Index>& parents) {
  Level next;
  parents.assign(level.members.size(), -1);
  Index count = 0;
  for (Index b = 0; b < level.blocks(); ++b) {
    Index own = 0;
    for (Index k = 0; k < schwarz_slots; ++k) {
      const Index slot = b * schwarz_slots + k;
      own += level.members[at(slot)] >= 0 && level.components[at(slot)] == slot ? 1 : 0;
    }
    if (count % schwarz_slots + own > schwarz_slots) count = whole_blocks(count) * schwarz_slots;
    for (Index k = 0; k < schwarz_slots; ++k) {
      const Index slot = b * schwarz_slots + k, first = level.components[at(slot)];
      if (level.members[at(slot)] < 0) continue;
      parents[at(slot)] = first == slot ? count++ : parents[at(first)];
    }
  }
  next.members.assign(at(whole_blocks(count) * schwarz_slots), -1);
  next.places.assign(next.members.size(), -1);
  for (const Index p : parents) {
    if (p >= 0) next.members[at(p)] = next.places[at(p)] = p;
  }
  for (const auto& [m, n] : level.edges) {
    const Index a = level.places[at(m)], b = level.places[at(n)];
    if (a < 0 || b < 0) continue;
    const Index p = parents[at(a)], q = parents[at(b)];
    if (p != q) next.edges.push_back({std::min(p, q), std::max(p, q)});
  }
  std::ranges::sort(next.edges);
  next.edges.erase(std::unique(next.edges.begin(), next.edges.end()), next.edges.end());
  // Supernodes take the numbers of their slots.
  next.order_by_components();
  for (Index& p : parents) {
    if (p >= 0) p = next.places[at(p)];
  }
  for (auto& [m, n] : next.edges) {
    m = next.places[at(m)];
    n = next.places[at(n)];
    if (m > n) std::swap(m, n);
  }
  std::ranges::sort(next.edges);
  for (Index s = 0; s < static_cast<Index>(next.members.size()); ++s) {
    Index& member = next.members[at(s)];
    next.places[at(s)] = member < 0 ? -1 : s;
    if (member >= 0) member = s;
  }
  return next;
}

/// Edges of each block, as they stand in it. @param edge_base number of the level's first edge
void add_block_edges(SchwarzHierarchy& hierarchy, const Level& level, Index edge_base) {
  std::vector<Index> blocks;
  std::vector<Pair> entries;
  for (std::size_t e = 0; e < level.edges.size(); ++e) {
    const Index a = level.places[at(level.edges[e][0])], b = level.places[at(level.edges[e][1])];
    if (a < 0 || b < 0 || a / schwarz_slots != b / schwarz_slots) continue;
    blocks.push_back(a / schwarz_slots);
    entries.push_back({edge_base + static_cast<Index>(e), a % schwarz_slots + schwarz_slots * (b % schwarz_slots)});
  }
  append(hierarchy.block_edges, at(level.blocks()), blocks, entries);
}

/// The terms of the next level's stiffness. @param base number of the level's first supernode, 0 of nodes
void add_terms(SchwarzHierarchy& hierarchy, const Level& level, const Level& next, const std::vector<Index>& parents,
               Index base, Index edge_base) {
  std::vector<Index> supernodes, pairs;
  std::vector<Pair> supernode_terms, pair_terms;
  for (std::size_t s = 0; s < level.members.size(); ++s) {
    if (level.members[s] < 0) continue;
    supernodes.push_back(parents[s]);
    supernode_terms.push_back({base + level.members[s], 0});
  }
  for (std::size_t e = 0; e < level.edges.size(); ++e) {
    const Index a = level.places[at(level.edges[e][0])], b = level.places[at(level.edges[e][1])];
    if (a < 0 || b < 0) continue;
    const Index p = parents[at(a)], q = parents[at(b)], edge = edge_base + static_cast<Index>(e);
    if (p == q) {
      supernodes.push_back(p);
      supernode_terms.push_back({edge, 1});
    } else {
      const auto found = std::ranges::lower_bound(next.edges, Pair{std::min(p, q), std::max(p, q)});
      pairs.push_back(static_cast<Index>(found - next.edges.begin()));
      pair_terms.push_back({edge, p < q ? 0 : 1});
    }
  }
  append(hierarchy.supernode_terms, next.members.size(), supernodes, supernode_terms);
  append(hierarchy.pair_terms, next.edges.size(), pairs, pair_terms);
}

}  // namespace

SchwarzHierarchy make_schwarz_hierarchy(const LevelGraph& graph, const std::vector<Point>& rest) {
  SchwarzHierarchy hierarchy;
  Level level;
  level.members = morton_order(graph, rest);
  level.members.resize(at(whole_blocks(static_cast<Index>(level.members.size())) * schwarz_slots), -1);
  level.places.assign(at(graph.nodes), -1);
  for (std::size_t s = 0; s < level.members.size(); ++s) {
    if (level.members[s] >= 0) level.places[at(level.members[s])] = static_cast<Index>(s);
  }
  level.edges.assign(graph.edges.begin(), graph.edges.end());
  level.order_by_components();
  hierarchy.node_slots = level.places;
  hierarchy.first_block = {0, level.blocks()};
  hierarchy.first_pair = {0};
  append(hierarchy.supernode_terms, 0, {}, {});
  append(hierarchy.pair_terms, 0, {}, {});
  Index base = 0, edge_base = 0, first_block = 0;  // of this level; those of nodes and edges count for themselves
  for (bool of_nodes = true;; of_nodes = false) {
    add_block_edges(hierarchy, level, edge_base);
    std::vector<Index> parents(level.members.size(), -1);
    Level next;
    if (level.blocks() > 1) next = make_next(level, parents);
    const bool last = next.blocks() == 0 || next.blocks() >= level.blocks();  // pieces apart from each other stay so
    const Index next_base = of_nodes ? 0 : base + static_cast<Index>(level.members.size());
    const Index next_block = first_block + level.blocks();
    for (std::size_t s = 0; s < level.members.size(); ++s) {
      const Index member = level.members[s];
      hierarchy.slots.push_back({member < 0 ? -1 : base + member, last || member < 0 ? -1 : next_base + parents[s]});
    }
    hierarchy.blocks.resize(at(next_block), {-1, 0});
    if (last) return hierarchy;
    hierarchy.blocks.resize(at(next_block + next.blocks()), {-1, 0});
    for (Index b = 0; b < level.blocks(); ++b) {  // the first slot of a block is taken
      const Index parent = next_block + parents[at(b * schwarz_slots)] / schwarz_slots;
      hierarchy.blocks[at(first_block + b)][0] = parent;
      ++hierarchy.blocks[at(parent)][1];
    }
    add_terms(hierarchy, level, next, parents, base, edge_base);
    hierarchy.first_block.push_back(next_block + next.blocks());
    edge_base = hierarchy.first_pair.back();
    hierarchy.first_pair.push_back(edge_base + static_cast<Index>(next.edges.size()));
    base = next_base;
    first_block = next_block;
    level = std::move(next);
  }
}

}  // namespace physgen::fem
