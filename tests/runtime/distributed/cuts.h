// Random sets whose objects name each other, and what a rank has of them as a plain search over all objects finds it:
// no group is left out, and nothing is kept from one search to the next.
#pragma once

#include <physgen/distributed/partition.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace cuts {
using namespace physgen;

inline std::size_t at(index_t i) { return static_cast<std::size_t>(i); }

/// What the objects of a set name by a field, or by rows: object by object, -1 for none.
struct Names {
  int source, target;
  std::vector<std::vector<index_t>> of;
};

struct Sets {
  enum Set { node, edge, quad, link, group, count };
  enum Field { edge_nodes, quad_nodes, link_nodes, link_edges, link_links, homes, ends, touches, edges_of, nodes_of };
  static constexpr std::array<const char*, count> name{"node", "edge", "quad", "link", "group"};
  std::array<index_t, count> size{};
  std::array<bool, count> follows{};  ///< nodes
  bool is_near;                       ///< names lie where what names them lies
  index_t none_in;                    ///< of so many numbers one is -1; or 0, none is
  std::vector<Names> names;           ///< in the order in which they are connected

  /// @param most nodes @param is_ordered as many nodes, and edges that follow them, and lie and name what lies as they
  /// do
  Sets(std::mt19937& random, index_t most, bool is_ordered) : is_near(random() % 3 != 0 || is_ordered) {
    const auto below = [&](index_t end) { return static_cast<index_t>(random()) % end; };
    size[node] = 1 + below(most);
    for (const Set set : {edge, quad, link}) size[set] = below(3) == 0 ? below(40) : below(3 * size[node] + 1);
    size[group] = 1 + below(size[node] / 4 + 1);
    follows = {false, random() % 4 != 0, random() % 2 == 0, true, false};
    if (is_ordered) size[node] = most, size[edge] = 3 * most, follows[edge] = true;
    none_in = is_ordered || random() % 2 == 0 ? 0 : 1 + below(300);  // of so many numbers one is -1
    const auto add = [&](Set source, Set target, index_t fewest, index_t largest) {
      Names& added = names.emplace_back(Names{source, target, {}});
      for (index_t i = 0; i < size[source]; ++i) {
        std::vector<index_t>& of = added.of.emplace_back();
        if (size[target] == 0 && fewest > 0) of.assign(at(largest), -1);
        if (size[target] == 0) continue;
        const bool has_none = fewest == 0 && i / 3000 % 3 == 1;
        for (index_t k = has_none ? 0 : fewest + below(largest - fewest + 1); k > 0; --k) {
          // A set that names itself falls into parts, since a rank has all that its objects lead to.
          const index_t around = (source == target ? i / 64 * 64 : i * size[target] / size[source]) + below(60);
          of.push_back(is_near ? std::min(around, size[target] - 1) : below(size[target]));
          if (none_in > 0 && below(none_in) == 0) of.back() = -1;
        }
      }
    };
    add(edge, node, 2, 2), add(quad, node, 4, 4), add(link, node, 2, 2), add(link, edge, 2, 2), add(link, link, 2, 2);
    add(node, group, 2, 2), add(node, edge, 0, 5), add(node, quad, 0, 5), add(group, edge, 0, 4),
        add(group, node, 0, 4);
  }
};

/// What a rank has of the sets.
struct Found {
  std::vector<Runs> runs;                 ///< of each set
  Runs computed = Runs::of_blocks(0, 1);  ///< of groups, those of each rank
  std::vector<std::vector<char>> is_here;
  std::vector<std::vector<std::uint64_t>> reached;  ///< of each object, where it is here

  [[nodiscard]] std::vector<index_t> ghosts(int set, int rank) const {
    std::vector<index_t> numbers;
    for (index_t i = 0; i < static_cast<index_t>(is_here[at(set)].size()); ++i) {
      if (is_here[at(set)][at(i)] != 0 && !runs[at(set)].owns(rank, i)) numbers.push_back(i);
    }
    return numbers;
  }
};

inline std::vector<index_t> begins_of(std::vector<index_t> counts) {
  std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), index_t{0});
  return counts;
}

/// Where the objects of a set that follows nodes begin on each rank.
inline Runs runs_of_following(const Sets& sets, int set, const Runs& nodes, int ranks) {
  std::vector<index_t> lowest_on(at(ranks), 0);
  for (index_t i = 0; i < sets.size[at(set)]; ++i) {
    int lowest = ranks;
    for (const Names& names : sets.names) {
      if (names.source != set || names.target != Sets::node) continue;
      for (const index_t number : names.of[at(i)]) {
        if (number >= 0) lowest = std::min(lowest, nodes.owner(number));
      }
    }
    if (lowest < ranks) ++lowest_on[at(lowest)];
  }
  return Runs::near(sets.size[at(set)], begins_of(lowest_on));
}

