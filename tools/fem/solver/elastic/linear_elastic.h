// Kernels of linear elasticity on tets, from the gradients of shape functions alone: neither an SVD nor a derivative in
// principal axes. The stress is sigma = lambda tr(H) 1 + mu (H + H^T) with H = grad u; forces are linear in u, so the
// product of the stiffness with a vector is the force of that vector.
#pragma once

#include <fem/kernels/tet.h>
#include <fem/materials/material.h>
#include <fem/solver/arrays/packed_rows.h>

namespace physgen::fem {

namespace detail {

/// The gradient of a corner's shape function [1/m]: a row of Dm^-1, or of corner 0 minus their sum.
template <class S>
PHYSGEN_FUNCTION inline Vector3<S> shape_gradient(const Matrix3<S>& dm_inverse, int corner) {
  if (corner == 0) return -(dm_inverse.row(0) + dm_inverse.row(1) + dm_inverse.row(2)).transpose();
  return dm_inverse.row(corner - 1).transpose();
}

/// Dm^-1 in another precision than it is stored in.
template <class S, class RestView>
PHYSGEN_FUNCTION inline Matrix3<S> rest_gradients(const RestView& rest, SingleObject auto tet) {
  const Matrix3<typename RestView::Precision> dm_inverse = rest[tet].dm_inverse();
  return dm_inverse.template cast<S>();
}

/// sigma [Pa]
template <class S>
PHYSGEN_FUNCTION inline Matrix3<S> linear_stress(S mu, S lambda, const Matrix3<S>& H) {
  Matrix3<S> sigma = (H + H.transpose()) * mu;
  const S pressure = lambda * (H(0, 0) + H(1, 1) + H(2, 2));
  for (int k = 0; k < 3; ++k) sigma(k, k) += pressure;
  return sigma;
}

/// A block of the stiffness, df(a)/du(b) for the shape gradients a and b: -volume (lambda a b^T + mu b a^T + mu a.b 1)
/// [N/m].
template <class S>
PHYSGEN_FUNCTION inline Matrix3<S> linear_block(S mu, S lambda, S volume, const Vector3<S>& a, const Vector3<S>& b) {
  const S shear = -volume * mu, bulk = -volume * lambda, same = shear * dot3<S>(a, b);
  Matrix3<S> K;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) K(r, c) = fma(bulk, a[r] * b[c], shear * (b[r] * a[c]));
    K(c, c) += same;
  }
  return K;
}

}  // namespace detail

/// The force on a node at displacements u: a sum over its tets in a fixed order, each formed where it is added, so that
/// nothing is stored per tet but its shape at rest.
/// @tparam Scalar in which it is computed
template <class Scalar, class TetView, class RestView, class NodeTets, class DisplacementView>
struct LinearForce {
  Scalar mu, lambda;               ///< [Pa]
  TetView tets;                    ///< elasticity::Tet
  RestView rest;                   ///< elasticity::RestShape
  NodeTets node_tets;              ///< Rows of NodeTetEntry
  DisplacementView displacements;  ///< elasticity::NodeDisplacement: u

  /// @return [N]
  PHYSGEN_FUNCTION Vector3<Scalar> operator()(SingleObject auto node) const {
    using Vector = Vector3<Scalar>;
    const auto u = [this](auto n) { return displacements[n].dx().get().template cast<Scalar>().eval(); };
    return node_tets.sum(node, Vector(Vector::Zero()), [&](const auto& entry) -> Vector {
      const index_t t = NodeTetEntry::element(entry);
      const Matrix3<Scalar> dm_inverse = detail::rest_gradients<Scalar>(rest, t);
      const Matrix3<Scalar> H = multiply<Scalar>(detail::edge_matrix<Scalar>(tets, t, u), dm_inverse);
      const Vector gradient = detail::shape_gradient<Scalar>(dm_inverse, NodeTetEntry::local(entry));
      const Vector traction =
          multiply_add<Scalar>(detail::linear_stress<Scalar>(mu, lambda, H), gradient, Vector(Vector::Zero()));
      return traction * -Scalar(rest[t].volume());
    });
  }
};
/// @param lame of the material
template <class Scalar, class... Views>
[[nodiscard]] auto linear_force(const LameParameters& lame, const Views&... views) {
  return LinearForce<Scalar, Views...>{static_cast<Scalar>(lame.mu), static_cast<Scalar>(lame.lambda), views...};
}

/// df = K dx, in the precision of df.
template <class Force, class DifferentialView>
struct MultiplyLinear {
  using Scalar = typename DifferentialView::Precision;
  Force force;                     ///< LinearForce at dx
  DifferentialView differentials;  ///< elasticity::NodeForceDifferential, written
  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const { differentials[node].df() = force(node); }
};

/// Elastic energy of a tet at displacements u [J].
template <class TetView, class RestView, class DisplacementView>
struct LinearEnergy {
  using Scalar = double;
  LameParameters lame;
  TetView tets;                    ///< elasticity::Tet
  RestView rest;                   ///< elasticity::RestShape
  DisplacementView displacements;  ///< elasticity::NodeDisplacement: u

