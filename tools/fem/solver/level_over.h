// A level of the preconditioner over groups of arrays by name: see over_groups.h.
#pragma once

#include <fem/kernels/edge_slices.h>
#include <fem/kernels/symmetric_product.h>
#include <fem/solver/inertia.h>
#include <fem/solver/over_groups.h>
#include <fem/solver/rigid_planes.h>

#include <utility>
#include <vector>

namespace physgen::fem {

template <class Group>
struct PlanesOver : Group {
  double per_area = 0;  ///< stiffness [Pa/m]

  explicit PlanesOver(Group&& arrays) : Group(std::move(arrays)) {}
  /// For kernels. @pre equilibrium is solved on the level
  [[nodiscard]] auto at(const AtLoad& load) const {
    return RigidPlanes{per_area, load, this->planes.const_view(), this->areas.const_view()};
  }
};

template <class Group>
struct InertiaOver : Group {
  double per_mass = 0;  ///< c / m [1/s^2]; 0: no inertia

  explicit InertiaOver(Group&& arrays) : Group(std::move(arrays)) {}
  /// For kernels. @pre equilibrium is solved on the level
  [[nodiscard]] auto at_step() const {
    return Inertia{per_mass, this->masses.const_view(), this->centres.const_view()};
  }
};

template <class Group>
struct SchwarzOver : Group {
  std::vector<Index> first_block, first_pair;  ///< as SchwarzHierarchy's
  RowsOf<decltype(Group::supernode_term_ranges), decltype(Group::supernode_term_entries)> supernode_terms{
      this->supernode_term_ranges, this->supernode_term_entries};
  RowsOf<decltype(Group::pair_term_ranges), decltype(Group::pair_term_entries)> pair_terms{this->pair_term_ranges,
                                                                                           this->pair_term_entries};
  RowsOf<decltype(Group::block_edge_ranges), decltype(Group::block_edge_entries)> block_edges{this->block_edge_ranges,
                                                                                              this->block_edge_entries};

  explicit SchwarzOver(Group&& arrays) : Group(std::move(arrays)) {}
  /// Blocks of nodes; those behind them are of supernodes.
  [[nodiscard]] index_t node_blocks() const { return first_block[1]; }
  [[nodiscard]] index_t block_count() const { return first_block.back(); }
};

/// @tparam Stored_ StoredAsComputed or StoredInHalf
/// @tparam Choices_ what is asked for at run time: AnyChoice, or a struct of its names
template <class Real_, class Space_, class Stored_, class Choices_, class Group, class Schwarz, class Planes,
          class Inertia>
struct LevelOver : Group {
  using Real = Real_;
  using Space = Space_;
  using Stored = Stored_;
  using Choices = Choices_;

  bool assembled = true;  ///< else there are no edges
  bool is_grid = false;   ///< a level of a background grid
  EdgeSums sums;
  EdgeSlices slices;  ///< on CUDA, of few nodes
  Optional<Schwarz> schwarz;
  Optional<Planes> planes;    ///< where the body may touch some
  Optional<Inertia> inertia;  ///< where it moves
  RowsOf<decltype(Group::node_edge_ranges), decltype(Group::node_edge_entries)> node_edges{this->node_edge_ranges,
                                                                                           this->node_edge_entries};
  RowsOf<decltype(Group::child_ranges), decltype(Group::child_entries)> children{this->child_ranges,
                                                                                 this->child_entries};
  RowsOf<decltype(Group::edge_term_ranges), decltype(Group::edge_term_entries)> edge_terms{this->edge_term_ranges,
                                                                                           this->edge_term_entries};

  explicit LevelOver(Group&& arrays) : Group(std::move(arrays)) {}

  [[nodiscard]] index_t nodes() const { return this->constraints.size(); }
  [[nodiscard]] index_t edge_count() const { return this->edge_stiffness.size(); }
};

}  // namespace physgen::fem
