// The common part of patches of tets and nodes where volumes are averaged: from a mean volume to its pressures, its
// energy and the stiffness k, and how the linearised pressure moves along.
#pragma once

#include <fem/kernels/tet.h>
#include <fem/solver/elastic/tet_chunks.h>
#include <fem/solver/material_split.h>
#include <physgen/kernel.h>

namespace physgen::fem {

namespace detail {

/// Six times a tet's volumes, and the change of the current one with its corners.
template <class Scalar>
struct TetVolume {
  Scalar rest, current;         ///< [m^3]
  Vector3<Scalar> j, k, l;      ///< with the second, third and fourth corner [m^2]
  Vector3<Scalar> minus_first;  ///< minus that with the first
};
/// @param rest, positions views of elasticity::NodePosition
template <class Scalar, class TetView, class RestView, class PositionView>
PHYSGEN_FUNCTION inline TetVolume<Scalar> tet_volume(const TetView& tets, const RestView& rest,
                                                     const PositionView& positions, SingleObject auto tet) {
  const auto rest_of = [&](auto node) { return rest[node].x().get(); };
  const auto current_of = [&](auto node) { return positions[node].x().get(); };
  const Matrix3<Scalar> dm = edge_matrix<Scalar>(tets, tet, rest_of);
  const Matrix3<Scalar> ds = edge_matrix<Scalar>(tets, tet, current_of);
  TetVolume<Scalar> volume;
  volume.rest = dot3<Scalar>(dm.col(0), cross3<Scalar>(dm.col(1), dm.col(2)));
  volume.j = cross3<Scalar>(ds.col(1), ds.col(2));
  volume.k = cross3<Scalar>(ds.col(2), ds.col(0));
  volume.l = cross3<Scalar>(ds.col(0), ds.col(1));
  volume.minus_first = volume.j + volume.k + volume.l;
  volume.current = dot3<Scalar>(ds.col(0), volume.j);
  return volume;
}

/// Stores a mean volume and its pressures.
/// @param volume, current at rest and now [m^3]
/// @param restart the linearised pressure begins anew, at that of the forces; else it is read
/// @param mean quasistatic::MeanVolume
/// @return U''(T) / volume, or its linearised form [N/m^5]: the resistance to the change of the volume
template <class Scalar, class MeanVolumeRef>
PHYSGEN_FUNCTION inline Scalar respond(VolumeLaw law, Scalar modulus, bool restart, Scalar volume, Scalar current,
                                       const MeanVolumeRef& mean) {
  const Scalar T = current / volume;
  const bool is_log = law == VolumeLaw::logarithmic;
  const Scalar strain = is_log ? math::log(T) : (current - volume) / volume;
  const Scalar stress = modulus * strain;  // U'(T) T, or U'(T)
  const Scalar linearised = restart ? stress : Scalar(mean.linearised());
  mean.volume() = volume;
  mean.ratio() = T;
  mean.pressure() = is_log ? stress / T : stress;
  mean.linearised() = linearised;
  mean.tangent_pressure() = is_log ? linearised / T : linearised;
  return is_log ? (modulus - linearised) / (T * T * volume) : modulus / volume;
}

/// Moves the linearised pressure along with a step that changes the mean volume by `change` [m^3], to first order.
template <class Scalar, class MeanVolumeRef>
PHYSGEN_FUNCTION inline void advance(VolumeLaw law, Scalar modulus, Scalar change, const MeanVolumeRef& mean) {
  const Scalar T = mean.ratio(), volume = mean.volume();
  const Scalar full = law == VolumeLaw::logarithmic ? modulus * (math::log(T) + change / (volume * T))
                                                    : modulus * ((T - Scalar(1)) + change / volume);
  mean.before() = Scalar(mean.linearised());
  mean.full() = full;
  mean.linearised() = full;
}

}  // namespace detail

/// Returns the energy [J] of a mean volume whose pressure has been stored: modulus/2 volume ln(T)^2, or (T - 1)^2.
template <class MeanVolumeView>
struct MeanVolumeEnergy {
  using Scalar = typename MeanVolumeView::Precision;
  MaterialRange range;  ///< of the material, whose volumes alone have this energy
  VolumeLaw law;
  Scalar modulus;          ///< lambda or kappa [Pa]
  MeanVolumeView volumes;  ///< quasistatic::MeanVolume

  PHYSGEN_FUNCTION Scalar operator()(SingleObject auto i) const {
    if (!range.has_volume(object_number(i))) return Scalar(0);
    const auto mean = volumes[i];
    const Scalar pressure = mean.pressure();
    const Scalar stress = law == VolumeLaw::logarithmic ? pressure * Scalar(mean.ratio()) : pressure;
    return modulus != Scalar(0) ? Scalar(0.5) * Scalar(mean.volume()) * stress * (stress / modulus) : Scalar(0);
  }
};

/// After the linearised pressures have been moved along with all of a step: along with a part of it.
template <class MeanVolumeView>
struct ShortenPressures {
  using Scalar = typename MeanVolumeView::Precision;
  Scalar length;           ///< 0 to 1
  MeanVolumeView volumes;  ///< quasistatic::MeanVolume

  PHYSGEN_FUNCTION void operator()(SingleObject auto v) const {
    const auto mean = volumes[v];
    const Scalar before = mean.before(), full = mean.full();
    mean.linearised() = before + length * (full - before);
  }
};

}  // namespace physgen::fem
