// Kernels: steps of conjugate gradients over node vectors, and what follows on the one object that holds their numbers.
// The system is K dx = -f with K = df/dx, negative definite over the free components: r = f + K dx is the force that is
// left, and the length of a step is (r . z) / -(p . K p).
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/scalar.h>
#include <fem/solver/free_part.h>
#include <fem/solver/settings.h>
#include <physgen/kernel.h>

namespace physgen::fem {

/// -(p . K p)
template <class DirectionView, class ProductView>
struct Curvature {
  using Scalar = typename ProductView::Precision;
  DirectionView direction;  ///< elasticity::NodeDisplacement: p
  ProductView product;      ///< elasticity::NodeForceDifferential: K p

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using S = lanes_t<Scalar, I>;
    const Vector3<S> p = direction[i].dx(), q = product[i].df();
    return -dot3<S>(p, q);
  }
};

/// alpha, from the curvature; of a solve that has ended 0, so that nothing moves any more.
template <class StateView>
struct SetLength {
  StateView state;  ///< quasistatic::LinearSolve

  PHYSGEN_FUNCTION void operator()(double curvature) const {
    const auto s = state[index_t{0}];
    const double rz = s.rz();
    const double alpha = rz / curvature;
    if (int{s.status()} != static_cast<int>(LinearStatus::running)) {
      s.alpha() = 0.0;
    } else if (!(curvature > 0) || !(alpha < 1e300)) {
      s.alpha() = 0.0;
      s.status() = static_cast<int>(curvature <= 0 ? LinearStatus::negative_curvature : LinearStatus::not_finite);
    } else {
      s.alpha() = alpha;
      s.iterations() += 1;
    }
  }
};

/// dx += alpha p, r += alpha K p in free components, and s r for the preconditioner.
template <class StateView, class ConstraintView, class ScaleView, class DirectionView, class ProductView,
          class StepView, class ResidualView, class ScaledView>
struct TakeStep {
  using Scalar = typename ResidualView::Precision;
  StateView state;             ///< quasistatic::LinearSolve
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  ScaleView scales;            ///< quasistatic::NodeScale: s
  DirectionView direction;     ///< elasticity::NodeDisplacement: p, 0 in prescribed components
  ProductView product;         ///< elasticity::NodeForceDifferential: K p
  StepView steps;              ///< elasticity::NodeDisplacement: dx
  ResidualView residual;       ///< elasticity::NodeForceDifferential: r
  ScaledView scaled;           ///< elasticity::NodeForceDifferential, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const double length = state[index_t{0}].alpha();
    const S alpha(static_cast<Scalar>(length));
    const Vector3<S> p = direction[i].dx(), dx = steps[i].dx(), r = residual[i].df(), Kp = product[i].df();
    const Vector3<S> next = r + detail::free_part<S>(Kp, constraints[i]) * alpha;
    steps[i].dx() = Vector3<S>(dx + p * alpha);
    residual[i].df() = next;
    scaled[i].df() = Vector3<S>(next * S(scales[i].scale()));
  }
};

/// p = s z + beta p, z being scaled, and the nodes' part of K p.
template <class StateView, class ScaleView, class CorrectionView, class NodeStiffnessView, class DirectionView,
          class ProductView>
struct TurnDirection {
  using Scalar = typename DirectionView::Precision;
  StateView state;              ///< quasistatic::LinearSolve
  ScaleView scales;             ///< quasistatic::NodeScale: s
  CorrectionView corrections;   ///< elasticity::NodeDisplacement: z
  NodeStiffnessView stiffness;  ///< elasticity::NodeStiffness: K
  DirectionView direction;      ///< elasticity::NodeDisplacement: p
  ProductView product;          ///< elasticity::NodeForceDifferential, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const double kept = state[index_t{0}].beta();
    const Vector3<S> z = corrections[i].dx(), p = direction[i].dx(), zero = Vector3<S>::Constant(S(Scalar(0)));
    const Vector3<S> next = z * S(scales[i].scale()) + p * S(static_cast<Scalar>(kept));
    const Matrix3<S> K = stiffness[i].K();
    direction[i].dx() = next;
    product[i].df() = multiply_add<S>(K, next, zero);
  }
};

/// p = s z + beta p, and K p = 0, to which a product is added.
template <class StateView, class ScaleView, class CorrectionView, class DirectionView, class ProductView>
struct TurnDirectionAlone {
  using Scalar = typename DirectionView::Precision;
  StateView state;             ///< quasistatic::LinearSolve
  ScaleView scales;            ///< quasistatic::NodeScale: s
  CorrectionView corrections;  ///< elasticity::NodeDisplacement: z
  DirectionView direction;     ///< elasticity::NodeDisplacement: p
  ProductView product;         ///< elasticity::NodeForceDifferential, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const double kept = state[index_t{0}].beta();
    const Vector3<S> z = corrections[i].dx(), p = direction[i].dx();
    direction[i].dx() = Vector3<S>(z * S(scales[i].scale()) + p * S(static_cast<Scalar>(kept)));
    product[i].df() = Vector3<S>(Vector3<S>::Constant(S(Scalar(0))));
  }
};

/// df = 0
template <class DifferentialView>
struct ClearDifferentials {
  using Scalar = typename DifferentialView::Precision;
  DifferentialView differentials;  ///< elasticity::NodeForceDifferential, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    differentials[i].df() = Vector3<S>(Vector3<S>::Constant(S(Scalar(0))));
  }
};

/// Whether a solve has ended.
template <class StateView>
struct HasEnded {
  StateView state;  ///< quasistatic::LinearSolve
  PHYSGEN_FUNCTION bool operator()() const {
    return int{state[index_t{0}].status()} != static_cast<int>(LinearStatus::running);
  }
};

/// z = s r: into scaled unknowns, where the preconditioner works.
template <class ScaleView, class ResidualView, class ScaledView>
struct ScaleResidual {
  using Scalar = typename ScaledView::Precision;
  ScaleView scales;       ///< quasistatic::NodeScale
  ResidualView residual;  ///< elasticity::NodeForceDifferential
  ScaledView scaled;      ///< elasticity::NodeForceDifferential, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Vector3<S> r = residual[i].df();
    scaled[i].df() = Vector3<S>(r * S(scales[i].scale()));
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
