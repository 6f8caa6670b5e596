// The names by which a user chooses materials.
#pragma once

#include <fem/materials/materials.h>
#include <fem/solver/material_split.h>

#include <string>

namespace physgen::fem {

/// Calls visit.operator()<Material>(name) for every material.
/// @tparam Real its precision
template <class Real = double, class Visit>
void for_each_material(const Visit& visit) {
  visit.template operator()<NeoHookean<Real>>("neo-hookean");
  visit.template operator()<StVenantKirchhoff<Real>>("st-venant-kirchhoff");
  visit.template operator()<Corotated<Real>>("corotated");
  visit.template operator()<FixedCorotated<Real>>("fixed-corotated");
  visit.template operator()<StableNeoHookean<Real>>("stable-neo-hookean");
  visit.template operator()<StableNeoHookeanFull<Real>>("stable-neo-hookean-full");
  visit.template operator()<MooneyRivlin<Real>>("mooney-rivlin");
}

/// @throw Error naming the materials there are, and the nearest
[[noreturn]] void refuse_material(const std::string& name);
/// @throw Error naming the materials whose volume can be averaged
[[noreturn]] void refuse_averages(const std::string& name);

}  // namespace physgen::fem
