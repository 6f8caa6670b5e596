// Object types of finite element elasticity on linear tetrahedra: what the kernels of tools/fem read and write. A tet
// has the corners i, j, k, l; matrices built from corners have the columns j, k, l. Fields of elements are streamed in
// order and lie in tiles; vectors of nodes are gathered by elements and lie as padded records.
#pragma once

#include <physgen/schema.h>

namespace elasticity {
using namespace physgen::schema;

// ---- Per element: deformation and stress ----

/// Deformation gradient of one element, F = Ds Dm^-1.
struct PHYSGEN_OBJECT() DeformationGradient {
  PHYSGEN(unit("1")) Matrix<3, 3> F;  ///< current over rest shape; the identity at rest
};

/// Differential of the deformation gradient.
struct PHYSGEN_OBJECT() DeformationGradientDifferential {
  PHYSGEN(unit("1")) Matrix<3, 3> dF;  ///< change of F along a displacement differential
};

/// Rotation-variant SVD of the deformation gradient, F = U diag(s) V^T.
struct PHYSGEN_OBJECT() DeformationSvd {
  Rotation U, V;                     ///< principal directions: U in the current, V in the rest shape
  PHYSGEN(unit("1")) Diagonal<3> s;  ///< principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted
};

/// The same with the rotations as unit quaternions: 11 scalars instead of 21.
struct PHYSGEN_OBJECT() QuaternionSvd {
  Vector<4> u, v;                    ///< unit quaternions w, x, y, z of U and V, w >= 0
  PHYSGEN(unit("1")) Diagonal<3> s;  ///< principal stretches, s1 >= s2 >= |s3|; s3 < 0 where inverted
};

/// Principal directions of the deformation gradient alone: what the force differential reads of its SVD.
struct PHYSGEN_OBJECT() PrincipalDirections {
  Rotation U, V;  ///< U in the current, V in the rest shape
};

/// Principal stretches of the deformation gradient alone.
struct PHYSGEN_OBJECT() PrincipalStretches {
  PHYSGEN(unit("1")) Diagonal<3> s;  ///< s1 >= s2 >= |s3|; s3 < 0 where inverted
};

/// A rotation: the polar factor R = U V^T of the deformation gradient, or principal directions by themselves.
struct PHYSGEN_OBJECT() ElementRotation {
  Rotation R;  ///< det R = 1
};

/// Isotropic stress derivative in principal axes (12 scalars): x_iikk = d2psi/(ds_i ds_k), and for the pairs (a,b) =
/// (2,1), (3,1), (3,2) the entries x_abab and x_abba.
struct PHYSGEN_OBJECT() StressDerivative {
  PHYSGEN(unit("Pa")) Scalar x1111, x2211, x3311, x2222, x3322, x3333;  ///< stretch: the symmetric 3x3 block
  PHYSGEN(unit("Pa")) Scalar x2121, x2112, x3131, x3113, x3232, x3223;  ///< shear: one 2x2 block per pair
};

/// First Piola-Kirchhoff stress of one element.
struct PHYSGEN_OBJECT() Stress {
  PHYSGEN(unit("Pa")) Matrix<3, 3> P;  ///< dpsi/dF: force in the current shape per area of the rest shape
};

/// Differential of the first Piola-Kirchhoff stress.
struct PHYSGEN_OBJECT() StressDifferential {
  PHYSGEN(unit("Pa")) Matrix<3, 3> dP;  ///< change of P along dF
};

/// Rest shape of one tet.
struct PHYSGEN_OBJECT() RestShape {
  PHYSGEN(unit("1/m")) Matrix<3, 3> dm_inverse;  ///< Dm^-1, with Dm = [Xj-Xi, Xk-Xi, Xl-Xi] by columns
  PHYSGEN(unit("m^3")) Scalar volume;            ///< det(Dm) / 6, positive
};

/// Forces of one tet on its corners j, k, l, by columns; the force on i is minus their sum.
struct PHYSGEN_OBJECT() CornerForces {
  PHYSGEN(unit("N")) Matrix<3, 3> G;  ///< G = -volume P Dm^-T
};

/// All that dP from dF reads and writes of one element, in one record of 48 scalars: what simulators with an array of
/// whole elements have. For comparison.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) ElementRecord {
  Rotation U, V;                                                        ///< principal directions
  PHYSGEN(unit("Pa")) Scalar x1111, x2211, x3311, x2222, x3322, x3333;  ///< as in StressDerivative
  PHYSGEN(unit("Pa")) Scalar x2121, x2112, x3131, x3113, x3232, x3223;  ///< as in StressDerivative
  PHYSGEN(unit("1")) Matrix<3, 3> dF;   ///< change of F along a displacement differential
  PHYSGEN(unit("Pa")) Matrix<3, 3> dP;  ///< change of P along dF
};

