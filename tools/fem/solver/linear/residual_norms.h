// Kernels: norms of the residual of conjugate gradients, and what follows on the object that holds a solve's numbers.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/scalar.h>
#include <fem/solver/settings.h>
#include <physgen/kernel.h>

namespace physgen::fem {

/// r . s z, z being scaled.
template <class ScaleView, class ResidualView, class CorrectionView>
struct ResidualNorm {
  using Scalar = typename ResidualView::Precision;
  ScaleView scales;            ///< quasistatic::NodeScale: s
  ResidualView residual;       ///< elasticity::NodeForceDifferential: r
  CorrectionView corrections;  ///< elasticity::NodeDisplacement: z

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using S = lanes_t<Scalar, I>;
    const Vector3<S> r = residual[i].df(), z = corrections[i].dx();
    return dot3<S>(r, z) * S(scales[i].scale());
  }
};

/// The first r . z. @pre tolerance is set
template <class StateView>
struct SetFirstNorm {
  StateView state;  ///< quasistatic::LinearSolve

  PHYSGEN_FUNCTION void operator()(double rz) const {
    const auto s = state[index_t{0}];
    s.rz() = rz;
    s.rz_first() = rz;
    s.alpha() = 0.0;
    s.beta() = 0.0;
    s.iterations() = 0;
    const LinearStatus status = rz > 0    ? (rz < 1e300 ? LinearStatus::running : LinearStatus::not_finite)
                                : rz == 0 ? LinearStatus::converged
                                          : (rz < 0 ? LinearStatus::negative_curvature : LinearStatus::not_finite);
    s.status() = static_cast<int>(status);
  }
};

namespace detail {

/// beta, and whether that was the last step.
template <class StateView>
PHYSGEN_FUNCTION inline void set_next_norm(const StateView& state, double rz, bool has_converged) {
  const auto s = state[index_t{0}];
  if (int{s.status()} != static_cast<int>(LinearStatus::running)) return;
  const double before = s.rz();
  s.rz() = rz;
  s.beta() = rz / before;
  if (has_converged) {
    s.status() = static_cast<int>(LinearStatus::converged);
  } else if (!(rz > 0)) {
    s.status() = static_cast<int>(rz < 0 ? LinearStatus::negative_curvature : LinearStatus::not_finite);
  }
}

}  // namespace detail

/// The next r . z, which says when a solve has converged.
template <class StateView>
struct SetNextNorm {
  StateView state;  ///< quasistatic::LinearSolve

  PHYSGEN_FUNCTION void operator()(double rz) const {
    const auto s = state[index_t{0}];
    const double first = s.rz_first(), tolerance = s.tolerance();
    detail::set_next_norm(state, rz, rz >= 0 && rz <= tolerance * tolerance * first);
  }
};

/// r . s z, z being scaled, and |r|^2.
template <class ScaleView, class ResidualView, class CorrectionView>
struct ResidualNorms {
  using Scalar = typename ResidualView::Precision;
  ScaleView scales;            ///< quasistatic::NodeScale: s
  ResidualView residual;       ///< elasticity::NodeForceDifferential: r
  CorrectionView corrections;  ///< elasticity::NodeDisplacement: z

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> Eigen::Matrix<lanes_t<Scalar, I>, 2, 1> {
    using S = lanes_t<Scalar, I>;
    const Vector3<S> r = residual[i].df(), z = corrections[i].dx();
    return {dot3<S>(r, z) * S(scales[i].scale()), dot3<S>(r, r)};
  }
};

/// The next r . z; |r| says when a solve has converged.
template <class StateView>
struct SetNextNorms {
  StateView state;  ///< quasistatic::LinearSolve
  double length;    ///< |r| at the end [N]

  PHYSGEN_FUNCTION void operator()(const Eigen::Matrix<double, 2, 1>& norms) const {
    detail::set_next_norm(state, norms[0], norms[1] <= length * length);
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
