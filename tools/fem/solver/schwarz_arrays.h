// The arrays of the multilevel Schwarz preconditioner of one level, by name.
#pragma once

#include <fem/solver/schwarz_hierarchy.h>
#include <fem/solver/solver_arrays.h>

#include <algorithm>
#include <vector>

namespace physgen::fem {

/// Objects that a block's factor takes: see quasistatic::SchwarzFactor.
inline constexpr index_t schwarz_factors = 17 * schwarz_slots;

/// @tparam Real of the stiffness
/// @tparam FactorFormats how factors are stored
template <class Real_, class Space_, class FactorFormats>
struct SchwarzArrays {
  using Real = Real_;
  using Space = Space_;
  template <class S>
  using Terms = RowArrays<elasticity::IncidenceRangeArray<float, S>, quasistatic::SchwarzTermArray<float, S>>;
  template <class S>
  using Edges = RowArrays<elasticity::IncidenceRangeArray<float, S>, quasistatic::SchwarzPairArray<float, S>>;

  std::vector<Index> first_block, first_pair;  ///< as SchwarzHierarchy's
  quasistatic::SchwarzNodeArray<Real, Space> nodes;
  quasistatic::SchwarzSlotArray<Real, Space> slots;
  quasistatic::SchwarzBlockArray<Real, Space> blocks;
  Terms<Space> supernode_terms, pair_terms;
  Edges<Space> block_edges;

  // Supernodes of all levels but the first.
  quasistatic::SupernodeArray<Real, Space> supernodes;
  /// On CUDA as records, since they are gathered.
  elasticity::EdgeStiffnessArray<Real, Space,
                                 PerSpace<Space, LayoutOf<elasticity::EdgeStiffnessArray<Real, Host>>, Aos>>
      pair_stiffness;
  elasticity::NodeForceDifferentialArray<Real, Space> residual;  ///< r, summed over the nodes of each supernode
  elasticity::NodeDisplacementArray<Real, Space> correction;     ///< z

  quasistatic::SchwarzFactorArray<Real, Space, LayoutOf<quasistatic::SchwarzFactorArray<Real, Space>>, FactorFormats>
      factors;

  /// @param edges of the mesh
  SchwarzArrays(const SchwarzHierarchy& hierarchy, index_t edges)
      : first_block(hierarchy.first_block),
        first_pair(hierarchy.first_pair),
        nodes(moved_to<decltype(nodes)>(host_nodes(hierarchy))),
        slots(moved_to<decltype(slots)>(host_slots(hierarchy))),
        blocks(moved_to<decltype(blocks)>(host_blocks(hierarchy))),
        supernode_terms(rows<Terms<Space>, Terms<Host>>("source", hierarchy, edges, hierarchy.supernode_terms)),
        pair_terms(rows<Terms<Space>, Terms<Host>>("source", hierarchy, edges, hierarchy.pair_terms)),
        block_edges(rows<Edges<Space>, Edges<Host>>("edge", hierarchy, edges, hierarchy.block_edges)),
        supernodes(hierarchy.supernodes()),
        pair_stiffness(hierarchy.pairs()),
        residual(hierarchy.supernodes()),
        correction(hierarchy.supernodes()),
        factors(schwarz_factors * hierarchy.block_count()) {}

  /// Blocks of nodes; those behind them are of supernodes.
  [[nodiscard]] index_t node_blocks() const { return first_block[1]; }
  [[nodiscard]] index_t block_count() const { return first_block.back(); }
  [[nodiscard]] index_t bytes() const {
    return bytes_of(nodes, slots, blocks, supernode_terms.ranges(), supernode_terms.entries(), pair_terms.ranges(),
                    pair_terms.entries(), block_edges.ranges(), block_edges.entries(), supernodes, pair_stiffness,
                    residual, correction, factors);
  }

 private:
  static auto host_nodes(const SchwarzHierarchy& hierarchy) {
    quasistatic::SchwarzNodeArray<Real> array(index_t(hierarchy.node_slots.size()));
    for (index_t n = 0; n < array.size(); ++n) array.view()[n].slot() = hierarchy.node_slots[std::size_t(n)];
    return array;
  }
  static auto host_slots(const SchwarzHierarchy& hierarchy) {
    quasistatic::SchwarzSlotArray<Real> array(index_t(hierarchy.slots.size()));
    for (index_t s = 0; s < array.size(); ++s) {
      array.view()[s].source() = hierarchy.slots[std::size_t(s)][0];
      array.view()[s].parent() = hierarchy.slots[std::size_t(s)][1];
    }
    return array;
  }
  static auto host_blocks(const SchwarzHierarchy& hierarchy) {
    quasistatic::SchwarzBlockArray<Real> array(index_t(hierarchy.blocks.size()));
    for (index_t b = 0; b < array.size(); ++b) {
      array.view()[b].parent() = hierarchy.blocks[std::size_t(b)][0];
      array.view()[b].children() = hierarchy.blocks[std::size_t(b)][1];
    }
    return array;
  }
  /// Entries name nodes and edges of the mesh, and supernodes and pairs of them.
  template <class Arrays, class OnHost>
  static Arrays rows(const char* field, const SchwarzHierarchy& hierarchy, index_t edges, const SchwarzList& list) {
    std::vector<typename OnHost::Value> entries;
    entries.reserve(list.entries.size());
    for (const auto& [first, second] : list.entries) entries.push_back({first, second});
    const index_t targets = std::max(
        {index_t(hierarchy.node_slots.size()), edges, index_t{hierarchy.supernodes()}, index_t{hierarchy.pairs()}});
    return Arrays(OnHost::from_offsets({field, targets}, list.first, entries));
  }
};

}  // namespace physgen::fem
