// Kernels: Chebyshev polynomials of block Jacobi on one level, in scaled unknowns. K is df/dx, negative
// semidefinite: -D K has positive eigenvalues, and r = f + K z is the force that a correction z leaves.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/scalar.h>
#include <fem/solver/preconditioners/jacobi/block_jacobi.h>
#include <physgen/kernel.h>

namespace physgen::fem {

namespace detail {

/// The interval of Chebyshev polynomials: [low, 1] times an estimate of the largest eigenvalue, which is raised by a
/// tenth since power iterations come from below.
template <class Scalar>
struct ChebyshevInterval {
  Scalar centre, radius;
  PHYSGEN_FUNCTION ChebyshevInterval(double largest, double low)
      : centre(static_cast<Scalar>(0.5 * (1 + low) * 1.1 * largest)),
        radius(static_cast<Scalar>(0.5 * (1 - low) * 1.1 * largest)) {}
};

}  // namespace detail

/// The part of the product with a direction d that a node has by itself: r += K d. That of edges follows, by
/// add_edges().
template <class S, class NodeStiffnessView, class ResidualView, class I>
PHYSGEN_FUNCTION inline void add_node_product(const NodeStiffnessView& stiffness, const ResidualView& residual, I i,
                                              const Vector3<S>& d) {
  const Matrix3<S> K = stiffness[i].K();
  const Vector3<S> r = residual[i].df();
  residual[i].df() = multiply_add<S>(K, d, r);
}

/// First step of a Chebyshev polynomial: direction d = D r / centre; the correction becomes d, or grows by d; r takes
/// in the nodes' part of K d, where it is wanted.
template <class NodeStiffnessView, class InverseView, class ResidualView, class SmootherView, class DirectionView,
          class CorrectionView>
struct BeginChebyshev {
  using Scalar = typename CorrectionView::Precision;
  bool grows;                   ///< whether there is a correction already
  bool product;                 ///< whether r is wanted after this step
  double low;                   ///< the lower end of the interval over the upper
  NodeStiffnessView stiffness;  ///< elasticity::NodeStiffness, scaled
  InverseView inverse;          ///< quasistatic::NodeInverse
  ResidualView residual;        ///< elasticity::NodeForceDifferential: r
  SmootherView smoother;        ///< quasistatic::Smoother
  DirectionView direction;      ///< elasticity::NodeDisplacement: d, written
  CorrectionView corrections;   ///< elasticity::NodeDisplacement: z

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const detail::ChebyshevInterval<Scalar> interval(smoother[index_t{0}].largest(), low);
    const Vector3<S> d = detail::block_jacobi<S>(inverse, residual, i) * S(Scalar(1) / interval.centre);
    if (grows) {
      corrections[i].dx() += d;
    } else {
      corrections[i].dx() = d;
    }
    if (product) {
      direction[i].dx() = d;
      add_node_product<S>(stiffness, residual, i, d);
    }
  }
};

/// Step k > 1 of the polynomial, with r after the step before.
template <class NodeStiffnessView, class InverseView, class ResidualView, class SmootherView, class DirectionView,
          class CorrectionView>
struct ContinueChebyshev {
  using Scalar = typename CorrectionView::Precision;
  int step;                     ///< 2, 3, ...
  bool product;                 ///< whether r is wanted after this step
  double low;                   ///< the lower end of the interval over the upper
  NodeStiffnessView stiffness;  ///< elasticity::NodeStiffness, scaled
  InverseView inverse;          ///< quasistatic::NodeInverse
  ResidualView residual;        ///< elasticity::NodeForceDifferential: r
  SmootherView smoother;        ///< quasistatic::Smoother
  DirectionView direction;      ///< elasticity::NodeDisplacement: d
  CorrectionView corrections;   ///< elasticity::NodeDisplacement: z

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const detail::ChebyshevInterval<Scalar> interval(smoother[index_t{0}].largest(), low);
    const Scalar sigma = interval.centre / interval.radius;
    Scalar rho = Scalar(1) / sigma, kept(0);
    for (int k = 2; k <= step; ++k) {
      const Scalar next = Scalar(1) / (Scalar(2) * sigma - rho);
      kept = rho * next;
      rho = next;
    }
    const Vector3<S> from_residual =
        detail::block_jacobi<S>(inverse, residual, i) * S(Scalar(2) * rho / interval.radius);
    const Vector3<S> d = Vector3<S>(direction[i].dx().get()) * S(kept) + from_residual;
    corrections[i].dx() += d;
    if (product) {
      direction[i].dx() = d;
      add_node_product<S>(stiffness, residual, i, d);
    }
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