// ---- Per node: vectors that elements gather ----

/// Current position of a node.
struct PHYSGEN_OBJECT(layout(host, aos_padded), layout(cuda, aos_padded)) NodePosition {
  PHYSGEN(unit("m")) Vector<3> x;  ///< position
};

/// Force on a node.
struct PHYSGEN_OBJECT(layout(host, aos_padded), layout(cuda, aos_padded)) NodeForce {
  PHYSGEN(unit("N")) Vector<3> f;  ///< sum of the elements' forces on the node
};

/// Force of one tet on one of its corners, at its place in the row of that corner's node.
struct PHYSGEN_OBJECT(layout(host, aos_padded), layout(cuda, aos_padded)) PlacedForce {
  PHYSGEN(unit("N")) Vector<3> f;  ///< of the tet on the node
};

/// Displacement differential of a node.
struct PHYSGEN_OBJECT(layout(host, aos_padded), layout(cuda, aos_padded)) NodeDisplacement {
  PHYSGEN(unit("m")) Vector<3> dx;  ///< direction in which forces are differentiated
};

/// Force differential of a node.
struct PHYSGEN_OBJECT(layout(host, aos_padded), layout(cuda, aos_padded)) NodeForceDifferential {
  PHYSGEN(unit("N")) Vector<3> df;  ///< change of the node's force along the displacement differential
};

// ---- Stiffness: df(v) += K_v dx(v) per node, df(m) += E dx(n) and df(n) += E^T dx(m) per edge (m,n) ----

/// Diagonal block of a node.
struct PHYSGEN_OBJECT() NodeStiffness {
  PHYSGEN(unit("N/m")) Symmetric<3> K;  ///< df(v)/dx(v)
};

/// Off-diagonal block of an edge (m,n). The symmetric product streams it, edge after edge.
struct PHYSGEN_OBJECT() EdgeStiffness {
  PHYSGEN(unit("N/m")) Matrix<3, 3> E;  ///< df(m)/dx(n)
};

/// Blocks of one tet, before the sums over the tets of a node and of an edge.
struct PHYSGEN_OBJECT() TetStiffness {
  PHYSGEN(unit("N/m")) Symmetric<3> k[4];  ///< corners i, j, k, l
  PHYSGEN(unit("N/m")) Matrix<3, 3> e[6];  ///< edges ij, ik, il, jk, jl, kl: df(first)/dx(second)
};

// ---- Connectivity ----

/// Nodes of a tet.
struct PHYSGEN_OBJECT() Tet {
  Vector<4, Index> nodes;  ///< corners i, j, k, l; det(Dm) > 0
};

/// Where the corners of a tet stand among the incidences of nodes.
struct PHYSGEN_OBJECT() TetPlaces {
  Vector<4, Index> places;  ///< of corners i, j, k, l: numbers of entries
};

/// Nodes of an edge.
struct PHYSGEN_OBJECT() Edge {
  Vector<2, Index> nodes;  ///< m and n: the block of the edge is df(m)/dx(n)
};

/// The incidences of one node or edge: entries begin up to, not including, end of an array of Incidence.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) IncidenceRange {
  Index begin, end;  ///< half-open range
};

/// An element that touches a node or an edge.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aos)) Incidence {
  Index element;  ///< which tet, or which edge
  Index local;    ///< which of its corners, or of its edges, it is
};

}  // namespace elasticity
