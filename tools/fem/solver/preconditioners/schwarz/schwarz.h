// The multilevel additive Schwarz preconditioner (schwarz_hierarchy.h): the sum over levels of P (block diagonal of
// P^T A P)^-1 P^T, A = -K over free components, P the nodes of supernodes. A program over an executor; what blocks do
// is in schwarz_host.h and schwarz_cuda.h.
#pragma once

#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/free_part.h>
#include <fem/solver/performs_in.h>
#include <fem/solver/preconditioners/schwarz/schwarz_arrays.h>
#include <physgen/kernel.h>

#include <cmath>
#include <limits>
#include <vector>

namespace physgen::fem {

/// The stiffness of nodes and edges, over free components.
template <class NodeStiffnessView, class EdgeStiffnessView, class EdgeView, class ConstraintView>
struct StiffnessOfNodes {
  using Scalar = typename EdgeStiffnessView::Precision;
  NodeStiffnessView nodes;     ///< elasticity::NodeStiffness, without prescribed components
  EdgeStiffnessView blocks;    ///< elasticity::EdgeStiffness
  EdgeView edges;              ///< elasticity::Edge
  ConstraintView constraints;  ///< quasistatic::NodeConstraint

  PHYSGEN_FUNCTION Matrix3<Scalar> node(index_t n) const { return nodes[n].K(); }
  PHYSGEN_FUNCTION Vector3<Scalar> magnitude(index_t n) const {
    const Matrix3<Scalar> K = nodes[n].K();
    return {math::abs(K(0, 0)), math::abs(K(1, 1)), math::abs(K(2, 2))};
  }
  PHYSGEN_FUNCTION Matrix3<Scalar> edge(index_t e) const {
    const auto ends = edges[e].nodes();
    const index_t m = ends[0], n = ends[1];
    const int of_m = constraints[m].fixed(), of_n = constraints[n].fixed();
    const Matrix3<Scalar> E = blocks[e].E();
    return (of_m | of_n) == 0 ? E : detail::free_block<Scalar>(E, of_m, of_n);
  }
};

/// The stiffness of supernodes and of pairs of them.
template <class SupernodeView, class EdgeStiffnessView>
struct StiffnessOfSupernodes {
  using Scalar = typename EdgeStiffnessView::Precision;
  SupernodeView supernodes;  ///< quasistatic::Supernode
  EdgeStiffnessView blocks;  ///< elasticity::EdgeStiffness

  PHYSGEN_FUNCTION Matrix3<Scalar> node(index_t n) const { return supernodes[n].K(); }
  PHYSGEN_FUNCTION Vector3<Scalar> magnitude(index_t n) const { return supernodes[n].magnitude(); }
  PHYSGEN_FUNCTION Matrix3<Scalar> edge(index_t e) const { return blocks[e].E(); }
};

/// A supernode's stiffness from the level before, in a fixed order.
template <class Terms, class Stiffness, class SupernodeView>
struct SumSupernodes {
  using Scalar = typename Stiffness::Scalar;
  index_t first;             ///< supernode of the level
  Terms terms;               ///< Rows of quasistatic::SchwarzTerm
  Stiffness stiffness;       ///< of the level before
  SupernodeView supernodes;  ///< quasistatic::Supernode, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto i) const {
    Matrix3<Scalar> K = Matrix3<Scalar>::Zero();
    Vector3<Scalar> magnitude = Vector3<Scalar>::Zero();
    terms.for_each(object_of_part(first, i), [&](const auto& term, bool /*active*/) {
      const index_t source = term.source();
      const int kind = term.kind();
      if (kind == 0) {
        K += stiffness.node(source);
        magnitude += stiffness.magnitude(source);
      } else {
        const Matrix3<Scalar> E = stiffness.edge(source);
        for (int c = 0; c < 3; ++c) {
          for (int r = 0; r < 3; ++r) K(r, c) += E(r, c) + E(c, r);
        }
      }
    });
    supernodes[object_of_part(first, i)].K() = K;
    supernodes[object_of_part(first, i)].magnitude() = magnitude;
  }
};

/// The stiffness between two supernodes from the level before, in a fixed order.
template <class Terms, class Stiffness, class EdgeStiffnessView>
struct SumPairs {
  using Scalar = typename Stiffness::Scalar;
  index_t first;            ///< pair of the level
  Terms terms;              ///< Rows of quasistatic::SchwarzTerm
  Stiffness stiffness;      ///< of the level before
  EdgeStiffnessView pairs;  ///< elasticity::EdgeStiffness, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto i) const {
    Matrix3<Scalar> sum = Matrix3<Scalar>::Zero();
    terms.for_each(object_of_part(first, i), [&](const auto& term, bool /*active*/) {
      const Matrix3<Scalar> E = stiffness.edge(term.source());
      const int kind = term.kind();
      for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) sum(r, c) += kind == 0 ? E(r, c) : E(c, r);
      }
    });
    pairs[object_of_part(first, i)].E() = sum;
  }
};

