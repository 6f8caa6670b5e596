// Kernels from node vectors to elements: the rest shape (once per scene), the deformation gradient F = Ds Dm^-1, and
// its differential along a displacement.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/kernels/tet.h>

namespace physgen::fem {

/// Rest shape of each tet from the nodes' rest positions: Dm^-1 [1/m] and volume [m^3].
/// @pre det(Dm) > 0
template <class TetView, class PositionView, class RestView>
struct ComputeRestShape {
  using Scalar = typename RestView::Precision;
  TetView tets;            ///< elasticity::Tet
  PositionView positions;  ///< elasticity::NodePosition, at rest
  RestView rest;           ///< elasticity::RestShape, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> dm = detail::edge_matrix<Scalar>(tets, i, [this](auto node) { return positions[node].x().get(); });
    const Vector3<S> a = dm.col(0), b = dm.col(1), c = dm.col(2);
    const Vector3<S> bc = cross3<S>(b, c), ca = cross3<S>(c, a), ab = cross3<S>(a, b);
    const S determinant = dot3<S>(a, bc);
    const S inverse = S(Scalar(1)) / determinant;
    Matrix3<S> dm_inverse;
    dm_inverse.row(0) = (bc * inverse).transpose();
    dm_inverse.row(1) = (ca * inverse).transpose();
    dm_inverse.row(2) = (ab * inverse).transpose();
    const auto out = rest[i];
    out.dm_inverse() = dm_inverse;
    out.volume() = determinant / S(Scalar(6));
  }
};

/// F = Ds Dm^-1.
template <class TetView, class PositionView, class RestView, class GradientView>
struct ComputeDeformationGradient {
  using Scalar = typename GradientView::Precision;
  TetView tets;            ///< elasticity::Tet
  PositionView positions;  ///< elasticity::NodePosition, current
  RestView rest;           ///< elasticity::RestShape
  GradientView gradient;   ///< elasticity::DeformationGradient, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> ds = detail::edge_matrix<Scalar>(tets, i, [this](auto node) { return positions[node].x().get(); });
    const Matrix3<S> dm_inverse = rest[i].dm_inverse();
    gradient[i].F() = multiply<S>(ds, dm_inverse);
  }
};

/// dF = Ds(dx) Dm^-1.
template <class TetView, class DisplacementView, class RestView, class DifferentialView>
struct ComputeDeformationGradientDifferential {
  using Scalar = typename DifferentialView::Precision;
  TetView tets;                    ///< elasticity::Tet
  DisplacementView displacements;  ///< elasticity::NodeDisplacement
  RestView rest;                   ///< elasticity::RestShape
  DifferentialView differential;   ///< elasticity::DeformationGradientDifferential, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> ds =
        detail::edge_matrix<Scalar>(tets, i, [this](auto node) { return displacements[node].dx().get(); });
    const Matrix3<S> dm_inverse = rest[i].dm_inverse();
    differential[i].dF() = multiply<S>(ds, dm_inverse);
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
