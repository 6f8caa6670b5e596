// Arrays of the scene linear_elastic, with the fields that its program needs. Written by physgen from
// scenes/linear_elastic.h and the kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scene_arrays.h>

#include <elasticity.physgen.h>
#include <quasistatic.physgen.h>

namespace scenes {
struct linear_elastic;
}

/// Linear elasticity: an equilibrium by conjugate gradients without blocks of edges, preconditioned by the inverses of
/// nodes' blocks.
namespace scenes::linear_elastic_scene {

namespace tags::body {
struct tets { static constexpr const char* name = "body.tets"; };
struct rest { static constexpr const char* name = "body.rest"; };
struct node_tet_ranges { static constexpr const char* name = "body.node_tet_ranges"; };
struct node_tets { static constexpr const char* name = "body.node_tets"; };
struct loads { static constexpr const char* name = "body.loads"; };
struct motion { static constexpr const char* name = "body.motion"; };
struct displacements { static constexpr const char* name = "body.displacements"; };
struct forces { static constexpr const char* name = "body.forces"; };
struct state {
  static constexpr const char* name = "body.state";
  struct volumetric;
  struct work;
  struct smallest_ratio;
};
}  // namespace tags::body

/// How quasistatic::Equilibrium is stored in body.state. Not stored:
/// - volumetric, work, smallest_ratio: nothing uses it
template <class Stored>
struct BodyStateFormats : Stored {
  using volumetric = physgen::format::Pruned<linear_elastic, tags::body::state, tags::body::state::volumetric>;
  using work = physgen::format::Pruned<linear_elastic, tags::body::state, tags::body::state::work>;
  using smallest_ratio = physgen::format::Pruned<linear_elastic, tags::body::state, tags::body::state::smallest_ratio>;
};

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Body {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t tet = 0;
    physgen::index_t node = 0;
    physgen::index_t corner = 0;
  };

  /// elasticity::Tet, per tet: nodes
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::tets, ::elasticity::TetArray<Real, Space>>> tets;
  /// elasticity::RestShape, per tet: dm_inverse, volume
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::rest, ::elasticity::RestShapeArray<double,
      Space>>> rest;
  /// The tets of each node: rows of a tet and a corner in one number.
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::node_tet_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> node_tet_ranges;
  /// quasistatic::PackedIncidence, per corner: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::node_tets, ::quasistatic::PackedIncidenceArray<float,
      Space>>> node_tets;
  /// External forces, and the motion of prescribed components, at a load of 1.
  /// elasticity::NodeForce, per node: f
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::loads, ::elasticity::NodeForceArray<double,
      Space>>> loads;
  /// elasticity::NodeDisplacement, per node: dx
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::motion, ::elasticity::NodeDisplacementArray<double,
      Space>>> motion;
  /// From rest.
  /// elasticity::NodeDisplacement, per node: dx
  physgen::StoredArray<Stored, tags::body::displacements, ::elasticity::NodeDisplacementArray<double,
      Space>> displacements;
  /// elasticity::NodeForce, per node: f
  physgen::StoredArray<Stored, tags::body::forces, ::elasticity::NodeForceArray<double, Space>> forces;
  /// Before the solve.
  /// quasistatic::Equilibrium, 1 object: elastic, loads, free_square, fixed_square; without volumetric, work,
  /// smallest_ratio
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::body::state, ::quasistatic::EquilibriumArray<double, Space>>,
      BodyStateFormats> state;

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
    return tets.bytes() + rest.bytes() + node_tet_ranges.bytes() + node_tets.bytes() + loads.bytes() + motion.bytes() +
           displacements.bytes() + forces.bytes() + state.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(tets)>(counts.tet) + physgen::bytes_of_array<decltype(rest)>(counts.tet) +
           physgen::bytes_of_array<decltype(node_tet_ranges)>(counts.node) +
           physgen::bytes_of_array<decltype(node_tets)>(counts.corner) +
           physgen::bytes_of_array<decltype(loads)>(counts.node) +
           physgen::bytes_of_array<decltype(motion)>(counts.node) +
           physgen::bytes_of_array<decltype(displacements)>(counts.node) +
           physgen::bytes_of_array<decltype(forces)>(counts.node) + physgen::bytes_of_array<decltype(state)>(1);
  }
};

