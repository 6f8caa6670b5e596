// Materials by name. The evaluators themselves are compiled in files of their own: see CMakeLists.txt.
#pragma once

#include <fem/materials/materials.h>
#include <fem/solver/elastic/evaluate.h>
#include <fem/solver/material_names.h>
#include <fem/solver/solvers/all_arrays.h>

namespace physgen::fem {

template <class On, class Arrays>
std::unique_ptr<Evaluator<On, Arrays>> make_evaluator(const std::string& material, double youngs_modulus,
                                                      double poissons_ratio, bool averages) {
  std::unique_ptr<Evaluator<On, Arrays>> made;
  for_each_material([&]<class Material>(const char* name) {
    if (material != name) return;
    if (averages && !splits_volume<Material>) refuse_averages(material);
    made = std::make_unique<MaterialEvaluator<On, Arrays, Material>>(Material::from(youngs_modulus, poissons_ratio),
                                                                     averages);
  });
  if (made == nullptr) refuse_material(material);
  return made;
}

// Inside physgen::fem, so that a source does not compile all materials by itself.
#define PHYSGEN_EVALUATOR_IS_COMPILED_ELSEWHERE(Model, header, word, On, Real, Space) \
  extern template class MaterialEvaluator<On, EquilibriumArrays<Real, Space>, Model<double>>;
#define PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(On, Real, Space) \
  PHYSGEN_MATERIALS(PHYSGEN_EVALUATOR_IS_COMPILED_ELSEWHERE, On, Real, Space)

}  // namespace physgen::fem
