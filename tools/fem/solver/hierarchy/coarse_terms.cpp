// Coarse node by coarse node: what connects it with higher ones is found among the edges of its children.
#include <fem/mesh/stages.h>
#include <fem/solver/hierarchy/box_levels.h>
#include <fem/solver/hierarchy/coarse_terms.h>
#include <fem/solver/hierarchy/galerkin_terms.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/hierarchy/node_rows.h>

#include <algorithm>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace physgen::fem {

namespace detail {

namespace {

template <class Act>
void with_terms(const LevelGraph& fine, const Act& act) {
  if (fine.grid_parents.empty()) {
    act(NestedTerms(fine));
  } else {
    act(GridTerms(fine));
  }
}

// A child that names the node twice is there once.
template <class Act>
void each_child(const LevelGraph& fine, Index coarse, const Act& act) {
  Index last = none;
  for (Index k = fine.children.first[at(coarse)]; k < fine.children.first[at(coarse) + 1]; ++k) {
    const Index child = fine.children.entries[at(k)].element;
    if (child != last) act(child);
    last = child;
  }
}

// The lower ends of a node's edges to lower nodes, which come first among its edges.
template <class Act>
void each_lower_end(const LevelGraph& fine, Index node, const Act& act) {
  for (Index k = fine.node_edges.first[at(node)]; k < fine.node_edges.first[at(node) + 1]; ++k) {
    const auto [edge, side] = fine.node_edges.entries[at(k)];
    if (side == 0) return;
    act(fine.edges[at(edge)][0]);
  }
}

// The lower ends of the edges of a coarse node's children. A thread that finds them for many has one of these.
class LowerEnds {
 public:
  explicit LowerEnds(Index fine_nodes) : of_(at(fine_nodes), none), child_of_(at(fine_nodes), none) {}

  // Ascending. @param coarse another one each time. @param at_child called for each child, ascending
  template <class AtChild>
  std::span<const Index> find(const LevelGraph& fine, Index coarse, const AtChild& at_child) {
    nodes_.clear();
    each_child(fine, coarse, [&](Index child) {
      at_child(child);
      child_of_[at(child)] = coarse;
      add(coarse, child);
      each_lower_end(fine, child, [&](Index node) { add(coarse, node); });
    });
    sort_row(nodes_.data(), nodes_.data() + nodes_.size());
    return nodes_;
  }
  // @pre it was the last that find() was called for
  [[nodiscard]] bool is_child(Index node, Index coarse) const { return child_of_[at(node)] == coarse; }

 private:
  void add(Index coarse, Index node) {
    if (std::exchange(of_[at(node)], coarse) != coarse) nodes_.push_back(node);
  }

