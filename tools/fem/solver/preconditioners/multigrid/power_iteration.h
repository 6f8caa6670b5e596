// Kernels: power iterations for the largest eigenvalue of -D K, the inverses of the nodes' blocks times the stiffness.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/solver/levels/scattered.h>
#include <fem/solver/preconditioners/multigrid/smoother.h>
#include <physgen/kernels/object_numbers.h>

namespace physgen::fem {

/// A vector that has a part of every eigenvector, most likely: numbers in [-1, 1] that depend on the node alone.
template <class DirectionView>
struct ScatterDirection {
  using Scalar = typename DirectionView::Precision;
  ObjectNumbers numbers;    ///< of nodes
  DirectionView direction;  ///< elasticity::NodeDisplacement, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    for (int k = 0; k < 3; ++k)
      direction[node].dx()[k] = static_cast<Scalar>(detail::scattered(3 * numbers.of(node) + k, 0));
  }
};

/// v = -D K v, unscaled; returns |v|^2 of it.
template <class InverseView, class ProductView, class DirectionView>
struct IteratePower {
  using Scalar = typename DirectionView::Precision;
  InverseView inverse;      ///< quasistatic::NodeInverse
  ProductView product;      ///< elasticity::NodeForceDifferential: K v
  DirectionView direction;  ///< elasticity::NodeDisplacement: v, written

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using S = lanes_t<Scalar, I>;
    const Vector3<S> v = -detail::block_jacobi<S>(inverse, product, i);
    direction[i].dx() = v;
    return dot3<S>(v, v);
  }
};

/// |v|^2
template <class DirectionView>
struct SquaredLength {
  using Scalar = typename DirectionView::Precision;
  DirectionView direction;  ///< elasticity::NodeDisplacement: v

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using S = lanes_t<Scalar, I>;
    const Vector3<S> v = direction[i].dx();
    return dot3<S>(v, v);
  }
};

/// v / |v|, |v| being the length that is kept.
template <class SmootherView, class DirectionView>
struct NormalisePower {
  using Scalar = typename DirectionView::Precision;
  SmootherView smoother;    ///< quasistatic::Smoother
  DirectionView direction;  ///< elasticity::NodeDisplacement: v

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const double length = smoother[index_t{0}].length();
    direction[i].dx() *= S(static_cast<Scalar>(length > 0 ? 1 / length : 0.0));
  }
};

/// Keeps the length of v.
template <class SmootherView>
struct StoreLength {
  SmootherView smoother;  ///< quasistatic::Smoother
  PHYSGEN_FUNCTION void operator()(double square) const { smoother[index_t{0}].length() = math::sqrt(square); }
};

/// The estimate: the factor by which v has grown in one iteration.
template <class SmootherView>
struct StoreLargest {
  SmootherView smoother;  ///< quasistatic::Smoother
  PHYSGEN_FUNCTION void operator()(double square) const {
    const auto s = smoother[index_t{0}];
    const double length = math::sqrt(square), before = s.length();
    s.largest() = before > 0 ? length / before : 0.0;
    s.length() = length;
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
