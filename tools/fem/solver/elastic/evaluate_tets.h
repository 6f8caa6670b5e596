// Kernels: what Newton's method wants of the tets, each from an SVD in double: energy and forces on the corners; the
// tangent, which may be kept in float; the change of volume.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/kernels/tet.h>
#include <fem/materials/definiteness.h>
#include <fem/numerics/svd.h>
#include <fem/solver/elastic/tet_chunks.h>
#include <physgen/kernel.h>

namespace physgen::fem {

using math::cast;
using math::select;

/// The tets' volume is part of the material.
struct NoMeanPressures {
  static constexpr bool averages = false;
};

/// The pressure of a tet whose volume is averaged with others.
template <class S>
struct TetPressure {
  S pressure;          ///< of the forces [Pa]
  S tangent_pressure;  ///< of the tangent [Pa]
};

/// The volume's part of the material is that of patches: the material given has none (lambda or kappa is 0), and each
/// tet has the pressure of its patch.
template <class TetPatchView, class MeanVolumeView>
struct PatchPressures {
  static constexpr bool averages = true;
  TetPatchView tets;       ///< quasistatic::TetPatch
  MeanVolumeView volumes;  ///< quasistatic::MeanVolume, per patch

  template <class S, class I>
  PHYSGEN_FUNCTION TetPressure<S> of(I tet) const {
    const lanes_t<std::int32_t, I> p = tets[tet].patch();
    const S pressure = volumes[p].pressure(), tangent_pressure = volumes[p].tangent_pressure();
    return {pressure, tangent_pressure};
  }
};

/// Negative eigenvalues of a tet's tangent: kept, or replaced by their absolute values. (Where zeros would replace
/// them, a body without support may be left with no stiffness at all.)
enum class TangentFilter { none, absolute };

namespace detail {

/// Dm^-1 [1/m] and volume [m^3] of a tet, from Dm.
template <class S>
struct TetShape {
  Matrix3<S> dm_inverse;
  S volume;
};
template <class S>
PHYSGEN_FUNCTION inline TetShape<S> tet_shape(const Matrix3<S>& dm) {
  using Real = RealOf<S>;
  const Vector3<S> a = dm.col(0), b = dm.col(1), c = dm.col(2);
  const Vector3<S> bc = cross3<S>(b, c), ca = cross3<S>(c, a), ab = cross3<S>(a, b);
  const S determinant = dot3<S>(a, bc);
  const S inverse = S(Real(1)) / determinant;
  TetShape<S> shape;
  shape.dm_inverse.row(0) = (bc * inverse).transpose();
  shape.dm_inverse.row(1) = (ca * inverse).transpose();
  shape.dm_inverse.row(2) = (ab * inverse).transpose();
  shape.volume = determinant / S(Real(6));
  return shape;
}

/// The derivative with that of `pressure` J added: q J has the stresses q s_b s_c.
template <class S>
PHYSGEN_FUNCTION inline PrincipalDerivative<S> with_pressure(PrincipalDerivative<S> d, const S& pressure,
                                                             const Vector3<S>& s) {
  const S q1 = pressure * s[0], q2 = pressure * s[1], q3 = pressure * s[2];
  d.h21 += q3, d.h31 += q2, d.h32 += q1;
  d.d21 -= q3, d.d31 -= q2, d.d32 -= q1;
  d.s21 += q3, d.s31 += q2, d.s32 += q1;
  return d;
}

/// A matrix in another precision.
template <class Real, class S>
PHYSGEN_FUNCTION inline auto cast_matrix(const Matrix3<S>& A) {
  Matrix3<std::remove_cvref_t<decltype(cast<Real>(A(0, 0)))>> result;
  PHYSGEN_UNROLL
  for (int k = 0; k < 9; ++k) result.data()[k] = cast<Real>(A.data()[k]);
  return result;
}

/// The beginning of the kernels of a tet: its shape at rest, and the SVD of F.
template <class S>
struct DeformedTet {
  TetShape<S> shape;
  Svd<S> f;

