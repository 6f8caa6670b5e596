// Kernels of volumes averaged over patches of tets (mean dilatation), against locking at Poisson's ratios near 1/2: the
// energy is sum V psi_shear(F) over tets + sum V_p U(T_p) over patches, T_p being current over rest volume. The tangent
// uses a linearised pressure, as in a mixed method that has been condensed; the forces are those of the energy.
#pragma once

#include <fem/solver/elastic/mean_volume.h>
#include <physgen/rows.h>

namespace physgen::fem {

/// Volumes [m^3] and T of patches, their pressures, and the tangent k g g^T.
template <class PatchTets, class TetView, class RestView, class PositionView, class MeanVolumeView, class TangentView>
struct EvaluatePatches {
  using Scalar = typename MeanVolumeView::Precision;
  MaterialRange range;  ///< of the material, whose patches alone are evaluated
  VolumeLaw law;
  Scalar modulus;          ///< lambda or kappa [Pa]
  bool restart;            ///< the linearised pressure begins anew, at that of the forces
  PatchTets patch_tets;    ///< Rows of quasistatic::PatchTet
  TetView tets;            ///< elasticity::Tet
  RestView rest;           ///< elasticity::NodePosition, at rest
  PositionView positions;  ///< elasticity::NodePosition, current
  MeanVolumeView volumes;  ///< quasistatic::MeanVolume, of which `linearised` is read unless restart; written
  TangentView tangent;     ///< quasistatic::PatchTangent, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto p) const {
    if (!range.has_volume(object_number(p))) return;
    using Real = typename TangentView::Precision;
    const auto g = tangent[p].g();
    g.setZero();
    Scalar volume = 0, current = 0;
    patch_tets.for_each(p, [&](const auto& entry, bool /*active*/) {
      const int slots = entry.slots();
      const detail::TetVolume<Scalar> tet = detail::tet_volume<Scalar>(tets, rest, positions, index_t{entry.tet()});
      volume += tet.rest;
      current += tet.current;
      add_to_slot(g, slots & 7, -tet.minus_first);
      add_to_slot(g, slots >> 3 & 7, tet.j);
      add_to_slot(g, slots >> 6 & 7, tet.k);
      add_to_slot(g, slots >> 9 & 7, tet.l);
    });
    tangent[p].k() = static_cast<Real>(
        detail::respond<Scalar>(law, modulus, restart, volume / Scalar(6), current / Scalar(6), volumes[p]));
  }

 private:
  /// g(slot) += value / 6
  template <class Field>
  PHYSGEN_FUNCTION static void add_to_slot(const Field& g, int slot, const Vector3<Scalar>& value) {
    using Real = typename TangentView::Precision;
    for (int k = 0; k < 3; ++k) g[3 * slot + k] += static_cast<Real>(value[k] / Scalar(6));
  }
};

/// Moves the linearised pressure along with a step dx that Newton's method takes from the state of the last
/// EvaluatePatches.
template <class MeanVolumeView, class NodesView, class TangentView, class DisplacementView>
struct AdvancePatches {
  using Scalar = typename MeanVolumeView::Precision;
  MaterialRange range;  ///< of the material, whose patches alone move
  VolumeLaw law;
  Scalar modulus;                  ///< lambda or kappa [Pa]
  MeanVolumeView volumes;          ///< quasistatic::MeanVolume
  NodesView nodes;                 ///< quasistatic::PatchNodes
  TangentView tangent;             ///< quasistatic::PatchTangent
  DisplacementView displacements;  ///< elasticity::NodeDisplacement: dx

  PHYSGEN_FUNCTION void operator()(SingleObject auto p) const {
    if (!range.has_volume(object_number(p))) return;
    Scalar change = 0;  // g . dx
    const auto names = nodes[p].nodes();
    const auto g = tangent[p].g();
    for (int slot = 0; slot < 8; ++slot) {
      const index_t node = names[slot];
      const auto dx = displacements[node].dx();
      for (int k = 0; k < 3; ++k) change += Scalar(g[3 * slot + k]) * Scalar(dx[k]);
    }
    detail::advance<Scalar>(law, modulus, change, volumes[p]);
  }
};

/// A patch begins with the linearised pressure that the coarser level has found where it lies.
template <class ParentView, class CoarseView, class MeanVolumeView>
struct InjectPatchPressures {
  using Scalar = typename MeanVolumeView::Precision;
  ParentView parents;      ///< quasistatic::PatchParent
  CoarseView coarse;       ///< quasistatic::MeanVolume
  MeanVolumeView volumes;  ///< quasistatic::MeanVolume

  PHYSGEN_FUNCTION void operator()(SingleObject auto p) const {
    const index_t parent = parents[p].patch();
    volumes[p].linearised() = Scalar(coarse[parent].linearised());
  }
};

}  // namespace physgen::fem
