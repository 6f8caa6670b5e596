// The terms that fine nodes and edges give the blocks of a coarse node: between nested meshes, and in a background
// grid. For coarse_terms.cpp.
#pragma once

#include <fem/solver/hierarchy/galerkin_block.h>
#include <fem/solver/hierarchy/level_graph.h>
#include <fem/solver/hierarchy/node_rows.h>

#include <array>
#include <utility>
#include <vector>

namespace physgen::fem::detail {

inline constexpr Index none = -1;  ///< no node

/// IncidenceEntry::local of a term.
inline Index code(GalerkinBlock kind, int quarters) { return static_cast<Index>(galerkin_code(kind, quarters)); }

/// An end of a fine edge, and whether it is a child of the coarse node whose terms are found.
struct EdgeEnd {
  Index node;
  bool is_child;
};

/// Nested meshes: a node has one parent, or two with a half each.
class NestedTerms {
 public:
  explicit NestedTerms(const LevelGraph& fine) : parents_(fine.parents) {}

  /// Calls act(other, code) for the terms of a child with other nodes, higher and lower ones.
  template <class Act>
  void of_node(Index coarse, Index child, const Act& act) const {
    const auto [p, q] = parents_[at(child)];
    if (p != q) act(p == coarse ? q : p, code(GalerkinBlock::node, 1));
  }
  /// The same for the terms of the edge between a and b, one of them a child or both; maybe for the node itself, too.
  template <class Act>
  void of_edge(Index coarse, EdgeEnd a, EdgeEnd b, const Act& act) const {
    const auto &of_a = parents_[at(a.node)], &of_b = parents_[at(b.node)];
    const std::size_t count_a = of_a[0] == of_a[1] ? 1 : 2, count_b = of_b[0] == of_b[1] ? 1 : 2;
    const int quarters = 4 / static_cast<int>(count_a * count_b);
    for (std::size_t i = 0; i < count_a; ++i) {
      for (std::size_t j = 0; j < count_b; ++j) {
        if (of_a[i] == coarse) act(of_b[j], code(GalerkinBlock::edge, quarters));
        if (of_b[j] == coarse) act(of_a[i], code(GalerkinBlock::reverse, quarters));
      }
    }
  }

 private:
  const std::vector<std::array<Index, 2>>& parents_;
};

/// Background grids: a node has up to four parents with any weights, which are looked up later. An edge has one term
/// with each other node, whichever of its ends hangs on which.
class GridTerms {
 public:
  explicit GridTerms(const LevelGraph& fine) : parents_(fine.grid_parents.size()) {
    for_each_index<2>(0, fine.nodes, [&](index_t n) {
      const GridLocation& location = fine.grid_parents[at(n)];
      Parents& own = parents_[at(n)];
      own.fill(none);
      for (std::size_t k = 0; k < 4; ++k) {
        if (location.weights[k] != 0 && !is_among(own, location.nodes[k])) own[k] = location.nodes[k];
      }
    });
  }

  using Parents = std::array<Index, 4>;  ///< each once; `none` where a corner has no weight

  [[nodiscard]] const Parents& parents_of(Index node) const { return parents_[at(node)]; }
  [[nodiscard]] static bool is_among(const Parents& parents, Index node) {
    bool found = false;
    for (const Index parent : parents) found |= parent == node;  // without branches
    return found;
  }
  template <class Act>
  void of_node(Index /*coarse*/, Index child, const Act& act) const {
    for (const Index other : parents_[at(child)]) act(other, code(GalerkinBlock::node, 1));
  }
  template <class Act>
  void of_edge(Index /*coarse*/, EdgeEnd a, EdgeEnd b, const Act& act) const {
    const Parents &of_a = parents_[at(a.node)], &of_b = parents_[at(b.node)];
    for (const Index other : a.is_child ? of_b : of_a) act(other, code(GalerkinBlock::edge, 1));
    if (!a.is_child || !b.is_child) return;
    for (const Index other : of_a) act(is_among(of_b, other) ? none : other, code(GalerkinBlock::edge, 1));
  }

 private:
  HostList<Parents> parents_;
};

/// How many terms a node has with each coarse one. A thread that counts for many has one of these.
class TermCounts {
 public:
  explicit TermCounts(Index coarse_nodes) : counts_(at(coarse_nodes) + 1) {}

  /// Of what is `none`, too, so that nothing is asked of each term. @param count may be negative
  void add(Index other, Index count = 1) {
    Index& sum = counts_[at(index_t{other} + 1)];
    if (sum == 0) found_.push_back(other);
    sum += count;
  }
  /// Calls act(other, count) for nodes higher than this one, ascending; then all are 0.
  template <class Act>
  void take_higher(Index node, const Act& act) {
    sort_row(found_.data(), found_.data() + found_.size());
    for (const Index other : found_) {
      const Index count = std::exchange(counts_[at(index_t{other} + 1)], 0);
      if (other > node && count != 0) act(other, count);
    }
    found_.clear();
  }

 private:
  std::vector<Index> counts_, found_;
};

/// The counts of a grid's terms without a visit of each: what the edges of a fine node count is alike for all its
/// parents, but for edges both of whose ends have two parents of a pair, which count once and not twice.
class GridCounts {
 public:
  GridCounts(const LevelGraph& fine, const GridTerms& terms, Index coarse_nodes);

  /// Adds the terms of a child with all coarse nodes.
  void add(Index coarse, Index child, TermCounts& counts) const;

 private:
  struct Others {
    Index other, count;
  };
  static constexpr std::array<std::array<std::size_t, 4>, 4> pair_of{
      {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}}};  // of two parents

  const GridTerms& terms_;
  HostList<Index> first_;
  HostList<Others> others_;                  // per fine node: the parents of its neighbours
  HostList<std::array<Index, 6>> of_pairs_;  // per fine node and pair of its parents: what is added for both
};

}  // namespace physgen::fem::detail
