// Object types of the quasistatic solver: what Newton's method, conjugate gradients and the multigrid hierarchy keep
// beside the elements and nodes of elasticity.h. Names of arrays say which member of a level each is.
#pragma once

#include <physgen/schema.h>

namespace quasistatic {
using namespace physgen::schema;

// ---- Per node ----

/// Which components of a node's position are prescribed: bit k is set for component k.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) NodeConstraint {
  Index fixed;  ///< 0: free; 7: held in all directions
};

/// The two nodes of the next coarser level half-way between which a node lies; twice the same where it coincides.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) NodeParents {
  Vector<2, Index> nodes;  ///< numbers on the coarser level
};

/// The tet of a background grid in which a node lies: linear interpolation between its corners.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) GridParents {
  Vector<4, Index> nodes;                ///< numbers on the coarser level; a corner without weight repeats the first
  PHYSGEN(unit("1")) Vector<4> weights;  ///< they add up to 1
};

/// The scale of a node's unknowns inside the preconditioner, a power of two, so that scaling rounds nothing.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) NodeScale {
  Scalar scale;    ///< the largest entry on the diagonal of scale^2 K is in [1/2, 2)
  Scalar inverse;  ///< 1 / scale
};

/// The inverse of a node's diagonal block: block Jacobi.
struct PHYSGEN_OBJECT() NodeInverse {
  Symmetric<3> D;  ///< -K^-1 over the free components, 0 in prescribed ones
};

/// How stiffness without its prescribed components resists a translation of all nodes: its rows, summed.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) TranslationStiffness {
  PHYSGEN(unit("N/m")) Matrix<3, 3> T;  ///< sum of df(v)/dx(w) over all nodes w; 0 far from what is prescribed
};

// ---- Per tet, and per patch or ring ----

/// The tangent of one tet: the blocks of its edges are formed from it where they are summed.
struct PHYSGEN_OBJECT() TetTangent {
  Matrix<3, 3> U;                                                        ///< principal directions in the current shape
  PHYSGEN(unit("1/m")) Matrix<3, 3> g;                                   ///< by columns: V^T grad of corners j, k, l
  PHYSGEN(unit("N m")) Scalar x1111, x2211, x3311, x2222, x3322, x3333;  ///< volume times those of StressDerivative
  PHYSGEN(unit("N m")) Scalar x2121, x2112, x3131, x3113, x3232, x3223;  ///< volume times those of StressDerivative
};

/// Which patch a tet's volume is averaged over.
struct PHYSGEN_OBJECT() TetPatch {
  Index patch;  ///< its number
};

/// The patch of the next coarser level where a patch lies.
struct PHYSGEN_OBJECT() PatchParent {
  Index patch;  ///< its number on the coarser level
};

/// The nodes of a patch of tets.
struct PHYSGEN_OBJECT() PatchNodes {
  Vector<8, Index> nodes;  ///< unused ones repeat the first
};

/// A tet of a patch.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) PatchTet {
  Index tet;    ///< its number
  Index slots;  ///< which of the patch's nodes its corners are: 3 bits each, corner i lowest
};

/// The volume of a patch, or the mean one of the tets of a node, and what resists its change.
struct PHYSGEN_OBJECT() MeanVolume {
  PHYSGEN(unit("m^3")) Scalar volume;           ///< at rest
  PHYSGEN(unit("1")) Scalar ratio;              ///< T: current over rest volume
  PHYSGEN(unit("Pa")) Scalar pressure;          ///< U'(T): of the forces
  PHYSGEN(unit("Pa")) Scalar linearised;        ///< pi, which converges to U'(T) T or, of a quadratic law, to U'(T)
  PHYSGEN(unit("Pa")) Scalar tangent_pressure;  ///< of the tangent
  PHYSGEN(unit("Pa")) Scalar before, full;      ///< pi before a Newton step, and after all of it
};

/// One of a node's ring: a neighbour, or the node itself. Neighbours are in each other's rings.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) RingNode {
  Index node;                        ///< its number
  PHYSGEN(unit("m^2")) Vector<3> g;  ///< change of its mean volume with the node whose ring it is in
};

/// The resistance to a change of a node's mean volume: k of its k g g^T in the tangent.
struct PHYSGEN_OBJECT() NodeVolumeTangent {
  PHYSGEN(unit("N/m^5")) Scalar k;  ///< U''(T) / volume, or its linearised form
};

/// A block of the inverse of the coarsest level's stiffness, which is dense.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) CoarseInverse {
  Matrix<3, 3> G;  ///< of nodes i and j of n, in object i n + j
};