  std::vector<Index> of_, child_of_, nodes_;
};

// Calls act(other, element, code) for all terms of a coarse node: those of fine nodes, and then those of fine edges,
// both ascending, each edge once. `other` is any node, or `none`.
// @param first_higher per fine node: the first of its edges to higher nodes
template <class Terms, class Act>
void each_term(const LevelGraph& fine, std::span<const Index> first_higher, const Terms& terms, Index coarse,
               LowerEnds& ends, const Act& act) {
  const auto lower = ends.find(fine, coarse, [&](Index child) {
    terms.of_node(coarse, child, [&](Index other, Index code) { act(other, child, code); });
  });
  for (const Index a : lower) {
    const bool from_a = ends.is_child(a, coarse);
    for (Index edge = first_higher[at(a)]; edge < first_higher[at(a) + 1]; ++edge) {
      const Index b = fine.edges[at(edge)][1];
      const bool from_b = ends.is_child(b, coarse);
      if (!from_a && !from_b) continue;
      terms.of_edge(coarse, {a, from_a}, {b, from_b}, [&](Index other, Index code) { act(other, edge, code); });
    }
  }
}

// The terms of one coarse node, and where the next one goes with each higher node. The first place takes what is none
// of them.
struct TermsOfNode {
  std::vector<Index> places;
  LowerEnds ends;
  std::vector<IncidenceEntry> terms;
};

// A term of the first node of a kind: that of a fine node, or of an edge by its number among those of its lower node.
struct MovableTerm {
  Index node, edge, code;
};

// Calls put(node, terms) for all coarse nodes. @param find called as find(node, scratch), for the first nodes of each
// kind; returns their terms
template <class MakeScratch, class Find, class Put>
void move_terms(const LevelGraph& fine, const AlikeNodes& nodes, std::span<const Index> first_higher,
                const MakeScratch& make_scratch, const Find& find, const Put& put) {
  HostList<Index> first;
  HostList<MovableTerm> movable;
  append_rows(
      Host{}, nodes.kinds(), make_scratch,
      [&](index_t kind, TermsOfNode& own, std::vector<MovableTerm>& row) {
        for (const auto& [element, code] : find(nodes.first(kind), own)) {
          if (galerkin_block(code) == GalerkinBlock::node) {
            row.push_back({element, none, code});
          } else {
            const Index lower = fine.edges[at(element)][0];
            row.push_back({lower, element - first_higher[at(lower)], code});
          }
        }
      },
      first, movable);
  RegionFailure failure;
  nodes.each_row([](Index /*first*/) { return std::vector<IncidenceEntry>(); },
                 [&](const AlikeNodes::Node& node, std::vector<IncidenceEntry>& moved) {
                   failure.guard([&] {
                     const Index beyond = nodes.fine_nodes_beyond(node);
                     const Index begin = first[at(node.kind)], end = first[at(node.kind) + 1];
                     moved.resize(at(end - begin));
                     for (Index k = begin; k < end; ++k) {
                       const MovableTerm& term = movable[at(k)];
                       const Index at_node = term.node + beyond;
                       moved[at(k - begin)] = {term.edge == none ? at_node : first_higher[at(at_node)] + term.edge,
                                               term.code};
                     }
                     put(node.number, std::span<const IncidenceEntry>(moved));
                   });
                 });
  failure.rethrow();
}

}  // namespace

GridCounts::GridCounts(const LevelGraph& fine, const GridTerms& terms, Index coarse_nodes)
    : terms_(terms), of_pairs_(at(fine.nodes)) {
  append_rows(
      Host{}, fine.nodes, [=] { return TermCounts(coarse_nodes); },
      [&](index_t n, TermCounts& counts, std::vector<Others>& row) {
        const auto& own = terms.parents_of(static_cast<Index>(n));
        auto& of_pairs = of_pairs_[at(n)];
        of_pairs.fill(1);  // the term of the node
        for (Index k = fine.node_edges.first[at(n)]; k < fine.node_edges.first[at(n) + 1]; ++k) {
          const auto [edge, side] = fine.node_edges.entries[at(k)];
          const auto& others = terms.parents_of(fine.edges[at(edge)][at(1 - side)]);
          for (const Index other : others) counts.add(other);
          if (side == 1) continue;
          std::array<bool, 4> has{};
          for (std::size_t i = 0; i < 4; ++i) has[i] = GridTerms::is_among(others, own[i]);
          for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = i + 1; j < 4; ++j) of_pairs[pair_of[i][j]] -= has[i] && has[j] ? 1 : 0;
          }
        }
        counts.take_higher(none, [&](Index other, Index count) { row.push_back({other, count}); });
      },
      first_, others_);
}

void GridCounts::add(Index coarse, Index child, TermCounts& counts) const {
  for (Index k = first_[at(child)]; k < first_[at(child) + 1]; ++k) {
    counts.add(others_[at(k)].other, others_[at(k)].count);
  }
  const auto& parents = terms_.parents_of(child);
  const auto own = static_cast<std::size_t>(std::ranges::find(parents, coarse) - parents.begin());
  for (std::size_t k = 0; k < 4; ++k) {
    if (k != own) counts.add(parents[k], of_pairs_[at(child)][pair_of[own][k]]);
  }
}

