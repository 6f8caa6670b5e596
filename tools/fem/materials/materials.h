// All material models. The tests of every material run over this list; a new model is a header and a line here.
#pragma once

#include <fem/materials/corotated.h>
#include <fem/materials/fixed_corotated.h>
#include <fem/materials/mooney_rivlin.h>
#include <fem/materials/neo_hookean.h>
#include <fem/materials/st_venant_kirchhoff.h>
#include <fem/materials/stable_neo_hookean.h>
#include <fem/materials/stable_neo_hookean_full.h>

namespace physgen::fem {

template <class... Models>
struct MaterialList {};

template <class Real>
using AllMaterials = MaterialList<NeoHookean<Real>, StVenantKirchhoff<Real>, Corotated<Real>, FixedCorotated<Real>,
                                  StableNeoHookean<Real>, StableNeoHookeanFull<Real>, MooneyRivlin<Real>>;

}  // namespace physgen::fem