  /// By rows: V^T grad of corners j, k, l.
  [[nodiscard]] PHYSGEN_FUNCTION Matrix3<S> gradients() const { return multiply<S>(shape.dm_inverse, f.V); }
};
template <class Scalar, class TetView, class RestView, class PositionView, class I>
PHYSGEN_FUNCTION inline auto deformed_tet(const TetView& tets, const RestView& rest, const PositionView& positions,
                                          const I& tet) {
  using S = lanes_t<Scalar, I>;
  const Matrix3<S> dm = edge_matrix<Scalar>(tets, tet, [&](auto node) { return rest[node].x().get(); });
  const Matrix3<S> ds = edge_matrix<Scalar>(tets, tet, [&](auto node) { return positions[node].x().get(); });
  const TetShape<S> shape = tet_shape<S>(dm);
  return DeformedTet<S>{shape, svd(multiply<S>(ds, shape.dm_inverse))};
}

/// Principal stresses, with `pressure` dJ/ds.
template <class S>
PHYSGEN_FUNCTION inline Vector3<S> with_pressure(Vector3<S> g, const S& pressure, const Vector3<S>& s) {
  g[0] = fma(pressure, s[1] * s[2], g[0]);
  g[1] = fma(pressure, s[0] * s[2], g[1]);
  g[2] = fma(pressure, s[0] * s[1], g[2]);
  return g;
}

}  // namespace detail

/// Forces of a chunk of tets on their corners. Returns the energy [J] of those of its material: of the shear alone
/// where volumes are averaged. Called with the objects 0 .. chunk.tets() - 1 of `forces`.
template <class Material, class Pressures, class TetView, class RestView, class PositionView, class CornerView>
struct ComputeTetForces {
  using Scalar = typename CornerView::Precision;
  TetChunk chunk;
  Material material;       ///< in Scalar
  Pressures pressures;     ///< NoMeanPressures, PatchPressures or NodePressures
  TetView tets;            ///< elasticity::Tet
  RestView rest;           ///< elasticity::NodePosition, at rest
  PositionView positions;  ///< elasticity::NodePosition, current
  CornerView forces;       ///< elasticity::CornerForces of the chunk, written

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using S = lanes_t<Scalar, I>;
    const auto own = chunk.template own<S>(i);
    if (!any(i, own)) return S(Scalar(0));
    const auto t = object_of_part(chunk.first_tet, i);
    const detail::DeformedTet<S> tet = detail::deformed_tet<Scalar>(tets, rest, positions, t);
    Vector3<S> g = material.stress(tet.f.s);
    if constexpr (Pressures::averages) {
      const S pressure = pressures.template of<S>(t).pressure;
      g = detail::with_pressure<S>(g, pressure, tet.f.s);
    }
    const S minus_volume = -tet.shape.volume;
    Matrix3<S> ug;  // U diag(g)
    PHYSGEN_UNROLL
    for (int c = 0; c < 3; ++c) ug.col(c) = tet.f.U.col(c) * (g[c] * minus_volume);
    forces[i].G() = multiply_transpose<S>(ug, tet.gradients());
    return select(own, S(tet.shape.volume * material.energy(tet.f.s)), S(Scalar(0)));
  }
};

/// Tangents of a chunk of tets. Called with the objects 0 .. chunk.tets() - 1 of `tangent`.
template <class Material, class Pressures, class TetView, class RestView, class PositionView, class TangentView>
struct ComputeTetTangents {
  using Scalar = typename PositionView::Precision;
  TetChunk chunk;
  TangentFilter filter;
  Material material;       ///< in Scalar
  Pressures pressures;     ///< NoMeanPressures, PatchPressures or NodePressures
  TetView tets;            ///< elasticity::Tet
  RestView rest;           ///< elasticity::NodePosition, at rest
  PositionView positions;  ///< elasticity::NodePosition, current
  TangentView tangent;     ///< quasistatic::TetTangent of the chunk, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Real = typename TangentView::Precision;
    if (!any(i, chunk.template own<S>(i))) return;
    const auto t = object_of_part(chunk.first_tet, i);
    const detail::DeformedTet<S> tet = detail::deformed_tet<Scalar>(tets, rest, positions, t);
    PrincipalDerivative<S> d = material.derivative(tet.f.s);
    if constexpr (Pressures::averages) {
      const S pressure = pressures.template of<S>(t).tangent_pressure;
      d = detail::with_pressure<S>(d, pressure, tet.f.s);
    }
    if (filter == TangentFilter::absolute) d = AbsoluteEigenvalues{}(d);
    const S& volume = tet.shape.volume;
    const S half = volume * S(Scalar(0.5));
    const auto out = tangent[i];
    out.U() = detail::cast_matrix<Real>(tet.f.U);
    out.g() = detail::cast_matrix<Real>(Matrix3<S>(tet.gradients().transpose()));
    out.x1111() = cast<Real>(volume * d.h11);
    out.x2211() = cast<Real>(volume * d.h21);
    out.x3311() = cast<Real>(volume * d.h31);
    out.x2222() = cast<Real>(volume * d.h22);
    out.x3322() = cast<Real>(volume * d.h32);
    out.x3333() = cast<Real>(volume * d.h33);
    out.x2121() = cast<Real>(half * (d.d21 + d.s21));
    out.x2112() = cast<Real>(half * (d.d21 - d.s21));
    out.x3131() = cast<Real>(half * (d.d31 + d.s31));
    out.x3113() = cast<Real>(half * (d.d31 - d.s31));
    out.x3232() = cast<Real>(half * (d.d32 + d.s32));
    out.x3223() = cast<Real>(half * (d.d32 - d.s32));
  }
};

/// Current over rest volume of each tet: J.
template <class TetView, class RestView, class PositionView>
struct VolumeRatio {
  using Scalar = typename PositionView::Precision;
  TetView tets;            ///< elasticity::Tet
  RestView rest;           ///< elasticity::NodePosition, at rest
  PositionView positions;  ///< elasticity::NodePosition, current

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> dm = detail::edge_matrix<Scalar>(tets, i, [this](auto node) { return rest[node].x().get(); });
    const Matrix3<S> ds = detail::edge_matrix<Scalar>(tets, i, [this](auto node) { return positions[node].x().get(); });
    const auto determinant = [](const Matrix3<S>& m) { return dot3<S>(m.col(0), cross3<S>(m.col(1), m.col(2))); };
    return determinant(ds) / determinant(dm);
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