CoarsePairs coarse_pairs(const LevelGraph& fine, Index coarse_nodes, const std::optional<BoxCells>& box) {
  InStage stage("coarse pairs");
  CoarsePairs found;
  const auto append = [&](const auto& make_scratch, const auto& count) {
    rows_of_nodes(
        box, coarse_nodes, make_scratch,
        [&](index_t coarse, auto& own, std::vector<CoarsePairs::Pair>& row) {
          const auto node = static_cast<Index>(coarse);
          count(node, own);
          own.counts.take_higher(node, [&](Index other, Index terms) { row.push_back({other, terms}); });
        },
        [](const CoarsePairs::Pair& pair, Index beyond) { return CoarsePairs::Pair{pair.other + beyond, pair.terms}; },
        found.first, found.pairs);
  };
  struct Scratch {
    TermCounts counts;
    LowerEnds ends;
  };
  with_terms(fine, [&]<class Terms>(const Terms& terms) {
    if constexpr (std::is_same_v<Terms, GridTerms>) {
      const GridCounts counts(fine, terms, coarse_nodes);
      append([&] { return Scratch{TermCounts(coarse_nodes), LowerEnds(0)}; },
             [&](Index node, Scratch& own) {
               each_child(fine, node, [&](Index child) { counts.add(node, child, own.counts); });
             });
    } else {
      const HostList<Index> first_higher = first_edges(fine.nodes, fine.edges);
      append([&] { return Scratch{TermCounts(coarse_nodes), LowerEnds(fine.nodes)}; },
             [&](Index node, Scratch& own) {
               each_term(fine, first_higher, terms, node, own.ends,
                         [&](Index other, Index /*element*/, Index /*code*/) { own.counts.add(other); });
             });
    }
  });
  stage.moves(fine.edges, fine.node_edges.entries, fine.children.entries, fine.parents, fine.grid_parents, found.first,
              found.pairs);
  return found;
}

HostList<Index> rows_of_terms(const CoarsePairs& pairs, const LevelGraph& coarse) {
  InStage stage("terms of coarse blocks");
  const HostList<Index> first = first_edges(coarse.nodes, coarse.edges);
  HostList<Index> rows(coarse.edges.size() + 1);
  rows.back() = 0;
  for_each_index<8>(0, coarse.nodes, [&](index_t node) {
    Index pair = pairs.first[at(node)];
    const Index end = pairs.first[at(node) + 1];
    for (Index e = first[at(node)]; e < first[at(node) + 1]; ++e) {
      const bool is_pair = pair < end && pairs.pairs[at(pair)].other == coarse.edges[at(e)][1];
      rows[at(e)] = is_pair ? pairs.pairs[at(pair++)].terms : 0;
    }
  });
  (void)exclusive_scan(Host{}, std::span(rows));
  stage.moves(coarse.edges, pairs.pairs, rows);
  return rows;
}

}  // namespace detail

void each_edge_terms(const LevelGraph& fine, const LevelGraph& coarse, const PutTerms& put) {
  using namespace detail;
  InStage stage("terms of coarse blocks");
  const HostList<Index> first = first_edges(coarse.nodes, coarse.edges);
  const HostList<Index> first_higher = first_edges(fine.nodes, fine.edges);
  const HostList<Index>& rows = fine.edge_terms.first;
  const auto make_scratch = [&] {
    return TermsOfNode{std::vector<Index>(at(coarse.nodes) + 1), LowerEnds(fine.nodes), {}};
  };
  with_terms(fine, [&](const auto& terms) {
    const auto find = [&](Index node, TermsOfNode& own) {
      const Index from = first[at(node)], to = first[at(node) + 1], begin = rows[at(from)];
      own.terms.resize(at(rows[at(to)] - begin) + 1);
      for (Index e = from; e < to; ++e) {
        own.places[at(coarse.edges[at(e)][1]) + 1] = rows[at(e)] - begin + 1;
      }
      each_term(fine, first_higher, terms, node, own.ends, [&](Index other, Index element, Index code) {
        Index& place = own.places[at(index_t{other} + 1)];
        const bool is_higher = other > node;
        own.terms[at(is_higher ? place : 0)] = {element, code};
        place += is_higher ? 1 : 0;
      });
      return std::span<const IncidenceEntry>(own.terms).subspan(1);
    };
    if (fine.box && coarse.box) {
      move_terms(fine, AlikeNodes(*coarse.box, reach_of_edges), first_higher, make_scratch, find,
                 [&](Index node, std::span<const IncidenceEntry> moved) { put(rows[at(first[at(node)])], moved); });
    } else {
      each_node(coarse.nodes, make_scratch,
                [&](Index node, TermsOfNode& own) { put(rows[at(first[at(node)])], find(node, own)); });
    }
  });
  stage.moves(fine.edges, fine.node_edges.entries, fine.children.entries, fine.parents, fine.grid_parents, coarse.edges,
              rows);
}

}  // namespace physgen::fem