namespace tags::level {
struct constraints { static constexpr const char* name = "level.constraints"; };
struct scales {
  static constexpr const char* name = "level.scales";
  struct inverse;
};
struct node_stiffness { static constexpr const char* name = "level.node_stiffness"; };
struct inverse { static constexpr const char* name = "level.inverse"; };
struct residual { static constexpr const char* name = "level.residual"; };
struct correction { static constexpr const char* name = "level.correction"; };
}  // namespace tags::level

/// How quasistatic::NodeScale is stored in level.scales. Not stored:
/// - inverse: written by physgen::fem::ComputeNodeScale(level.node_stiffness, level.scales); nothing reads it
template <class Stored>
struct LevelScalesFormats : Stored {
  using inverse = physgen::format::Pruned<linear_elastic, tags::level::scales, tags::level::scales::inverse>;
};

/// The preconditioner, in unknowns scaled to a unit diagonal.
template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Level {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
  };

  /// quasistatic::NodeConstraint, per node: fixed
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::level::constraints, ::quasistatic::NodeConstraintArray<Real,
      Space>>> constraints;
  /// quasistatic::NodeScale, per node: scale; without inverse
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::scales, ::quasistatic::NodeScaleArray<Real, Space>>,
      LevelScalesFormats> scales;
  /// elasticity::NodeStiffness, per node: K
  physgen::StoredArray<Stored, tags::level::node_stiffness, ::elasticity::NodeStiffnessArray<Real,
      Space>> node_stiffness;
  /// quasistatic::NodeInverse, per node: D
  physgen::StoredArray<Stored, tags::level::inverse, ::quasistatic::NodeInverseArray<Real, Space>> inverse;
  /// elasticity::NodeForceDifferential, per node: df
  physgen::StoredArray<Stored, tags::level::residual, ::elasticity::NodeForceDifferentialArray<Real, Space>> residual;
  /// elasticity::NodeDisplacement, per node: dx
  physgen::StoredArray<Stored, tags::level::correction, ::elasticity::NodeDisplacementArray<Real, Space>> correction;

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
    return constraints.bytes() + scales.bytes() + node_stiffness.bytes() + inverse.bytes() + residual.bytes() +
           correction.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(constraints)>(counts.node) +
           physgen::bytes_of_array<decltype(scales)>(counts.node) +
           physgen::bytes_of_array<decltype(node_stiffness)>(counts.node) +
           physgen::bytes_of_array<decltype(inverse)>(counts.node) +
           physgen::bytes_of_array<decltype(residual)>(counts.node) +
           physgen::bytes_of_array<decltype(correction)>(counts.node);
  }
};

namespace tags::vectors {
struct step { static constexpr const char* name = "vectors.step"; };
struct residual { static constexpr const char* name = "vectors.residual"; };
struct direction { static constexpr const char* name = "vectors.direction"; };
struct product { static constexpr const char* name = "vectors.product"; };
struct state { static constexpr const char* name = "vectors.state"; };
}  // namespace tags::vectors

/// Conjugate gradients.
template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Vectors {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
  };

  /// elasticity::NodeDisplacement, per node: dx
  physgen::StoredArray<Stored, tags::vectors::step, ::elasticity::NodeDisplacementArray<Real, Space>> step;
  /// elasticity::NodeForceDifferential, per node: df
  physgen::StoredArray<Stored, tags::vectors::residual, ::elasticity::NodeForceDifferentialArray<Real, Space>> residual;
  /// elasticity::NodeDisplacement, per node: dx
  physgen::StoredArray<Stored, tags::vectors::direction, ::elasticity::NodeDisplacementArray<Real, Space>> direction;
  /// elasticity::NodeForceDifferential, per node: df
  physgen::StoredArray<Stored, tags::vectors::product, ::elasticity::NodeForceDifferentialArray<Real, Space>> product;
  /// quasistatic::LinearSolve, 1 object: rz, rz_first, tolerance, alpha, beta, iterations, status
  physgen::StoredArray<Stored, tags::vectors::state, ::quasistatic::LinearSolveArray<double, Space>> state;

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
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(step)>(counts.node) +
           physgen::bytes_of_array<decltype(residual)>(counts.node) +
           physgen::bytes_of_array<decltype(direction)>(counts.node) +
           physgen::bytes_of_array<decltype(product)>(counts.node) + physgen::bytes_of_array<decltype(state)>(1);
  }
};

}  // namespace scenes::linear_elastic_scene
