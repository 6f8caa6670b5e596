// Materials by name. Only files that compile the evaluators include this (see CMakeLists.txt); for all others
// evaluate.h declares the function. nvcc compiles a material's kernels wherever it reads its evaluator's text.
#pragma once

#include <fem/materials/materials.h>
#include <fem/solver/elastic/evaluate.h>
#include <fem/solver/material_names.h>
#include <fem/solver/solvers/all_arrays.h>

namespace physgen::fem {

template <class On, class Arrays>
std::unique_ptr<Evaluator<On, Arrays>> make_evaluator(const std::string& material,
                                                      const std::vector<ElasticConstants>& constants, bool averages) {
  std::unique_ptr<Evaluator<On, Arrays>> made;
  for_each_material([&]<class Material>(const char* name) {
    if (material != name) return;
    if (averages && !splits_volume<Material>) refuse_averages(material);
    made = std::make_unique<MaterialEvaluator<On, Arrays, Material>>(constants, averages);
  });
  if (made == nullptr) refuse_material(material);
  return made;
}

}  // namespace physgen::fem
