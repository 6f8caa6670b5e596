// Coarse node by coarse node: what connects it with higher ones is found among the edges of its children.
#include <fem/mesh/stages.h>
#include <fem/solver/hierarchy/coarse_terms.h>
#include <fem/solver/hierarchy/galerkin_block.h>
#include <fem/solver/hierarchy/node_rows.h>

namespace physgen::fem::detail {

namespace {

Index code(GalerkinBlock kind, int quarters) { return static_cast<Index>(galerkin_code(kind, quarters)); }

// A term of a block between a coarse node and a higher one.
struct Term {
  Index other;       // the higher node
  Index element;     // fine node or edge
  Index local;       // galerkin_code()
  bool is_edge;      // else of a fine node
  std::size_t turn;  // in which it comes among those of its element
};

// Each term of a coarse node with higher ones. Nested meshes: a node has one parent, or two with a half each.
class NestedTerms {
 public:
  explicit NestedTerms(const LevelGraph& fine) : fine_(fine) {}

  // Calls act(Term) for those of one child; node `coarse` is among its parents.
  template <class Act>
  void operator()(Index coarse, Index child, const Act& act) const {
    const auto& own = fine_.parents[at(child)];
    const bool has_one = own[0] == own[1];
    const std::size_t own_turn = own[0] == coarse ? 0 : 1;
    if (!has_one) {
      const Index other = own[1 - own_turn];
      if (other > coarse) act(Term{other, child, code(GalerkinBlock::node, 1), false, 0});
    }
    for (Index k = fine_.node_edges.first[at(child)]; k < fine_.node_edges.first[at(child) + 1]; ++k) {
      const auto [edge, side] = fine_.node_edges.entries[at(k)];
      const auto& others = fine_.parents[at(fine_.edges[at(edge)][at(1 - side)])];
      const std::size_t count = others[0] == others[1] ? 1 : 2;
      const int quarters = (has_one ? 4 : 2) / static_cast<int>(count);
      for (std::size_t j = 0; j < count; ++j) {
        if (others[j] <= coarse) continue;
        const std::size_t turn = side == 0 ? 2 * own_turn + j : 2 * j + own_turn;
        act(Term{others[j], edge, code(side == 0 ? GalerkinBlock::edge : GalerkinBlock::reverse, quarters), true,
                 turn});
      }
    }
  }

 private:
  const LevelGraph& fine_;
};

// Background grids: a node has up to four parents with any weights, which are looked up later.
class GridTerms {
 public:
  explicit GridTerms(const LevelGraph& fine) : fine_(fine) {}

  template <class Act>
  void operator()(Index coarse, Index child, const Act& act) const {
    const GridLocation& own = fine_.grid_parents[at(child)];
    for (std::size_t j = 0; j < 4; ++j) {
      if (is_higher(own, j, coarse)) act(Term{own.nodes[j], child, code(GalerkinBlock::node, 1), false, 0});
    }
    for (Index k = fine_.node_edges.first[at(child)]; k < fine_.node_edges.first[at(child) + 1]; ++k) {
      const auto [edge, side] = fine_.node_edges.entries[at(k)];
      const GridLocation& others = fine_.grid_parents[at(fine_.edges[at(edge)][at(1 - side)])];
      const bool seen_from_other = side == 1 && has(others, coarse);
      for (std::size_t j = 0; j < 4; ++j) {
        if (!is_higher(others, j, coarse) || (seen_from_other && has(own, others.nodes[j]))) continue;
        act(Term{others.nodes[j], edge, code(GalerkinBlock::edge, 1), true, 0});
      }
    }
  }

 private:
  static bool has(const GridLocation& location, Index node) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (location.nodes[k] == node && location.weights[k] != 0) return true;
    }
    return false;
  }
  // Of a node that several corners name, the first of them with a weight counts.
  static bool is_higher(const GridLocation& location, std::size_t j, Index coarse) {
    if (location.nodes[j] <= coarse || location.weights[j] == 0) return false;
    for (std::size_t k = 0; k < j; ++k) {
      if (location.nodes[k] == location.nodes[j] && location.weights[k] != 0) return false;
    }
    return true;
  }

  const LevelGraph& fine_;
};

template <class Act>
void with_terms(const LevelGraph& fine, const Act& act) {
  if (fine.grid_parents.empty()) {
    act(NestedTerms(fine));
  } else {
    act(GridTerms(fine));
  }
}

