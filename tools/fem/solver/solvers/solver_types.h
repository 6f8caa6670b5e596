// The types of the solvers that have all choices at run time.
#pragma once

#include <fem/solver/elastic/evaluate.h>
#include <fem/solver/settings.h>
#include <fem/solver/solvers/all_arrays.h>

#include <memory>

namespace physgen::fem {

/// The types of a solver's arrays and of its material.
template <class On, class Real, class Stored>
struct SolverTypes : AllArrays<Real, typename On::Space, Stored> {
  using Material = Evaluator<On, EquilibriumArrays<Real, typename On::Space>>;

  /// @param averages whether volumes are those of patches or nodes
  [[nodiscard]] static std::unique_ptr<Material> make_material(const SolverSettings& settings, bool averages) {
    return make_evaluator<On, EquilibriumArrays<Real, typename On::Space>>(settings.material, constants_of(settings),
                                                                           averages);
  }
};

}  // namespace physgen::fem