/// Where the objects that each rank computes begin: a rank and those above have the fewest named objects of ranks
/// below, and these have the fewest of theirs. Of places that are equally good it is the first.
inline Runs runs_of_computed(const Sets& sets, const std::vector<Runs>& runs, int ranks) {
  const index_t size = sets.size[Sets::group];
  std::vector<std::vector<int>> owners(at(size));
  for (index_t i = 0; i < size; ++i) {
    for (const Names& names : sets.names) {
      if (names.source != Sets::group) continue;
      for (const index_t number : names.of[at(i)]) {
        if (number >= 0) owners[at(i)].push_back(runs[at(names.target)].owner(number));
      }
    }
    if (owners[at(i)].empty()) owners[at(i)].push_back(static_cast<int>(i * ranks / size));
  }
  std::vector<index_t> begins;
  for (int rank = 0; rank < ranks; ++rank) {
    index_t others = 0;  // on the other side, where the rank begins with the first object
    for (const std::vector<int>& of_one : owners)
      others += std::ranges::count_if(of_one, [=](int o) { return o < rank; });
    index_t best = 0, fewest = others;
    for (index_t i = 0; i < size; ++i) {
      for (const int owner : owners[at(i)]) others += owner < rank ? -1 : 1;
      if (others < fewest) fewest = others, best = i + 1;
    }
    begins.push_back(best);
  }
  return Runs::at(size, begins);
}

inline Found search(const Sets& sets, int rank, int ranks) {
  Found found;
  for (int s = 0; s < Sets::count; ++s)
    found.runs.push_back(Runs::of_blocks(sets.size[at(s)], s == Sets::group ? 1 : ranks));
  for (int s = 0; s < Sets::count; ++s) {
    if (sets.follows[at(s)]) found.runs[at(s)] = runs_of_following(sets, s, found.runs[Sets::node], ranks);
  }
  found.computed = runs_of_computed(sets, found.runs, ranks);
  const auto is_owned = [&](int set, index_t i) { return set != Sets::group && found.runs[at(set)].owns(rank, i); };
  // Objects that are here, and of which all that they name is here.
  std::vector<std::vector<char>> is_whole;
  for (int s = 0; s < Sets::count; ++s) {
    std::vector<char>&here = found.is_here.emplace_back(at(sets.size[at(s)]), 0), &whole = is_whole.emplace_back(here);
    for (index_t i = 0; i < sets.size[at(s)]; ++i) {
      bool touches = s == Sets::group && found.computed.owns(rank, i);
      for (const Names& names : sets.names) {
        if (!sets.follows[at(s)] || names.source != s || names.target != Sets::node) continue;
        touches |= std::ranges::any_of(names.of[at(i)], [&](index_t n) { return n >= 0 && is_owned(Sets::node, n); });
      }
      here[at(i)] = s == Sets::group || touches || is_owned(s, i) ? 1 : 0;
      whole[at(i)] = touches || is_owned(s, i) ? 1 : 0;
    }
  }
  const auto each_named = [&](const auto& act) {  // act(source, object, target, number)
    for (const Names& names : sets.names) {
      for (index_t i = 0; i < sets.size[at(names.source)]; ++i) {
        for (const index_t number : names.of[at(i)]) {
          if (number >= 0 && names.target != Sets::group) act(names.source, i, names.target, number);
        }
      }
    }
  };
  for (bool is_again = true; is_again;) {
    is_again = false;
    each_named([&](int s, index_t i, int t, index_t number) {
      if (is_whole[at(s)][at(i)] == 0) return;
      found.is_here[at(t)][at(number)] = 1;
      if (!sets.follows[at(t)] || is_whole[at(t)][at(number)] != 0) return;
      is_whole[at(t)][at(number)] = 1;
      is_again = true;
    });
  }
  // What is not computed here reaches all.
  for (int s = 0; s < Sets::count; ++s) {
    std::vector<std::uint64_t>& reached = found.reached.emplace_back(at(sets.size[at(s)]), ~std::uint64_t{0});
    for (index_t i = 0; i < sets.size[at(s)]; ++i) {
      if (is_owned(s, i) || (sets.follows[at(s)] && found.is_here[at(s)][at(i)] != 0)) reached[at(i)] = 0;
    }
  }
  for (bool is_again = true; is_again;) {
    is_again = false;
    each_named([&](int s, index_t i, int t, index_t number) {
      if (s == Sets::group || found.is_here[at(s)][at(i)] == 0 || found.is_here[at(t)][at(number)] == 0) return;
      std::uint64_t& mine = found.reached[at(s)][at(i)];
      const std::uint64_t before = mine;
      if (!is_owned(t, number)) mine |= std::uint64_t{1} << t;
      if (sets.follows[at(t)]) mine |= found.reached[at(t)][at(number)];
      is_again |= mine != before;
    });
  }
  return found;
}

}  // namespace cuts