namespace detail {

/// Rows and columns of a block.
inline constexpr int schwarz_size = 3 * schwarz_slots;

/// The least pivot of a component, from the sum of its nodes' |K_kk|: rounding leaves as much of a sum that
/// vanishes. Below 0 for a component that is prescribed, or has no stiffness.
template <class S>
PHYSGEN_FUNCTION inline S least_pivot(S magnitude) {
  return magnitude > S(0) ? S(16) * std::numeric_limits<S>::epsilon() * magnitude : S(-1);
}

/// A power of two that brings the largest 1 / sqrt(pivot) of a block into [16, 32), so that factors fit formats of 16
/// bits, with their rows' largest entries above that.
template <class S>
PHYSGEN_FUNCTION inline S factor_scale(S largest_root) {
  if (!(largest_root > S(0)) || !(largest_root < std::numeric_limits<S>::infinity())) return S(1);
  return std::ldexp(S(1), std::ilogb(largest_root) - 4);
}

/// Object d, i of a block's factor: W = diag(roots / scale) L^-1, of the unit lower triangular L.
/// @param at (row, column) of L^-1 below its diagonal
template <class S, class At>
PHYSGEN_FUNCTION inline Matrix3<S> factor_block(int d, int i, const S* roots, S scale, const At& at) {
  Matrix3<S> W = Matrix3<S>::Zero();
  const int other = (i + d) % schwarz_slots;
  const int row = 3 * (i < other ? other : i), column = 3 * (i < other ? i : other);
  if (2 * d == schwarz_slots && i >= d) return W;  // held by the other one of the two
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) {
      if (row + r < column + c) continue;
      W(r, c) = (row + r == column + c ? S(1) : at(row + r, column + c)) * (roots[row + r] / scale);
    }
  }
  return W;
}

}  // namespace detail

/// z += the corrections of all supernodes that a node belongs to; z = 0 where nothing is free.
template <class NodeView, class SlotView, class ConstraintView, class FromView, class CorrectionView>
struct AddSupernodes {
  using Scalar = typename CorrectionView::Precision;
  index_t first_slot;          ///< of supernodes
  NodeView nodes;              ///< quasistatic::SchwarzNode
  SlotView slots;              ///< quasistatic::SchwarzSlot
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  FromView supernodes;         ///< elasticity::NodeDisplacement, of supernodes
  CorrectionView corrections;  ///< elasticity::NodeDisplacement: z

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    Vector3<Scalar> z = Vector3<Scalar>::Zero();
    const index_t slot = nodes[node].slot();
    if (slot >= 0) {
      z = corrections[node].dx();
      for (index_t s = slots[slot].parent(); s >= 0; s = slots[first_slot + s].parent()) {
        const Vector3<Scalar> more = supernodes[s].dx();
        z += more;
      }
      z = detail::free_part<Scalar>(z, constraints[node]);
    }
    corrections[node].dx() = z;
  }
};

/// The arrays that applying the blocks reads and writes.
template <class SlotView, class BlockView, class FactorView, class ResidualView, class CorrectionView,
          class SupernodeResidualView, class SupernodeCorrectionView>
struct SchwarzProduct {
  using Scalar = typename CorrectionView::Precision;
  index_t node_blocks;                            ///< those behind them are of supernodes
  SlotView slots;                                 ///< quasistatic::SchwarzSlot
  BlockView blocks;                               ///< quasistatic::SchwarzBlock
  FactorView factors;                             ///< quasistatic::SchwarzFactor
  ResidualView residual;                          ///< elasticity::NodeForceDifferential: r
  CorrectionView corrections;                     ///< elasticity::NodeDisplacement: z of nodes' blocks, written
  SupernodeResidualView supernode_residual;       ///< elasticity::NodeForceDifferential, written
  SupernodeCorrectionView supernode_corrections;  ///< elasticity::NodeDisplacement, written
};

/// Stiffness of supernodes, and the factors of all blocks. @pre the level's stiffness is given, and scaled_nodes is it
/// without prescribed components
template <class On, class Level>
void prepare_schwarz(On& on, Level& level) {
  where(level.extra, [&](auto& s) {
    const StiffnessOfNodes of_nodes{level.scaled_nodes.const_view(), level.edge_stiffness.const_view(),
                                    level.edges.const_view(), level.constraints.const_view()};
    const StiffnessOfSupernodes of_supernodes{s.supernodes.const_view(), s.pair_stiffness.const_view()};
    const auto sum = [&](std::size_t l, const auto& stiffness) {
      const index_t first = schwarz_slots * (index_t{s.first_block[l]} - s.node_blocks());
      on.run(schwarz_slots * index_t{s.first_block[l + 1] - s.first_block[l]},
             SumSupernodes{first, s.supernode_terms.const_view(), stiffness, s.supernodes.view()});
      on.run(s.first_pair[l] - s.first_pair[l - 1],
             SumPairs{index_t{s.first_pair[l - 1]}, s.pair_terms.const_view(), stiffness, s.pair_stiffness.view()});
    };
    factor_blocks(on, 0, s.node_blocks(), of_nodes, s);
    for (std::size_t l = 1; l + 1 < s.first_block.size(); ++l) {
      if (l == 1) {
        sum(l, of_nodes);
      } else {
        sum(l, of_supernodes);
      }
    }
    factor_blocks(on, s.node_blocks(), s.block_count(), of_supernodes, s);
  });
}

/// Counts what applying the blocks moves.
template <OnlyCounts On, class... Views>
void apply_blocks(On& on, const SchwarzProduct<Views...>& product, const std::vector<Index>& /*first_block*/) {
  on.count(product);
}

/// z = M r of a level.
template <class On, class Level>
void apply_schwarz(On& on, Level& level) {
  where(level.extra, [&](auto& s) {
    apply_blocks(
        on,
        SchwarzProduct{s.node_blocks(), s.slots.const_view(), s.blocks.view(), s.factors.const_view(),
                       level.residual.const_view(), level.correction.view(), s.residual.view(), s.correction.view()},
        s.first_block);
    on.run(level.nodes(),
           AddSupernodes{schwarz_slots * s.node_blocks(), s.nodes.const_view(), s.slots.const_view(),
                         level.constraints.const_view(), s.correction.const_view(), level.correction.view()});
  });
}

}  // namespace physgen::fem
