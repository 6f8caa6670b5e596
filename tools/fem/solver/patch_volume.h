// Kernels of volumes averaged over patches of tets (mean dilatation), against locking at Poisson's ratios near 1/2: the
// energy is sum V psi_shear(F) over tets + sum V_p U(T_p) over patches, T_p being current over rest volume. The tangent
// uses a linearised pressure, as in a mixed method that has been condensed; the forces are those of the energy.
#pragma once

#include <fem/kernels/tet.h>
#include <fem/solver/material_split.h>
#include <physgen/kernel.h>
#include <physgen/rows.h>

namespace physgen::fem {

/// Volumes [m^3] and T of patches, their pressures, and the tangent k g g^T. Returns their energy [J].
template <class PatchTets, class TetView, class RestView, class PositionView, class PatchView, class TangentView>
struct EvaluatePatches {
  using Scalar = typename PatchView::Precision;
  VolumeLaw law;
  Scalar modulus;          ///< lambda or kappa [Pa]
  bool restart;            ///< the linearised pressure begins anew, at that of the forces
  PatchTets patch_tets;    ///< Rows of quasistatic::PatchTet
  TetView tets;            ///< elasticity::Tet
  RestView rest;           ///< elasticity::NodePosition, at rest
  PositionView positions;  ///< elasticity::NodePosition, current
  PatchView patches;       ///< quasistatic::VolumePatch, of which `linearised` is read unless restart; written
  TangentView tangent;     ///< quasistatic::PatchTangent, written

  PHYSGEN_FUNCTION Scalar operator()(index_t p) const {
    using Real = typename TangentView::Precision;
    using Vector = Vector3<Scalar>;
    const auto g = tangent[p].g();
    g.setZero();
    Scalar volume = 0, current = 0;
    patch_tets.for_each(p, [&](const auto& entry, bool /*active*/) {
      const index_t tet = entry.tet();
      const int slots = entry.slots();
      const auto rest_of = [this](auto node) { return rest[node].x().get(); };
      const auto current_of = [this](auto node) { return positions[node].x().get(); };
      const Matrix3<Scalar> dm = detail::edge_matrix<Scalar>(tets, tet, rest_of);
      const Matrix3<Scalar> ds = detail::edge_matrix<Scalar>(tets, tet, current_of);
      volume += dot3<Scalar>(dm.col(0), cross3<Scalar>(dm.col(1), dm.col(2)));
      const Vector faces[3] = {cross3<Scalar>(ds.col(1), ds.col(2)), cross3<Scalar>(ds.col(2), ds.col(0)),
                               cross3<Scalar>(ds.col(0), ds.col(1))};
      current += dot3<Scalar>(ds.col(0), faces[0]);
      const Vector others = faces[0] + faces[1] + faces[2];
      add_to_slot(g, slots & 7, -others);
      for (int c = 0; c < 3; ++c) add_to_slot(g, slots >> (3 * c + 3) & 7, faces[c]);
    });
    volume /= Scalar(6);
    current /= Scalar(6);
    const Scalar T = current / volume;
    const bool is_log = law == VolumeLaw::logarithmic;
    const Scalar strain = is_log ? math::log(T) : (current - volume) / volume;
    const Scalar stress = modulus * strain;  // U'(T) T, or U'(T)
    const auto patch = patches[p];
    const Scalar linearised = restart ? stress : Scalar(patch.linearised());
    patch.volume() = volume;
    patch.ratio() = T;
    patch.pressure() = is_log ? stress / T : stress;
    patch.linearised() = linearised;
    patch.tangent_pressure() = is_log ? linearised / T : linearised;
    const Scalar k = is_log ? (modulus - linearised) / (T * T * volume) : modulus / volume;
    tangent[p].k() = static_cast<Real>(k);
    return Scalar(0.5) * volume * stress * strain;
  }

 private:
  /// g(slot) += value / 6
  template <class Field>
  PHYSGEN_FUNCTION static void add_to_slot(const Field& g, int slot, const Vector3<Scalar>& value) {
    using Real = typename TangentView::Precision;
    for (int k = 0; k < 3; ++k) g[3 * slot + k] += static_cast<Real>(value[k] / Scalar(6));
  }
};
template <class... Arguments>
EvaluatePatches(VolumeLaw, double, bool, Arguments...) -> EvaluatePatches<Arguments...>;

/// Moves the linearised pressure along with a step dx that Newton's method takes from the state of the last
/// EvaluatePatches.
template <class PatchView, class NodesView, class TangentView, class DisplacementView>
struct AdvancePatches {
  using Scalar = typename PatchView::Precision;
  VolumeLaw law;
  Scalar modulus;                  ///< lambda or kappa [Pa]
  PatchView patches;               ///< quasistatic::VolumePatch
  NodesView nodes;                 ///< quasistatic::PatchNodes
  TangentView tangent;             ///< quasistatic::PatchTangent
  DisplacementView displacements;  ///< elasticity::NodeDisplacement: dx

  PHYSGEN_FUNCTION void operator()(index_t p) const {
    Scalar change = 0;  // g . dx
    const auto names = nodes[p].nodes();
    const auto g = tangent[p].g();
    for (int slot = 0; slot < 8; ++slot) {
      const index_t node = names[slot];
      const auto dx = displacements[node].dx();
      for (int k = 0; k < 3; ++k) change += Scalar(g[3 * slot + k]) * Scalar(dx[k]);
    }
    const auto patch = patches[p];
    const Scalar T = patch.ratio(), volume = patch.volume();
    const Scalar full = law == VolumeLaw::logarithmic ? modulus * (math::log(T) + change / (volume * T))
                                                      : modulus * ((T - Scalar(1)) + change / volume);
    patch.before() = Scalar(patch.linearised());
    patch.full() = full;
    patch.linearised() = full;
  }
};
template <class... Arguments>
AdvancePatches(VolumeLaw, double, Arguments...) -> AdvancePatches<Arguments...>;

/// The same, along a part of the step. @pre AdvancePatches has been run for all of it
template <class PatchView>
struct ShortenPatches {
  using Scalar = typename PatchView::Precision;
  Scalar length;      ///< 0 to 1
  PatchView patches;  ///< quasistatic::VolumePatch

  PHYSGEN_FUNCTION void operator()(index_t p) const {
    const auto patch = patches[p];
    const Scalar before = patch.before(), full = patch.full();
    patch.linearised() = before + length * (full - before);
  }
};
template <class View>
ShortenPatches(double, View) -> ShortenPatches<View>;

/// A patch begins with the linearised pressure that the coarser level has found where it lies.
template <class ParentView, class CoarseView, class PatchView>
struct InjectPressure {
  using Scalar = typename PatchView::Precision;
  ParentView parents;  ///< quasistatic::PatchParent
  CoarseView coarse;   ///< quasistatic::VolumePatch
  PatchView patches;   ///< quasistatic::VolumePatch

  PHYSGEN_FUNCTION void operator()(index_t p) const {
    const index_t parent = parents[p].patch();
    patches[p].linearised() = Scalar(coarse[parent].linearised());
  }
};
template <class... Views>
InjectPressure(Views...) -> InjectPressure<Views...>;

}  // namespace physgen::fem
