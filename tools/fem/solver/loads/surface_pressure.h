// Kernels: a pressure that follows the surface. Each corner of a face has the force -p A / 3, A being its area vector
// as it is: outward, and as long as the area. Its potential is p times the volume under the faces, seen from a centre.
// The tangent of a closed surface, or of one whose edge is held, is symmetric; at a free edge the blocks here are the
// symmetric part of it, so that Newton's method converges linearly there, the faster the lower the pressure.
#pragma once

#include <fem/numerics/scalar.h>
#include <fem/solver/arrays/packed_rows.h>
#include <physgen/kernel.h>

namespace physgen::fem {

namespace detail {

/// The corners of a face, from a centre.
struct FaceCorners {
  Vector3<double> a, b, c;

  template <class Face, class PositionView>
  PHYSGEN_FUNCTION FaceCorners(const Face& face, const PositionView& positions, const Vector3<double>& centre)
      : a(corner(face, positions, 0) - centre),
        b(corner(face, positions, 1) - centre),
        c(corner(face, positions, 2) - centre) {}

  template <class Face, class PositionView>
  [[nodiscard]] PHYSGEN_FUNCTION static Vector3<double> corner(const Face& face, const PositionView& positions, int k) {
    const index_t node = face.nodes()[k];
    return positions[node].x();
  }
  /// Six times the volume of the tet that the centre and the face have.
  [[nodiscard]] PHYSGEN_FUNCTION double six_volumes() const { return dot3<double>(a, cross3<double>(b, c)); }
};

}  // namespace detail

/// f += the forces of the node's faces.
template <class NodeFaces, class FaceView, class PositionView, class ForceView>
struct AddPressures {
  using Scalar = double;
  double load;
  NodeFaces node_faces;    ///< Rows of NodeTetEntry: face, corner
  FaceView faces;          ///< contact::PressedFace
  PositionView positions;  ///< elasticity::NodePosition, current
  ForceView forces;        ///< elasticity::NodeForce

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Vector = Vector3<double>;
    const Vector before = forces[node].f();
    const Vector sum = node_faces.sum(node, before, [&](const auto& entry) -> Vector {
      const auto face = faces[NodeTetEntry::element(entry)];
      const detail::FaceCorners x(face, positions, detail::FaceCorners::corner(face, positions, 0));
      return cross3<double>(x.b, x.c) * (double(face.pressure()) * load / -6);
    });
    forces[node].f() = sum;
  }
};

/// Returns the potential of a face [J], that at rest being 0.
template <class FaceView, class RestView, class PositionView>
struct PressurePotential {
  using Scalar = double;
  double load;
  Vector3<double> centre;  ///< near the faces, against rounding
  FaceView faces;          ///< contact::PressedFace
  RestView rest;           ///< elasticity::NodePosition, at rest
  PositionView positions;  ///< elasticity::NodePosition, current

  PHYSGEN_FUNCTION double operator()(SingleObject auto i) const {
    const auto face = faces[i];
    const double change = detail::FaceCorners(face, positions, centre).six_volumes() -
                          detail::FaceCorners(face, rest, centre).six_volumes();
    return double(face.pressure()) * load * change / 6;
  }
};

/// Joins the potential of other loads in quasistatic::Equilibrium.
template <class StateView>
struct AddPressurePotential {
  StateView state;
  PHYSGEN_FUNCTION void operator()(double energy) const {
    const auto s = state[index_t{0}];
    const double before = s.loads();
    s.loads() = before + energy;
  }
};

/// E(m, n) += the symmetric part of df(m)/dx(n) of the faces at an edge: of one with the corners i, j, k
/// counter-clockwise -p/6 [(x_i + x_j)/2 - x_k]x, [w]x being the matrix of the product w x. The nodes' blocks of it are
/// 0.
template <class EdgeFaces, class EdgeView, class FaceView, class PositionView, class EdgeStiffnessView>
struct AddPressureStiffness {
  using Scalar = double;
  double load;
  EdgeFaces edge_faces;     ///< Rows of NodeTetEntry: face, the corner opposite the edge
  EdgeView ends;            ///< elasticity::Edge
  FaceView faces;           ///< contact::PressedFace
  PositionView positions;   ///< elasticity::NodePosition, current
  EdgeStiffnessView edges;  ///< elasticity::EdgeStiffness

  PHYSGEN_FUNCTION void operator()(SingleObject auto edge) const {
    using Real = typename EdgeStiffnessView::Precision;
    using Vector = Vector3<double>;
    const auto names = ends[edge].nodes();
    const index_t m = names[0];
    const Vector w = edge_faces.sum(edge, Vector(Vector::Zero()), [&](const auto& entry) -> Vector {
      const auto face = faces[NodeTetEntry::element(entry)];
      const int k = NodeTetEntry::local(entry), i = k == 2 ? 0 : k + 1;
      const detail::FaceCorners x(face, positions, detail::FaceCorners::corner(face, positions, k));
      const index_t first = face.nodes()[i];
      const double factor = double(face.pressure()) * load / (first == m ? -12 : 12);
      return (x.a + x.b + x.c) * factor;  // that of the corner k is 0
    });
    Matrix3<Real> E = edges[edge].E();
    E(0, 1) -= static_cast<Real>(w[2]), E(1, 0) += static_cast<Real>(w[2]);
    E(0, 2) += static_cast<Real>(w[1]), E(2, 0) -= static_cast<Real>(w[1]);
    E(1, 2) -= static_cast<Real>(w[0]), E(2, 1) += static_cast<Real>(w[0]);
    edges[edge].E() = E;
  }
};

}  // namespace physgen::fem
