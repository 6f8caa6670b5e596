// Kernels: singular value decomposition of deformation gradients, F = U diag(s) V^T, whole or in part. What is not
// written is not computed.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/svd.h>
#include <physgen/kernels/pack.h>
#include <physgen/kernels/quaternion.h>

namespace physgen::fem {

/// The number of sweeps that an SVD makes, as an argument of a kernel: `ComputeSvd{F.view(), svd.view(), Sweeps<3>{}}`.
template <int kCount>
struct Sweeps {};

/// See svd() for what is guaranteed.
template <class GradientView, class SvdView, int kSweeps = 4>
struct ComputeSvd {
  using Scalar = typename SvdView::Precision;
  GradientView gradient;  ///< elasticity::DeformationGradient
  SvdView decomposition;  ///< elasticity::DeformationSvd, written
  Sweeps<kSweeps> sweeps{};

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> F = gradient[i].F();
    const Svd<S> result = svd<kSweeps>(F);
    const auto out = decomposition[i];
    out.U() = result.U;
    out.V() = result.V;
    out.s() = result.s;
  }
};
template <class GradientView, class SvdView>
ComputeSvd(GradientView, SvdView) -> ComputeSvd<GradientView, SvdView>;
template <class GradientView, class SvdView, int kSweeps>
ComputeSvd(GradientView, SvdView, Sweeps<kSweeps>) -> ComputeSvd<GradientView, SvdView, kSweeps>;

/// Rotations as unit quaternions.
template <class GradientView, class SvdView>
struct ComputeQuaternionSvd {
  using Scalar = typename SvdView::Precision;
  GradientView gradient;  ///< elasticity::DeformationGradient
  SvdView decomposition;  ///< elasticity::QuaternionSvd, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> F = gradient[i].F();
    const Svd<S> result = svd(F);
    const auto out = decomposition[i];
    out.u() = unit_quaternion(result.U);
    out.v() = unit_quaternion(result.V);
    out.s() = result.s;
  }
};
template <class... Views>
ComputeQuaternionSvd(Views...) -> ComputeQuaternionSvd<Views...>;

/// Stands for a part of the SVD that is not wanted; what only that part needs is not computed.
struct Skip {};
inline constexpr Skip skip{};

namespace detail {

// Stores `part` into the only field of object(s) i.
template <class I, class Part>
PHYSGEN_FUNCTION inline void put_part(const Skip& /*view*/, I /*i*/, const Part& /*part*/) {}
template <class View, class I, class Part>
PHYSGEN_FUNCTION inline void put_part(const View& view, I i, const Part& part) {
  view.put(i, {part});
}

}  // namespace detail

/// U, s and V into arrays of their own, or `skip` in their place. All are views of types with one field only.
template <class GradientView, class LeftView, class StretchView, class RightView, int kSweeps = 4>
struct ComputeSvdParts {
  using Scalar = typename GradientView::Precision;
  GradientView gradients;  ///< such as elasticity::DeformationGradient
  LeftView left;           ///< such as elasticity::ElementRotation, or Skip; written
  StretchView stretches;   ///< such as elasticity::PrincipalStretches, or Skip; written
  RightView right;         ///< such as elasticity::ElementRotation, or Skip; written
  Sweeps<kSweeps> sweeps{};

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const auto [F] = gradients.get(i);
    const Svd<S> parts = svd<kSweeps>(Matrix3<S>(F));
    detail::put_part(left, i, parts.U);
    detail::put_part(stretches, i, parts.s);
    detail::put_part(right, i, parts.V);
  }
};
template <class GradientView, class LeftView, class StretchView, class RightView>
ComputeSvdParts(GradientView, LeftView, StretchView, RightView)
    -> ComputeSvdParts<GradientView, LeftView, StretchView, RightView>;
template <class GradientView, class LeftView, class StretchView, class RightView, int kSweeps>
ComputeSvdParts(GradientView, LeftView, StretchView, RightView, Sweeps<kSweeps>)
    -> ComputeSvdParts<GradientView, LeftView, StretchView, RightView, kSweeps>;

/// The polar rotation R = U V^T alone: F = R (V diag(s) V^T).
template <class GradientView, class RotationView>
struct ComputePolarRotation {
  using Scalar = typename RotationView::Precision;
  GradientView gradient;  ///< elasticity::DeformationGradient
  RotationView rotation;  ///< elasticity::ElementRotation, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> F = gradient[i].F();
    rotation[i].R() = polar_rotation(F);
  }
};
template <class... Views>
ComputePolarRotation(Views...) -> ComputePolarRotation<Views...>;

}  // namespace physgen::fem

#pragma pop_macro("I")
