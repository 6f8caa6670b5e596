// The groups of arrays of the quasistatic solver, as scenes declare them: a scene derives from those that its program
// has, and physgen finds which of their fields it needs.
#pragma once

#include <contact.physgen.h>
#include <dynamics.physgen.h>
#include <elasticity.physgen.h>
#include <physgen/scene.h>
#include <quasistatic.physgen.h>

namespace physgen::fem::groups {
using namespace physgen::scene;
using scene::Array;

/// The precision of tangents.
using Real = float;

/// A mesh on which equilibrium is sought: in double what decides the result, in Real the tangent.
struct OfBody {
  struct Body {
    PHYSGEN_ARRAY(per("tet"), input(), names("nodes", "node"), follows("node")) Array<elasticity::TetObject, Real> tets;
    /// The tets of each node: rows of NodeTetEntry.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::IncidenceRangeObject, float> node_tet_ranges;
    PHYSGEN_ARRAY(per("corner"), input(), names("code", "tet", shifted(2)), names("code", "chunk_tet", shifted(2)),
                  names("code", "kept_tet", shifted(2)))
    Array<quasistatic::PackedIncidenceObject, float> node_tet_entries;
    /// The tets of each edge: rows of EdgeTetEntry. None where the stiffness is not assembled.
    PHYSGEN_ARRAY(per("edge"), input()) Array<elasticity::IncidenceRangeObject, float> edge_tet_ranges;
    PHYSGEN_ARRAY(per("tet_edge"), input(), names("code", "kept_tet", shifted(4)))
    Array<quasistatic::PackedIncidenceObject, float> edge_tet_entries;
    /// The volumes of each patch or node where volumes are averaged.
    PHYSGEN_ARRAY(per("volume")) Array<quasistatic::MeanVolumeObject, double> volumes;

    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::NodePositionObject, double> rest;
    /// Positions of the last equilibrium, or of the step under way.
    PHYSGEN_ARRAY(per("node"), input(), output()) Array<elasticity::NodePositionObject, double> positions;
    /// Where a step leads.
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodePositionObject, double> trial;
    /// Where the load increment began.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::NodePositionObject, double> kept;
    /// External, at a load of 1.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::NodeForceObject, double> loads;
    /// The motion of prescribed components, at a load of 1.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::NodeDisplacementObject, double> motion;
    /// Elastic and external; in prescribed components minus the reaction.
    PHYSGEN_ARRAY(per("node"), output()) Array<elasticity::NodeForceObject, double> forces;
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeForceObject, double> trial_forces;
    /// The increment of prescribed components.
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeDisplacementObject, double> increment;
    /// Its volumetric energy is 0 where no volumes are averaged.
    PHYSGEN_ARRAY(per(1), input("volumetric")) Array<quasistatic::EquilibriumObject, double> state;
  };
};

/// Volumes that are averaged over patches of tets.
struct OfPatches {
  struct Patches {
    PHYSGEN_ARRAY(per("tet"), input(), names("patch", "volume")) Array<quasistatic::TetPatchObject, Real> tet_patches;
    PHYSGEN_ARRAY(per("patch"), input(), names("nodes", "node"), follows("node"))
    Array<quasistatic::PatchNodesObject, Real> nodes;
    /// Where there is a coarser level.
    PHYSGEN_ARRAY(per("child"), input(), names("patch", "volume")) Array<quasistatic::PatchParentObject, Real> parents;
    PHYSGEN_ARRAY(per("patch"), input()) Array<elasticity::IncidenceRangeObject, float> patch_tet_ranges;
    PHYSGEN_ARRAY(per("tet"), input(), names("tet", "tet")) Array<quasistatic::PatchTetObject, float> patch_tet_entries;
    /// Rows of EdgePatchEntry, where the stiffness is assembled.
    PHYSGEN_ARRAY(per("edge"), input()) Array<elasticity::IncidenceRangeObject, float> edge_patch_ranges;
    PHYSGEN_ARRAY(per("edge_patch"), input(), names("code", "patch", shifted(6)))
    Array<quasistatic::PackedIncidenceObject, float> edge_patch_entries;
    /// Rows of NodePatchEntry, where it is not.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::IncidenceRangeObject, float> node_patch_ranges;
    PHYSGEN_ARRAY(per("node_patch"), input(), names("code", "patch", shifted(3)), names("code", "change", shifted(3)))
    Array<quasistatic::PackedIncidenceObject, float> node_patch_entries;
    PHYSGEN_ARRAY(per("patch")) Array<quasistatic::PatchTangentObject, Real> tangent;
    /// The changes in products without blocks of edges, on the CPU.
    PHYSGEN_ARRAY(per("change"), follows("node")) Array<quasistatic::PatchChangeObject, Real> changes;
  };
};

/// Volumes that are averaged at nodes.
struct OfRings {
  struct Rings {
    /// The nodes of each node's ring, ascending.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::IncidenceRangeObject, float> node_ranges;
    PHYSGEN_ARRAY(per("neighbour"), input("node"), names("node", "node"), names("node", "volume"))
    Array<quasistatic::RingNodeObject, Real> node_entries;
    PHYSGEN_ARRAY(per("node")) Array<quasistatic::NodeVolumeTangentObject, Real> tangent;
  };
};

/// The arrays that kernels over a chunk of tets leave for the next.
struct OfChunk {
  struct Chunk {
    PHYSGEN_ARRAY(per("chunk_tet"), follows("node")) Array<elasticity::CornerForcesObject, double> corners;
    /// The tangent of a chunk, or of all tets.
    PHYSGEN_ARRAY(per("kept_tet"), follows("node")) Array<quasistatic::TetTangentObject, Real> tangent;
  };
};

/// The linear system of a level.
struct OfLevel {
  struct Level {
    PHYSGEN_ARRAY(per("node"), input(), no_index("fixed")) Array<quasistatic::NodeConstraintObject, Real> constraints;
    PHYSGEN_ARRAY(per("edge"), input(), names("nodes", "node"), names("nodes", "edge_node"),
                  names("nodes", "block_node"), follows("node"))
    Array<elasticity::EdgeObject, Real> edges;
    /// Rows of NodeEdgeEntry.
    PHYSGEN_ARRAY(per("edge_node"), input()) Array<elasticity::IncidenceRangeObject, float> node_edge_ranges;
    PHYSGEN_ARRAY(per("edge_end"), input(), names("code", "edge", shifted(1)))
    Array<quasistatic::PackedIncidenceObject, float> node_edge_entries;
    PHYSGEN_ARRAY(per("block_node")) Array<elasticity::NodeStiffnessObject, Real> node_stiffness;
    PHYSGEN_ARRAY(per("edge")) Array<elasticity::EdgeStiffnessObject, Real> edge_stiffness;

