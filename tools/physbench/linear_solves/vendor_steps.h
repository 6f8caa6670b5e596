// Kernels: the steps of conjugate gradients between two products of a vendor's library, as few passes over the vectors
// as there can be. Vectors have no gaps, as libraries want them, and are 0 in prescribed components, since the rows,
// columns and block inverses there are 0. Signs are those of fem/solver/levels/vector_steps.h.
#pragma once

#include <fem/solver/levels/vector_steps.h>

namespace physgen::bench {

/// Begins with dx = 0: r = f, z = D r, p = 0. Returns r . z.
template <class ForceView, class InverseView, class StepView, class ResidualView, class CorrectionView,
          class DirectionView>
struct BeginVendorSolve {
  using Scalar = typename ResidualView::Precision;
  ForceView forces;            ///< elasticity::NodeForceDifferential: f
  InverseView inverse;         ///< quasistatic::NodeInverse: D
  StepView steps;              ///< elasticity::NodeDisplacement: dx, written
  ResidualView residual;       ///< elasticity::NodeForceDifferential: r, written
  CorrectionView corrections;  ///< elasticity::NodeDisplacement: z, written
  DirectionView direction;     ///< elasticity::NodeDisplacement: p, written

  PHYSGEN_FUNCTION Scalar operator()(index_t node) const {
    using Vector = fem::Vector3<Scalar>;
    const Vector f = forces[node].df(), zero = Vector::Zero();
    const Vector z = fem::detail::block_jacobi<Scalar>(inverse, forces, node);
    steps[node].dx() = zero;
    direction[node].dx() = zero;
    residual[node].df() = f;
    corrections[node].dx() = z;
    return fem::dot3<Scalar>(f, z);
  }
};

/// p = z + beta p
template <class StateView, class CorrectionView, class DirectionView>
struct TurnVendorDirection {
  using Scalar = typename DirectionView::Precision;
  StateView state;             ///< quasistatic::LinearSolve
  CorrectionView corrections;  ///< elasticity::NodeDisplacement: z
  DirectionView direction;     ///< elasticity::NodeDisplacement: p

  PHYSGEN_FUNCTION void operator()(index_t node) const {
    using Vector = fem::Vector3<Scalar>;
    const double beta = state[index_t{0}].beta();
    const Vector z = corrections[node].dx(), p = direction[node].dx();
    direction[node].dx() = Vector(z + p * static_cast<Scalar>(beta));
  }
};

/// dx += alpha p, r += alpha K p, z = D r. Returns r . z and |r|^2.
template <class StateView, class DirectionView, class ProductView, class InverseView, class StepView,
          class ResidualView, class CorrectionView>
struct TakeVendorStep {
  using Scalar = typename ResidualView::Precision;
  StateView state;             ///< quasistatic::LinearSolve
  DirectionView direction;     ///< elasticity::NodeDisplacement: p
  ProductView product;         ///< elasticity::NodeForceDifferential: K p
  InverseView inverse;         ///< quasistatic::NodeInverse: D
  StepView steps;              ///< elasticity::NodeDisplacement: dx
  ResidualView residual;       ///< elasticity::NodeForceDifferential: r
  CorrectionView corrections;  ///< elasticity::NodeDisplacement: z, written

  PHYSGEN_FUNCTION Eigen::Matrix<Scalar, 2, 1> operator()(index_t node) const {
    using Vector = fem::Vector3<Scalar>;
    const double length = state[index_t{0}].alpha();
    const auto alpha = static_cast<Scalar>(length);
    const Vector p = direction[node].dx(), Kp = product[node].df(), dx = steps[node].dx(), r = residual[node].df();
    const fem::Matrix3<Scalar> D = inverse[node].D();
    const Vector next = r + Kp * alpha, zero = Vector::Zero();
    const Vector z = fem::multiply_add<Scalar>(D, next, zero);
    steps[node].dx() = Vector(dx + p * alpha);
    residual[node].df() = next;
    corrections[node].dx() = z;
    return {fem::dot3<Scalar>(next, z), fem::dot3<Scalar>(next, next)};
  }
};

/// The next r . z; it, or |r| where its length at the end is above 0, says when a solve has converged.
template <class StateView>
struct SetVendorNorms {
  StateView state;  ///< quasistatic::LinearSolve
  double length;    ///< |r| at the end [N], or 0
  PHYSGEN_FUNCTION void operator()(const Eigen::Matrix<double, 2, 1>& norms) const {
    if (length > 0) {
      fem::SetNextNorms{state, length}(norms);
    } else {
      fem::SetNextNorm{state}(norms[0]);
    }
  }
};

}  // namespace physgen::bench
