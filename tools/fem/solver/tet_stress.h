// Kernel: the stress of each tet, for output.
#pragma once

#include <fem/solver/evaluate_tets.h>

namespace physgen::fem {

/// P = dpsi/dF, with the pressure of the tet's patch where patches average the volume.
template <class Material, class Patches, class TetView, class RestView, class PositionView, class StressView>
struct EvaluateStress {
  using Scalar = typename StressView::Precision;
  Material material;       ///< in Scalar
  Patches patches;         ///< NoPatches or PatchPressures
  TetView tets;            ///< elasticity::Tet
  RestView rest;           ///< elasticity::NodePosition, at rest
  PositionView positions;  ///< elasticity::NodePosition, current
  StressView stresses;     ///< elasticity::Stress, written

  PHYSGEN_FUNCTION void operator()(index_t i) const {
    using S = Scalar;
    const Matrix3<S> dm = detail::edge_matrix<Scalar>(tets, i, [this](auto node) { return rest[node].x().get(); });
    const Matrix3<S> ds = detail::edge_matrix<Scalar>(tets, i, [this](auto node) { return positions[node].x().get(); });
    const Svd<S> f = svd(multiply<S>(ds, detail::tet_shape<S>(dm).dm_inverse));
    Vector3<S> g = material.stress(f.s);
    if constexpr (Patches::averages) {
      const index_t p = patches.tets[i].patch();
      const S pressure = patches.patches[p].pressure();
      g[0] = fma(pressure, f.s[1] * f.s[2], g[0]);
      g[1] = fma(pressure, f.s[0] * f.s[2], g[1]);
      g[2] = fma(pressure, f.s[0] * f.s[1], g[2]);
    }
    Matrix3<S> ug;  // U diag(g)
    for (int c = 0; c < 3; ++c) ug.col(c) = f.U.col(c) * g[c];
    stresses[i].P() = multiply_transpose<S>(ug, f.V);
  }
};
template <class... Arguments>
EvaluateStress(Arguments...) -> EvaluateStress<Arguments...>;

}  // namespace physgen::fem