  PHYSGEN_FUNCTION double operator()(SingleObject auto t) const {
    const auto u = [this](auto n) { return displacements[n].dx().get().template cast<double>().eval(); };
    const Matrix3<double> H =
        multiply<double>(detail::edge_matrix<double>(tets, t, u), detail::rest_gradients<double>(rest, t));
    const Matrix3<double> sigma = detail::linear_stress<double>(lame.mu, lame.lambda, H);
    double energy = 0;
    for (int k = 0; k < 9; ++k) energy += 0.5 * sigma.data()[k] * H.data()[k];
    return energy * double(rest[t].volume());
  }
};

/// Current over rest volume of a tet at displacements u: det(1 + H).
template <class TetView, class RestView, class DisplacementView>
struct DisplacedVolumeRatio {
  using Scalar = double;
  TetView tets;                    ///< elasticity::Tet
  RestView rest;                   ///< elasticity::RestShape
  DisplacementView displacements;  ///< elasticity::NodeDisplacement: u

  PHYSGEN_FUNCTION double operator()(SingleObject auto t) const {
    const auto u = [this](auto n) { return displacements[n].dx().get().template cast<double>().eval(); };
    const Matrix3<double> F =
        multiply<double>(detail::edge_matrix<double>(tets, t, u), detail::rest_gradients<double>(rest, t)) +
        Matrix3<double>::Identity();
    return dot3<double>(F.col(0), cross3<double>(F.col(1), F.col(2)));
  }
};

/// The stress of a tet at displacements u.
template <class TetView, class RestView, class DisplacementView, class StressView>
struct ComputeLinearStress {
  using Scalar = double;
  LameParameters lame;
  TetView tets;                    ///< elasticity::Tet
  RestView rest;                   ///< elasticity::RestShape
  DisplacementView displacements;  ///< elasticity::NodeDisplacement: u
  StressView stresses;             ///< elasticity::Stress, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto t) const {
    const auto u = [this](auto n) { return displacements[n].dx().get().template cast<double>().eval(); };
    const Matrix3<double> H =
        multiply<double>(detail::edge_matrix<double>(tets, t, u), detail::rest_gradients<double>(rest, t));
    stresses[t].P() = detail::linear_stress<double>(lame.mu, lame.lambda, H);
  }
};

/// E(m, n) = df(m)/du(n), as the sum over the edge's tets, straight from their gradients.
template <class RestView, class EdgeTets, class EdgeStiffnessView>
struct SumLinearEdgeStiffness {
  using Scalar = typename EdgeStiffnessView::Precision;
  LameParameters lame;
  RestView rest;            ///< elasticity::RestShape
  EdgeTets edge_tets;       ///< Rows of EdgeTetEntry
  EdgeStiffnessView edges;  ///< elasticity::EdgeStiffness, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto edge) const {
    using Matrix = Matrix3<Scalar>;
    const auto mu = static_cast<Scalar>(lame.mu), lambda = static_cast<Scalar>(lame.lambda);
    edges[edge].E() = edge_tets.sum(edge, Matrix(Matrix::Zero()), [&](const auto& entry) -> Matrix {
      const index_t t = EdgeTetEntry::element(entry);
      const int local = EdgeTetEntry::local(entry), forward = local < 6 ? local : local - 6;
      const int first = forward < 3 ? 0 : (forward < 5 ? 1 : 2);  // (0,1) (0,2) (0,3) (1,2) (1,3) (2,3)
      const int second = forward < 3 ? forward + 1 : (forward == 3 ? 2 : 3);
      const Matrix dm_inverse = detail::rest_gradients<Scalar>(rest, t);
      const Vector3<Scalar> a = detail::shape_gradient<Scalar>(dm_inverse, local < 6 ? first : second),
                            b = detail::shape_gradient<Scalar>(dm_inverse, local < 6 ? second : first);
      return detail::linear_block<Scalar>(mu, lambda, static_cast<Scalar>(double(rest[t].volume())), a, b);
    });
  }
};

/// K(node) = df(node)/du(node), for preconditioners of products that assemble no edges.
template <class RestView, class NodeTets, class NodeStiffnessView>
struct SumLinearNodeStiffness {
  using Scalar = typename NodeStiffnessView::Precision;
  LameParameters lame;
  RestView rest;            ///< elasticity::RestShape
  NodeTets node_tets;       ///< Rows of NodeTetEntry
  NodeStiffnessView nodes;  ///< elasticity::NodeStiffness, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Matrix = Matrix3<Scalar>;
    const auto mu = static_cast<Scalar>(lame.mu), lambda = static_cast<Scalar>(lame.lambda);
    nodes[node].K() = node_tets.sum(node, Matrix(Matrix::Zero()), [&](const auto& entry) -> Matrix {
      const index_t t = NodeTetEntry::element(entry);
      const Vector3<Scalar> g =
          detail::shape_gradient<Scalar>(detail::rest_gradients<Scalar>(rest, t), NodeTetEntry::local(entry));
      return detail::linear_block<Scalar>(mu, lambda, static_cast<Scalar>(double(rest[t].volume())), g, g);
    });
  }
};

}  // namespace physgen::fem
