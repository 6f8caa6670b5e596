// Splits materials into a part of the shear and a part U(J) of the volume, where they have such parts.
#pragma once

#include <fem/materials/fixed_corotated.h>
#include <fem/materials/mooney_rivlin.h>
#include <fem/materials/neo_hookean.h>
#include <fem/materials/stable_neo_hookean.h>

#include <utility>

namespace physgen::fem {

/// U(T) of a material: half its modulus times the square of ln T, or of T - 1.
enum class VolumeLaw { logarithmic, quadratic };

/// The volume's part of a material.
struct VolumeTerm {
  VolumeLaw law = VolumeLaw::logarithmic;
  double modulus = 0;  ///< [Pa]
};

/// Takes the volume's part out of a material, and returns it.
template <class Real>
VolumeTerm split_volume(NeoHookean<Real>& material) {
  return {VolumeLaw::logarithmic, static_cast<double>(std::exchange(material.lambda, Real(0)))};
}
template <class Real>
VolumeTerm split_volume(StableNeoHookean<Real>& material) {
  return {VolumeLaw::quadratic, static_cast<double>(std::exchange(material.lambda, Real(0)))};
}
template <class Real>
VolumeTerm split_volume(FixedCorotated<Real>& material) {
  return {VolumeLaw::quadratic, static_cast<double>(std::exchange(material.lambda, Real(0)))};
}
template <class Real>
VolumeTerm split_volume(MooneyRivlin<Real>& material) {
  return {VolumeLaw::logarithmic, static_cast<double>(std::exchange(material.kappa, Real(0)))};
}

template <class Material>
inline constexpr bool splits_volume = requires(Material& material) { split_volume(material); };

}  // namespace physgen::fem
