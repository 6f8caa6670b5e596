// The arrays of the multilevel Schwarz preconditioner of one level, by name.
#pragma once

#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/arrays/solver_arrays.h>
#include <fem/solver/preconditioners/schwarz/schwarz_hierarchy.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace physgen::fem {

/// Objects that a block's factor takes: see quasistatic::SchwarzFactor.
inline constexpr index_t schwarz_factors = 17 * schwarz_slots;

/// What the host knows of the blocks of a mesh.
struct SchwarzFacts {
  std::vector<Index> first_block, first_pair;  ///< as SchwarzHierarchy's
};

/// @tparam Group with the arrays of Schwarz in schwarz_group.h
template <class Group>
struct SchwarzOver : Group, SchwarzFacts {
  RowsOf<decltype(Group::supernode_term_ranges), decltype(Group::supernode_term_entries)> supernode_terms{
      this->supernode_term_ranges, this->supernode_term_entries};
  RowsOf<decltype(Group::pair_term_ranges), decltype(Group::pair_term_entries)> pair_terms{this->pair_term_ranges,
                                                                                           this->pair_term_entries};
  RowsOf<decltype(Group::block_edge_ranges), decltype(Group::block_edge_entries)> block_edges{this->block_edge_ranges,
                                                                                              this->block_edge_entries};

  explicit SchwarzOver(Group&& arrays) : Group(std::move(arrays)) {}
  /// @param edges of the mesh
  SchwarzOver(const SchwarzHierarchy& hierarchy, index_t edges)
      : SchwarzFacts{hierarchy.first_block, hierarchy.first_pair} {
    const auto of_supernodes = rows<Terms>("source", hierarchy, edges, hierarchy.supernode_terms);
    const auto of_pairs = rows<Terms>("source", hierarchy, edges, hierarchy.pair_terms);
    const auto of_blocks = rows<Edges>("edge", hierarchy, edges, hierarchy.block_edges);
    this->allocate({.node = index_t(hierarchy.node_slots.size()),
                    .slot = index_t(hierarchy.slots.size()),
                    .block = index_t(hierarchy.blocks.size()),
                    .supernode = hierarchy.supernodes(),
                    .supernode_term = of_supernodes.entries().size(),
                    .pair = hierarchy.pairs(),
                    .pair_term = of_pairs.entries().size(),
                    .block_edge = of_blocks.entries().size(),
                    .factor = schwarz_factors * hierarchy.block_count()});
    put(this->nodes, host_nodes(hierarchy));
    put(this->slots, host_slots(hierarchy));
    put(this->blocks, host_blocks(hierarchy));
    put(this->supernode_term_ranges, of_supernodes.ranges());
    put(this->supernode_term_entries, of_supernodes.entries());
    put(this->pair_term_ranges, of_pairs.ranges());
    put(this->pair_term_entries, of_pairs.entries());
    put(this->block_edge_ranges, of_blocks.ranges());
    put(this->block_edge_entries, of_blocks.entries());
  }

  /// Blocks of nodes; those behind them are of supernodes.
  [[nodiscard]] index_t node_blocks() const { return first_block[1]; }
  [[nodiscard]] index_t block_count() const { return first_block.back(); }

 private:
  using Terms = RowArrays<elasticity::IncidenceRangeArray<float>, quasistatic::SchwarzTermArray<float>>;
  using Edges = RowArrays<elasticity::IncidenceRangeArray<float>, quasistatic::SchwarzPairArray<float>>;
  static auto host_nodes(const SchwarzHierarchy& hierarchy) {
    quasistatic::SchwarzNodeArray<typename Group::Real> array(index_t(hierarchy.node_slots.size()));
    for (index_t n = 0; n < array.size(); ++n) array.view()[n].slot() = hierarchy.node_slots[std::size_t(n)];
    return array;
  }
  static auto host_slots(const SchwarzHierarchy& hierarchy) {
    quasistatic::SchwarzSlotArray<typename Group::Real> array(index_t(hierarchy.slots.size()));
    for (index_t s = 0; s < array.size(); ++s) {
      array.view()[s].source() = hierarchy.slots[std::size_t(s)][0];
      array.view()[s].parent() = hierarchy.slots[std::size_t(s)][1];
    }
    return array;
  }
  static auto host_blocks(const SchwarzHierarchy& hierarchy) {
    quasistatic::SchwarzBlockArray<typename Group::Real> array(index_t(hierarchy.blocks.size()));
    for (index_t b = 0; b < array.size(); ++b) {
      array.view()[b].parent() = hierarchy.blocks[std::size_t(b)][0];
      array.view()[b].children() = hierarchy.blocks[std::size_t(b)][1];
    }
    return array;
  }
  /// Entries name nodes and edges of the mesh, and supernodes and pairs of them.
  template <class Rows>
  static Rows rows(const char* field, const SchwarzHierarchy& hierarchy, index_t edges, const SchwarzList& list) {
    std::vector<typename Rows::Value> entries;
    entries.reserve(list.entries.size());
    for (const auto& [first, second] : list.entries) entries.push_back({first, second});
    const index_t targets = std::max(
        {index_t(hierarchy.node_slots.size()), edges, index_t{hierarchy.supernodes()}, index_t{hierarchy.pairs()}});
    return Rows::from_offsets({field, targets}, list.first, entries);
  }
};

}  // namespace physgen::fem
