// Kernel: the stress of each tet, for output.
#pragma once

#include <fem/solver/elastic/evaluate_tets.h>

namespace physgen::fem {

/// P = dpsi/dF, with the pressure of the tet where volumes are averaged.
template <class Material, class Pressures, class TetView, class RestView, class PositionView, class StressView>
struct EvaluateStress {
  using Scalar = typename StressView::Precision;
  MaterialRange range;     ///< of the material, whose tets alone have this stress
  Material material;       ///< in Scalar
  Pressures pressures;     ///< NoMeanPressures, PatchPressures or NodePressures
  TetView tets;            ///< elasticity::Tet
  RestView rest;           ///< elasticity::NodePosition, at rest
  PositionView positions;  ///< elasticity::NodePosition, current
  StressView stresses;     ///< elasticity::Stress, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto t) const {
    using S = Scalar;
    if (!range.has_tet(object_number(t))) return;
    const detail::DeformedTet<S> tet = detail::deformed_tet<Scalar>(tets, rest, positions, t);
    Vector3<S> g = material.stress(tet.f.s);
    if constexpr (Pressures::averages) {
      const S pressure = pressures.template of<S>(t).pressure;
      g = detail::with_pressure<S>(g, pressure, tet.f.s);
    }
    Matrix3<S> ug;  // U diag(g)
    for (int c = 0; c < 3; ++c) ug.col(c) = tet.f.U.col(c) * g[c];
    stresses[t].P() = multiply_transpose<S>(ug, tet.f.V);
  }
};

}  // namespace physgen::fem