/// The part of the tangent that a patch's volume has: k g g^T.
struct PHYSGEN_OBJECT() PatchTangent {
  PHYSGEN(unit("m^2")) Matrix<3, 8> g;  ///< by columns: change of the patch's volume with its nodes
  PHYSGEN(unit("N/m^5")) Scalar k;      ///< U''(T) / volume, or its linearised form
};

/// The change of a patch's forces along a displacement, on the CPU in a product without blocks of edges.
struct PHYSGEN_OBJECT() PatchChange {
  PHYSGEN(unit("N/m^2")) Scalar change;  ///< k g . dx
};

// ---- The multilevel Schwarz preconditioner: blocks of 32 nodes, then of 32 supernodes, level after level ----

/// Where a node stands in the order of blocks.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) SchwarzNode {
  Index slot;  ///< number of its SchwarzSlot; -1: all its components are prescribed
};

/// A place in a block: slots 32 b .. 32 b + 31 are those of block b.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) SchwarzSlot {
  Index source;  ///< which node stands here, or behind the first level which supernode; -1: none
  Index parent;  ///< the supernode of the next level that it belongs to; -1 on the last level
};

/// A block of 32 slots.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) SchwarzBlock {
  Scalar scale;    ///< a power of two, by which the stored factor is smaller than the real one
  Index parent;    ///< the block of the next level that its supernodes belong to; -1 on the last level
  Index children;  ///< how many blocks of the level before have this one as their parent
  Index arrived;   ///< how many of them have handed their forces over; 0 between two applications
};

/// Nodes that are connected within one block, and move as one on the next level.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) Supernode {
  PHYSGEN(unit("N/m")) Symmetric<3> K;       ///< sum of the stiffness of its nodes and of the edges among them
  PHYSGEN(unit("N/m")) Vector<3> magnitude;  ///< sum of its nodes' |K_kk|: what rounding is measured against
};

/// One term of the sum for a supernode, or for a pair of them.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) SchwarzTerm {
  Index source;  ///< a node or an edge of the level before
  Index kind;    ///< of a supernode: 0 a node, 1 an edge inside; of a pair: 0 an edge, 1 an edge the other way round
};

/// An edge whose two ends stand in one block.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) SchwarzPair {
  Index edge;    ///< its number
  Index places;  ///< that of m + 32 that of n
};

/// A part of W, W^T W being the inverse of a block's -K: 3x3 blocks of the lower triangle, diagonal after diagonal.
/// Those i + d below, i and, of a distance of 32 - d, i below, i + d - 32 share the 32 objects of d.
struct PHYSGEN_OBJECT() SchwarzFactor {
  Matrix<3, 3> W;  ///< of block b in objects 544 b + 32 d + i, d = 0 .. 16
};

// ---- One object each: numbers that kernels leave for kernels ----

/// Conjugate gradients; in double.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) LinearSolve {
  PHYSGEN(unit("N m")) Scalar rz;         ///< r . z of this iteration
  PHYSGEN(unit("N m")) Scalar rz_first;   ///< of the first
  PHYSGEN(unit("1")) Scalar tolerance;    ///< of sqrt(rz / rz_first)
  PHYSGEN(unit("1")) Scalar alpha, beta;  ///< the length of this step, and what the next keeps of its direction
  Index iterations;                       ///< done
  Index status;                           ///< fem::LinearStatus
};

/// An element that touches a node or an edge, and where in it, in one number.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) PackedIncidence {
  Index code;  ///< element 2^bits + local: each list has bits of its own (fem::PackedEntry)
};

/// How a level is smoothed.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) Smoother {
  PHYSGEN(unit("1")) Scalar largest;  ///< an estimate of the largest eigenvalue of -D K
  PHYSGEN(unit("1")) Scalar length;   ///< of the vector that power iterations began with
};

/// Energy and residual of a state; in double.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) Equilibrium {
  PHYSGEN(unit("J")) Scalar elastic;         ///< energy of the tets
  PHYSGEN(unit("J")) Scalar volumetric;      ///< energy of the mean volumes
  PHYSGEN(unit("J")) Scalar loads;           ///< potential of the external forces and of rigid planes
  PHYSGEN(unit("N^2")) Scalar free_square;   ///< squared length of the forces in free components
  PHYSGEN(unit("N^2")) Scalar fixed_square;  ///< squared length of reactions: of prescribed components and of planes
  PHYSGEN(unit("J")) Scalar work;            ///< of the forces along a step
  PHYSGEN(unit("1")) Scalar smallest_ratio;  ///< the smallest J
};

}  // namespace quasistatic
