// Arrays of the scene linear_elastic, with the fields that its program needs. Written by physgen from
// scenes/linear_elastic.h and the kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scene_arrays.h>

#include "scenes/linear_elastic.h"

/// Linear elasticity: an equilibrium by conjugate gradients without blocks of edges, preconditioned by the inverses of
/// nodes' blocks.
namespace scenes::linear_elastic_scene {

namespace pruned::body {
struct state {
  struct volumetric;
  struct work;
  struct smallest_ratio;
};
}  // namespace pruned::body

/// How quasistatic::Equilibrium is stored in body.state. Not stored:
/// - volumetric, work, smallest_ratio: nothing uses it
template <class Space>
struct BodyStateFormats : physgen::FormatsOf<::quasistatic::EquilibriumObject, Space> {
  using volumetric = physgen::format::Pruned<linear_elastic, pruned::body::state, pruned::body::state::volumetric>;
  using work = physgen::format::Pruned<linear_elastic, pruned::body::state, pruned::body::state::work>;
  using smallest_ratio = physgen::format::Pruned<linear_elastic, pruned::body::state,
      pruned::body::state::smallest_ratio>;
};

template <class Space_ = physgen::Host>
struct Body {
  using Space = Space_;
  using Real = float;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t tet = 0;
    physgen::index_t node = 0;
    physgen::index_t corner = 0;
  };

  /// elasticity::Tet, per tet: nodes
  physgen::ReadOnlyArray<::elasticity::TetArray<float, Space>> tets;
  /// elasticity::RestShape, per tet: dm_inverse, volume
  physgen::ReadOnlyArray<::elasticity::RestShapeArray<double, Space>> rest;
  /// The tets of each node: rows of a tet and a corner in one number.
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> node_tet_ranges;
  /// quasistatic::PackedIncidence, per corner: code
  physgen::ReadOnlyArray<::quasistatic::PackedIncidenceArray<float, Space>> node_tets;
  /// External forces, and the motion of prescribed components, at a load of 1.
  /// elasticity::NodeForce, per node: f
  physgen::ReadOnlyArray<::elasticity::NodeForceArray<double, Space>> loads;
  /// elasticity::NodeDisplacement, per node: dx
  physgen::ReadOnlyArray<::elasticity::NodeDisplacementArray<double, Space>> motion;
  /// From rest.
  /// elasticity::NodeDisplacement, per node: dx
  ::elasticity::NodeDisplacementArray<double, Space> displacements;
  /// elasticity::NodeForce, per node: f
  ::elasticity::NodeForceArray<double, Space> forces;
  /// Before the solve.
  /// quasistatic::Equilibrium, 1 object: elastic, loads, free_square, fixed_square; without volumetric, work,
  /// smallest_ratio
  physgen::WithFormats<::quasistatic::EquilibriumArray<double, Space>, BodyStateFormats<Space>> state;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(tets, counts.tet);
    physgen::allocate(rest, counts.tet);
    physgen::allocate(node_tet_ranges, counts.node);
    physgen::allocate(node_tets, counts.corner);
    physgen::allocate(loads, counts.node);
    physgen::allocate(motion, counts.node);
    physgen::allocate(displacements, counts.node, {"dx"});
    physgen::allocate(forces, counts.node, {"f"});
    physgen::allocate(state, 1, {"elastic", "loads", "free_square", "fixed_square"});
  }

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return tets.bytes(
        ) + rest.bytes() + node_tet_ranges.bytes() + node_tets.bytes() + loads.bytes() + motion.bytes() +
            displacements.bytes() + forces.bytes() + state.bytes();
  }
};

namespace pruned::level {
struct scales {
  struct inverse;
};
}  // namespace pruned::level

/// How quasistatic::NodeScale is stored in level.scales. Not stored:
/// - inverse: written by physgen::fem::ComputeNodeScale(level.node_stiffness, level.scales); nothing reads it
template <class Space>
struct LevelScalesFormats : physgen::FormatsOf<::quasistatic::NodeScaleObject, Space> {
  using inverse = physgen::format::Pruned<linear_elastic, pruned::level::scales, pruned::level::scales::inverse>;
};

/// The preconditioner, in unknowns scaled to a unit diagonal.
template <class Space_ = physgen::Host>
struct Level {
  using Space = Space_;
  using Real = float;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
  };

  /// quasistatic::NodeConstraint, per node: fixed
  physgen::ReadOnlyArray<::quasistatic::NodeConstraintArray<float, Space>> constraints;
  /// quasistatic::NodeScale, per node: scale; without inverse
  physgen::WithFormats<::quasistatic::NodeScaleArray<float, Space>, LevelScalesFormats<Space>> scales;
  /// elasticity::NodeStiffness, per node: K
  ::elasticity::NodeStiffnessArray<float, Space> node_stiffness;
  /// quasistatic::NodeInverse, per node: D
  ::quasistatic::NodeInverseArray<float, Space> inverse;
  /// elasticity::NodeForceDifferential, per node: df
  ::elasticity::NodeForceDifferentialArray<float, Space> residual;
  /// elasticity::NodeDisplacement, per node: dx
  ::elasticity::NodeDisplacementArray<float, Space> correction;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(constraints, counts.node);
    physgen::allocate(scales, counts.node, {"scale"});
    physgen::allocate(node_stiffness, counts.node, {"K"});
    physgen::allocate(inverse, counts.node, {"D"});
    physgen::allocate(residual, counts.node, {"df"});
    physgen::allocate(correction, counts.node, {"dx"});
  }

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return constraints.bytes(
        ) + scales.bytes() + node_stiffness.bytes() + inverse.bytes() + residual.bytes() + correction.bytes();
  }
};

/// Conjugate gradients.
template <class Space_ = physgen::Host>
struct Vectors {
  using Space = Space_;
  using Real = float;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
  };

  /// elasticity::NodeDisplacement, per node: dx
  ::elasticity::NodeDisplacementArray<float, Space> step;
  /// elasticity::NodeForceDifferential, per node: df
  ::elasticity::NodeForceDifferentialArray<float, Space> residual;
  /// elasticity::NodeDisplacement, per node: dx
  ::elasticity::NodeDisplacementArray<float, Space> direction;
  /// elasticity::NodeForceDifferential, per node: df
  ::elasticity::NodeForceDifferentialArray<float, Space> product;
  /// quasistatic::LinearSolve, 1 object: rz, rz_first, tolerance, alpha, beta, iterations, status
  ::quasistatic::LinearSolveArray<double, Space> state;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(step, counts.node, {"dx"});
    physgen::allocate(residual, counts.node, {"df"});
    physgen::allocate(direction, counts.node, {"dx"});
    physgen::allocate(product, counts.node, {"df"});
    physgen::allocate(state, 1, {"rz", "rz_first", "tolerance", "alpha", "beta", "iterations", "status"});
  }

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return step.bytes() + residual.bytes() + direction.bytes() + product.bytes() + state.bytes();
  }
};

}  // namespace scenes::linear_elastic_scene
