// The blocks of the multilevel Schwarz preconditioner (Wu, Wang, Wang 2022, ACM TOG 41(4) 63), as plain lists on the
// host. It needs the mesh alone: nodes along a space-filling curve in blocks of 32; what is connected within a block is
// a supernode of the next level, whose blocks take 32 supernodes each; and so on to one block.
#pragma once

#include <fem/solver/hierarchy/hierarchy.h>

#include <array>
#include <vector>

namespace physgen::fem {

/// Slots of a block.
inline constexpr Index schwarz_slots = 32;

/// For every object of one kind, entries[first[i]] up to, not including, entries[first[i + 1]].
struct SchwarzList {
  std::vector<Index> first;  ///< one more than there are objects
  std::vector<std::array<Index, 2>> entries;
};

/// Levels have whole blocks: slots that nothing stands in have the source -1. Supernodes of all levels but the first
/// are numbered together, as their slots are: supernode s stands in slot first_supernode_slot() + s.
struct SchwarzHierarchy {
  std::vector<Index> first_block;            ///< per level, and one more
  std::vector<Index> node_slots;             ///< per node; -1 where all its components are prescribed
  std::vector<std::array<Index, 2>> slots;   ///< per slot: source, parent
  std::vector<std::array<Index, 2>> blocks;  ///< per block: parent, how many blocks have it as theirs
  std::vector<Index> first_pair;             ///< of supernodes with common edges: per level from the second; one more
  SchwarzList supernode_terms;               ///< per supernode: source, kind of quasistatic::SchwarzTerm
  SchwarzList pair_terms;                    ///< per pair of supernodes: source, kind
  SchwarzList block_edges;                   ///< per block: edge or pair, places of quasistatic::SchwarzPair

  [[nodiscard]] std::size_t levels() const { return first_block.size() - 1; }
  [[nodiscard]] Index block_count() const { return first_block.back(); }
  [[nodiscard]] Index first_supernode_slot() const { return schwarz_slots * first_block[levels() > 0 ? 1 : 0]; }
  [[nodiscard]] Index supernodes() const { return schwarz_slots * block_count() - first_supernode_slot(); }
  [[nodiscard]] Index pairs() const { return first_pair.empty() ? 0 : first_pair.back(); }
};

/// @param rest position of each node
/// @pre rest.size() == graph.nodes
[[nodiscard]] SchwarzHierarchy make_schwarz_hierarchy(const LevelGraph& graph, const std::vector<Point>& rest);

}  // namespace physgen::fem