// Calls act(Term) for all terms of a coarse node. A child that names it twice is there once.
template <class Terms, class Act>
void each_term(const LevelGraph& fine, const Terms& terms, Index coarse, const Act& act) {
  Index last = -1;
  for (Index k = fine.children.first[at(coarse)]; k < fine.children.first[at(coarse) + 1]; ++k) {
    const Index child = fine.children.entries[at(k)].element;
    if (child != last) terms(coarse, child, act);
    last = child;
  }
}

// The terms of one coarse node, in the order of its higher ones. Sorted, numbers are those of IncidenceEntry.
struct TermsOfNode {
  HigherNodes others;
  std::vector<std::uint64_t> terms;

  static constexpr int element_from = 8, turn_from = 4, is_edge_at = 40;
  static std::uint64_t packed(const Term& term) {
    return std::uint64_t{term.is_edge} << is_edge_at | std::uint64_t(std::uint32_t(term.element)) << element_from |
           std::uint64_t{term.turn} << turn_from | std::uint64_t(std::uint32_t(term.local));
  }
  static IncidenceEntry unpacked(std::uint64_t term) {
    return {static_cast<Index>(term >> element_from & 0x7FFFFFFF), static_cast<Index>(term & 0xF)};
  }
};

}  // namespace

CoarsePairs coarse_pairs(const LevelGraph& fine, Index coarse_nodes) {
  InStage stage("coarse pairs");
  CoarsePairs found;
  with_terms(fine, [&](const auto& terms) {
    append_rows(
        Host{}, coarse_nodes, [=] { return HigherNodes(coarse_nodes); },
        [&](index_t coarse, HigherNodes& others, std::vector<CoarsePairs::Pair>& row) {
          const auto node = static_cast<Index>(coarse);
          others.begin(node);
          each_term(fine, terms, node, [&](const Term& term) { ++others.add(term.other); });
          for (const Index other : others.sorted()) row.push_back({other, others.number(other)});
        },
        found.first, found.pairs);
  });
  stage.moves(fine.edges, fine.node_edges.entries, fine.children.entries, fine.parents, fine.grid_parents, found.first,
              found.pairs);
  return found;
}

IncidenceList coarse_terms(const LevelGraph& fine, const CoarsePairs& pairs, const LevelGraph& coarse) {
  InStage stage("terms of coarse blocks");
  const HostList<Index> first = first_edges(coarse.nodes, coarse.edges);
  IncidenceList list;
  list.first.resize(coarse.edges.size() + 1);
  list.first.back() = 0;
  for_each_index<8>(0, coarse.nodes, [&](index_t node) {
    Index pair = pairs.first[at(node)];
    const Index end = pairs.first[at(node) + 1];
    for (Index e = first[at(node)]; e < first[at(node) + 1]; ++e) {
      const bool is_pair = pair < end && pairs.pairs[at(pair)].other == coarse.edges[at(e)][1];
      list.first[at(e)] = is_pair ? pairs.pairs[at(pair++)].terms : 0;
    }
  });
  list.entries.resize(at(exclusive_scan(Host{}, std::span(list.first))));
  with_terms(fine, [&](const auto& terms) {
    each_node(
        coarse.nodes, [&] { return TermsOfNode{HigherNodes(coarse.nodes), {}}; },
        [&](Index node, TermsOfNode& own) {
          const Index from = first[at(node)], to = first[at(node) + 1], begin = list.first[at(from)];
          own.terms.resize(at(list.first[at(to)] - begin));
          for (Index e = from; e < to; ++e) own.others.number(coarse.edges[at(e)][1]) = list.first[at(e)] - begin;
          each_term(fine, terms, node, [&](const Term& term) {
            own.terms[at(own.others.number(term.other)++)] = TermsOfNode::packed(term);
          });
          for (Index e = from; e < to; ++e) {
            sort_row(own.terms.data() + list.first[at(e)] - begin, own.terms.data() + list.first[at(e) + 1] - begin);
          }
          for (std::size_t k = 0; k < own.terms.size(); ++k) {
            list.entries[at(begin) + k] = TermsOfNode::unpacked(own.terms[k]);
          }
        });
  });
  stage.moves(fine.edges, fine.node_edges.entries, fine.children.entries, fine.parents, fine.grid_parents, coarse.edges,
              pairs.pairs, list.first, list.entries);
  return list;
}

}  // namespace physgen::fem::detail
