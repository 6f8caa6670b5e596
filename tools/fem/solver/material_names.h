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
#define PHYSGEN_VISIT_MATERIAL(Model, header, word, ...) visit.template operator()<Model<Real>>(word);
  PHYSGEN_MATERIALS(PHYSGEN_VISIT_MATERIAL)
#undef PHYSGEN_VISIT_MATERIAL
}

/// @throw Error naming the materials there are, and the nearest
[[noreturn]] void refuse_material(const std::string& name);
/// @throw Error naming the materials whose volume can be averaged
[[noreturn]] void refuse_averages(const std::string& name);

}  // namespace physgen::fem
