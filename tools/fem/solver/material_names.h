// The names by which a user chooses materials.
#pragma once

#include <fem/materials/materials.h>
#include <fem/solver/material_split.h>
#include <fem/solver/settings.h>

namespace physgen::fem {

/// Calls visit.operator()<Material>(name) for every material, in double.
template <class Visit>
void for_each_material(const Visit& visit) {
  visit.template operator()<NeoHookean<double>>("neo-hookean");
  visit.template operator()<StVenantKirchhoff<double>>("st-venant-kirchhoff");
  visit.template operator()<Corotated<double>>("corotated");
  visit.template operator()<FixedCorotated<double>>("fixed-corotated");
  visit.template operator()<StableNeoHookean<double>>("stable-neo-hookean");
  visit.template operator()<StableNeoHookeanFull<double>>("stable-neo-hookean-full");
  visit.template operator()<MooneyRivlin<double>>("mooney-rivlin");
}

/// @throw Error naming the materials there are, and the nearest
[[noreturn]] void refuse_material(const std::string& name);
/// @throw Error naming the materials whose volume can be averaged
[[noreturn]] void refuse_averages(const std::string& name);

}  // namespace physgen::fem