    // The preconditioner, in unknowns scaled to a unit diagonal.
    PHYSGEN_ARRAY(per("node"), input()) Array<quasistatic::NodeScaleObject, Real> scales;
    PHYSGEN_ARRAY(per("edge_node")) Array<elasticity::NodeStiffnessObject, Real> scaled_nodes;
    PHYSGEN_ARRAY(per("edge")) Array<elasticity::EdgeStiffnessObject, Real> scaled_edges;
    PHYSGEN_ARRAY(per("block_node")) Array<quasistatic::NodeInverseObject, Real> inverse;
    PHYSGEN_ARRAY(per("smoother")) Array<quasistatic::SmootherObject, double> smoother;
    /// r
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeForceDifferentialObject, Real> residual;
    /// z
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeDisplacementObject, Real> correction;
    /// d
    PHYSGEN_ARRAY(per("edge_node")) Array<elasticity::NodeDisplacementObject, Real> direction;
    /// The eigenvector that power iterations approach.
    PHYSGEN_ARRAY(per("edge_node")) Array<elasticity::NodeDisplacementObject, Real> power;

    // To the next coarser level; none on the coarsest.
    PHYSGEN_ARRAY(per("child"), input(), names("nodes", "node"))
    Array<quasistatic::NodeParentsObject, Real> parents;
    /// In place of `parents`, to a background grid.
    PHYSGEN_ARRAY(per("grid_child"), input(), names("nodes", "node"))
    Array<quasistatic::GridParentsObject, Real> grid_parents;
    /// The children of each node of the coarser level: rows of ChildEntry.
    PHYSGEN_ARRAY(per("parent"), input()) Array<elasticity::IncidenceRangeObject, float> child_ranges;
    PHYSGEN_ARRAY(per("child_entry"), input(), names("code", "node", shifted(2)),
                  names("code", "grid_child", shifted(2)), names("code", "grid_node", shifted(2)))
    Array<quasistatic::PackedIncidenceObject, float> child_entries;
    /// The terms of each edge of the coarser level: rows of EdgeTermEntry.
    PHYSGEN_ARRAY(per("coarse_edge"), input()) Array<elasticity::IncidenceRangeObject, float> edge_term_ranges;
    PHYSGEN_ARRAY(per("edge_term"), input(), names("code", "block_node", shifted(3)), names("code", "edge", shifted(3)),
                  names("code", "grid_child", shifted(3)))
    Array<quasistatic::PackedIncidenceObject, float> edge_term_entries;
    /// The levels of a background grid, and the mesh on it, have these.
    PHYSGEN_ARRAY(per("grid_node")) Array<quasistatic::TranslationStiffnessObject, Real> translations;
    /// The coarsest level alone has it.
    PHYSGEN_ARRAY(per("coarse_pair")) Array<quasistatic::CoarseInverseObject, Real> coarse_inverse;
  };
};

/// The rigid planes that the body may touch.
struct OfPlanes {
  struct Planes {
    PHYSGEN_ARRAY(per("plane"), input()) Array<contact::RigidPlaneObject, double> planes;
    /// None where equilibrium is not solved.
    PHYSGEN_ARRAY(per("surface_node"), input()) Array<contact::NodeAreaObject, double> areas;
    /// The part of the nodes' blocks that planes have.
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeStiffnessObject, Real> stiffness;
    /// How one plane and the body touch, where equilibrium is solved.
    PHYSGEN_ARRAY(per("contact")) Array<contact::PlaneContactObject, double> contact;
  };
};

/// Faces that pressures push which follow the surface.
struct OfSurface {
  struct Surface {
    PHYSGEN_ARRAY(per("face"), input(), names("nodes", "node"), follows("node"))
    Array<contact::PressedFaceObject, double> faces;
    /// The faces of each node, and those of each edge: rows of NodeTetEntry.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::IncidenceRangeObject, float> node_face_ranges;
    PHYSGEN_ARRAY(per("face_corner"), input(), names("code", "face", shifted(2)))
    Array<quasistatic::PackedIncidenceObject, float> node_face_entries;
    PHYSGEN_ARRAY(per("edge"), input()) Array<elasticity::IncidenceRangeObject, float> edge_face_ranges;
    PHYSGEN_ARRAY(per("face_corner"), input(), names("code", "face", shifted(2)))
    Array<quasistatic::PackedIncidenceObject, float> edge_face_entries;
  };
};

/// Inertia of a body that moves.
struct OfInertia {
  struct Inertia {
    PHYSGEN_ARRAY(per("node"), input()) Array<dynamics::NodeMassObject, double> masses;
    // None where equilibrium is not solved.
    /// Before the first time step they do nothing, but are read.
    PHYSGEN_ARRAY(per("moving_node"), input()) Array<elasticity::NodePositionObject, double> centres;
    PHYSGEN_ARRAY(per("moving_node"), input(), output()) Array<dynamics::NodeVelocityObject, double> velocities;
    /// Without elastic energy, which stands in the body's state: here it stays what it is at the beginning.
    PHYSGEN_ARRAY(per("measure"), input("elastic")) Array<dynamics::MotionObject, double> measured;
  };
};

/// A linear elastic body: ten numbers are kept per tet, its shape at rest.
struct OfLinear {
  struct Linear {
    PHYSGEN_ARRAY(per("tet"), input(), names("nodes", "node"), follows("node")) Array<elasticity::TetObject, Real> tets;
    PHYSGEN_ARRAY(per("tet"), input()) Array<elasticity::RestShapeObject, double> rest;
    /// The tets of each node: rows of NodeTetEntry.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::IncidenceRangeObject, float> node_tet_ranges;
    PHYSGEN_ARRAY(per("corner"), input(), names("code", "tet", shifted(2)))
    Array<quasistatic::PackedIncidenceObject, float> node_tets;
    /// The tets of each edge: rows of EdgeTetEntry. None where the stiffness is not assembled.
    PHYSGEN_ARRAY(per("edge"), input()) Array<elasticity::IncidenceRangeObject, float> edge_tet_ranges;
    PHYSGEN_ARRAY(per("tet_edge"), input(), names("code", "tet", shifted(4)))
    Array<quasistatic::PackedIncidenceObject, float> edge_tets;
    /// u, from rest.
    PHYSGEN_ARRAY(per("node"), output()) Array<elasticity::NodeDisplacementObject, double> displacements;
    /// The motion of prescribed components, at a load of 1.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::NodeDisplacementObject, double> motion;
    /// External, at a load of 1.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::NodeForceObject, double> loads;
    /// Elastic and external; in prescribed components minus the reaction.
    PHYSGEN_ARRAY(per("node"), output()) Array<elasticity::NodeForceObject, double> forces;
    /// Its volumetric energy and its work stay 0.
    PHYSGEN_ARRAY(per(1), input("volumetric", "work"), output()) Array<quasistatic::EquilibriumObject, double> state;
  };
};

/// The vectors of one linear solve.
struct OfKrylov {
  struct Krylov {
    /// dx
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeDisplacementObject, Real> step;
    /// r = f + K dx
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeForceDifferentialObject, Real> residual;
    /// p
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeDisplacementObject, Real> direction;
    /// K p
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeForceDifferentialObject, Real> product;
    PHYSGEN_ARRAY(per(1)) Array<quasistatic::LinearSolveObject, double> state;
  };
};

/// First Piola-Kirchhoff stresses, where they are asked for.
struct OfStresses {
  struct Stresses {
    PHYSGEN_ARRAY(per("tet"), output()) Array<elasticity::StressObject, double> of_tets;
  };
};

}  // namespace physgen::fem::groups
