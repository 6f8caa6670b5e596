// Energy, forces and tangent of a state: the only part of the solver that knows the material.
#pragma once

#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/elastic/equilibrium_arrays.h>
#include <fem/solver/elastic/evaluate_tets.h>
#include <fem/solver/elastic/node_volume.h>
#include <fem/solver/elastic/patch_volume.h>
#include <fem/solver/elastic/tet_stress.h>
#include <fem/solver/material_split.h>
#include <physgen/launch/reduce.h>

#include <memory>

namespace physgen::fem {

/// Leaves the energy of tets in quasistatic::Equilibrium.
template <class StateView>
struct StoreElasticEnergy {
  StateView state;
  PHYSGEN_FUNCTION void operator()(double energy) const { state[index_t{0}].elastic() = energy; }
};

/// Leaves the energy of the mean volumes in quasistatic::Equilibrium.
template <class StateView>
struct StoreVolumetric {
  StateView state;
  PHYSGEN_FUNCTION void operator()(double energy) const { state[index_t{0}].volumetric() = energy; }
};

/// A material, as the solver sees it that is compiled for all of them.
/// @tparam Arrays EquilibriumOver
template <class On, class Arrays>
class Evaluator {
 public:
  using PositionView = decltype(std::declval<const Arrays&>().positions.const_view());
  using Stresses = elasticity::StressArray<double, typename On::Space>;
  Evaluator() = default;
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;
  virtual ~Evaluator() = default;
  /// Mean volumes and their pressures at `positions`, where the arrays have patches or rings: all else follows them.
  /// @param restart linearised pressures begin anew
  virtual void evaluate_volumes(On& on, Arrays& arrays, const PositionView& positions, bool restart) = 0;
  /// Leaves in chunk_arrays->corners the forces of a chunk of tets at `positions`, and, behind the last chunk, the
  /// energy of all tets in the arrays' state. @pre chunks come in their order
  virtual void evaluate_forces(On& on, Arrays& arrays, const TetChunk& chunk, const PositionView& positions) = 0;
  /// Leaves in chunk_arrays->tangent the tangents of a chunk of tets at the arrays' positions.
  virtual void evaluate_tangents(On& on, Arrays& arrays, const TetChunk& chunk, TangentFilter filter) = 0;
  /// Evaluates stresses at the arrays' positions. @pre as many as tets
  virtual void evaluate_stress(On& on, Arrays& arrays, Stresses& stresses) = 0;
  [[nodiscard]] virtual VolumeTerm volume() const = 0;
};

/// The steps of a material.
template <class Material>
class MaterialSteps {
 public:
  /// @param averages whether volumes are averaged. @pre then the material's volume can be split off
  MaterialSteps(const Material& material, bool averages) : material_(material) {
    if constexpr (splits_volume<Material>) {
      if (averages) volume_ = split_volume(material_);
    }
  }
  template <class On, class Arrays, class Positions>
  void evaluate_volumes(On& on, Arrays& a, const Positions& positions, bool restart) {
    // Apart from the sum, in which a device forms fewer terms at once.
    const auto evaluate = [&](const auto& kernel) {
      on.run(a.volumes.size(), kernel);
      on.reduce(a.volumes.size(), MeanVolumeEnergy{volume_.law, volume_.modulus, a.volumes.const_view()}, Sum{},
                StoreVolumetric{a.state.view()});
    };
    const auto of_patches = [&](auto& p) {
      evaluate(EvaluatePatches{volume_.law, volume_.modulus, restart, p.patch_tets.const_view(), a.tets.const_view(),
                               a.rest.const_view(), positions, a.volumes.view(), p.tangent.view()});
    };
    const auto at_nodes = [&](auto& rings) {
      evaluate(EvaluateNodeVolumes{volume_.law, volume_.modulus, restart, a.node_tets.const_view(), a.tets.const_view(),
                                   a.rest.const_view(), positions, a.volumes.view(), rings.nodes.view(),
                                   rings.tangent.view()});
    };
    if (!where(a.patches, of_patches)) where(a.rings, at_nodes);
  }
  template <class On, class Arrays, class Positions>
  void evaluate_forces(On& on, Arrays& a, const TetChunk& chunk, const Positions& positions) {
    with_pressures(a, [&](const auto& pressures) {
      on.reduce_part({chunk.first_tet, chunk.tets(), a.tet_count()},
                     ComputeTetForces{chunk, material_, pressures, a.tets.const_view(), a.rest.const_view(), positions,
                                      a.chunk_arrays->corners.view()},
                     Sum{}, StoreElasticEnergy{a.state.view()});
    });
  }
  template <class On, class Arrays>
  void evaluate_tangents(On& on, Arrays& a, const TetChunk& chunk, TangentFilter filter) {
    with_pressures(a, [&](const auto& pressures) {
      on.run(chunk.tets(),
             ComputeTetTangents{chunk, filter, material_, pressures, a.tets.const_view(), a.rest.const_view(),
                                a.positions.const_view(), a.chunk_arrays->tangent.view()});
    });
  }
  template <class On, class Arrays, class Stresses>
  void evaluate_stress(On& on, Arrays& a, Stresses& stresses) {
    with_pressures(a, [&](const auto& pressures) {
      on.run(a.tet_count(), EvaluateStress{material_, pressures, a.tets.const_view(), a.rest.const_view(),
                                           a.positions.const_view(), stresses.view()});
    });
  }
  [[nodiscard]] VolumeTerm volume() const { return volume_; }

 private:
  /// Calls body with what tells kernels of tets the pressures of mean volumes.
  template <class Arrays, class Body>
  static void with_pressures(Arrays& a, const Body& body) {
    if constexpr (splits_volume<Material>) {
      if constexpr (may_have<decltype(a.patches)>) {
        if (a.patches != nullptr) {
          return body(PatchPressures{a.patches->tet_patches.const_view(), a.volumes.const_view()});
        }
      }
      if constexpr (may_have<decltype(a.rings)>) {
        if (a.rings != nullptr) return body(NodePressures{a.tets.const_view(), a.volumes.const_view()});
      }
    }
    body(NoMeanPressures{});
  }

  Material material_;
  VolumeTerm volume_;
};

template <class On, class Arrays, class Material>
class MaterialEvaluator final : public Evaluator<On, Arrays> {
 public:
  using typename Evaluator<On, Arrays>::PositionView;
  using typename Evaluator<On, Arrays>::Stresses;

  /// See MaterialSteps.
  MaterialEvaluator(const Material& material, bool averages) : steps_(material, averages) {}
  void evaluate_volumes(On& on, Arrays& a, const PositionView& positions, bool restart) override {
    steps_.evaluate_volumes(on, a, positions, restart);
  }
  void evaluate_forces(On& on, Arrays& a, const TetChunk& chunk, const PositionView& positions) override {
    steps_.evaluate_forces(on, a, chunk, positions);
  }
  void evaluate_tangents(On& on, Arrays& a, const TetChunk& chunk, TangentFilter filter) override {
    steps_.evaluate_tangents(on, a, chunk, filter);
  }
  void evaluate_stress(On& on, Arrays& a, Stresses& stresses) override { steps_.evaluate_stress(on, a, stresses); }
  [[nodiscard]] VolumeTerm volume() const override { return steps_.volume(); }

 private:
  MaterialSteps<Material> steps_;
};

/// @throw Error when constants are out of range
template <class On, class Arrays>
[[nodiscard]] std::unique_ptr<Evaluator<On, Arrays>> make_evaluator(const std::string& material, double youngs_modulus,
                                                                    double poissons_ratio, bool averages);

}  // namespace physgen::fem
