// Splits materials into a part of the shear and a part U(J) of the volume, where they have such parts.
#pragma once

#include <fem/materials/material.h>

#include <utility>

namespace physgen::fem {

/// The volume's part of a material.
struct VolumeTerm {
  VolumeLaw law = VolumeLaw::logarithmic;
  double modulus = 0;  ///< [Pa]
};

template <class Material>
inline constexpr bool splits_volume = requires { Material::volume_law; };

/// Takes the volume's part out of a material, and returns it.
template <class Material>
VolumeTerm split_volume(Material& material) {
  static_assert(
      requires { material.volume_modulus(); },
      "a material with a volume_law needs volume_modulus(): materials/material.h says what that is");
  return {Material::volume_law,
          static_cast<double>(std::exchange(material.volume_modulus(), typename Material::Scalar(0)))};
}

}  // namespace physgen::fem
