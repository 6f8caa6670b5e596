// Energy, forces and tangent of a state: the only part of the solver that knows the material.
#pragma once

#include <fem/solver/equilibrium_arrays.h>
#include <fem/solver/evaluate_tets.h>
#include <fem/solver/material_split.h>
#include <fem/solver/patch_volume.h>
#include <fem/solver/tet_stress.h>
#include <physgen/reduce.h>

#include <memory>

namespace physgen::fem {

/// Leaves a sum in one of the numbers of quasistatic::Equilibrium.
template <class StateView>
struct StoreElastic {
  StateView state;
  PHYSGEN_FUNCTION void operator()(double energy) const { state[index_t{0}].elastic() = energy; }
};
template <class StateView>
StoreElastic(StateView) -> StoreElastic<StateView>;
template <class StateView>
struct StoreVolumetric {
  StateView state;
  PHYSGEN_FUNCTION void operator()(double energy) const { state[index_t{0}].volumetric() = energy; }
};
template <class StateView>
StoreVolumetric(StateView) -> StoreVolumetric<StateView>;

/// Leaves in the arrays' state the energy at `positions`, in `corners` the forces of the tets, and their tangent.
/// @param material without its volume's part where the arrays have patches
/// @param restart patches begin their linearised pressure anew
template <class On, class Arrays, class Material, class PositionView>
void evaluate(On& on, Arrays& a, const Material& material, const VolumeTerm& volume, const PositionView& positions,
              TangentFilter filter, bool restart) {
  const auto state = a.state.view();
  const auto tets = a.tets.const_view();
  const auto rest = a.rest.const_view();
  const auto corners = a.corners.view();
  const auto tangent = a.tangent.view();
  if constexpr (splits_volume<Material>) {
    if (a.patches != nullptr) {
      auto& p = *a.patches;
      on.reduce(p.volumes.size(),
                EvaluatePatches{volume.law, volume.modulus, restart, p.patch_tets.const_view(), tets, rest, positions,
                                p.volumes.view(), p.tangent.view()},
                Sum{}, StoreVolumetric{state});
      on.reduce(a.tet_count(),
                EvaluateTets{material, PatchPressures{p.tet_patches.const_view(), p.volumes.const_view()}, tets, rest,
                             positions, corners, tangent, filter},
                Sum{}, StoreElastic{state});
      return;
    }
  }
  on.reduce(a.tet_count(), EvaluateTets{material, NoPatches{}, tets, rest, positions, corners, tangent, filter}, Sum{},
            StoreElastic{state});
}

/// A material, as the solver sees it.
/// @tparam Arrays EquilibriumArrays
template <class On, class Arrays>
class Evaluator {
 public:
  using PositionView = decltype(std::declval<const Arrays&>().positions.const_view());
  using Stresses = elasticity::StressArray<double, typename On::Space>;
  Evaluator() = default;
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;
  virtual ~Evaluator() = default;
  /// As evaluate() above.
  virtual void evaluate(On& on, Arrays& arrays, const PositionView& positions, TangentFilter filter, bool restart) = 0;
  /// Of the state that was evaluated last. @pre as many as tets
  virtual void evaluate_stress(On& on, Arrays& arrays, Stresses& stresses) = 0;
  [[nodiscard]] virtual VolumeTerm volume() const = 0;
};

template <class On, class Arrays, class Material>
class MaterialEvaluator final : public Evaluator<On, Arrays> {
 public:
  using typename Evaluator<On, Arrays>::PositionView;
  using typename Evaluator<On, Arrays>::Stresses;

  /// @param patches whether these average the volume. @pre then the material's volume can be split off
  MaterialEvaluator(const Material& material, bool patches) : material_(material) {
    if constexpr (splits_volume<Material>) {
      if (patches) volume_ = split_volume(material_);
    }
  }
  void evaluate(On& on, Arrays& arrays, const PositionView& positions, TangentFilter filter, bool restart) override {
    fem::evaluate(on, arrays, material_, volume_, positions, filter, restart);
  }
  void evaluate_stress(On& on, Arrays& a, Stresses& stresses) override {
    const auto tets = a.tets.const_view();
    const auto rest = a.rest.const_view();
    const auto positions = a.positions.const_view();
    if constexpr (splits_volume<Material>) {
      if (a.patches != nullptr) {
        on.run(a.tet_count(),
               EvaluateStress{material_,
                              PatchPressures{a.patches->tet_patches.const_view(), a.patches->volumes.const_view()},
                              tets, rest, positions, stresses.view()});
        return;
      }
    }
    on.run(a.tet_count(), EvaluateStress{material_, NoPatches{}, tets, rest, positions, stresses.view()});
  }
  [[nodiscard]] VolumeTerm volume() const override { return volume_; }

 private:
  Material material_;
  VolumeTerm volume_;
};

/// @throw Error when constants are out of range
template <class On, class Arrays>
[[nodiscard]] std::unique_ptr<Evaluator<On, Arrays>> make_evaluator(const std::string& material, double youngs_modulus,
                                                                    double poissons_ratio, bool patches);

}  // namespace physgen::fem
