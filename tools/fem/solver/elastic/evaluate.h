// Energy, forces and tangent of a state: the only part of the solver that knows the material.
#pragma once

#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/elastic/equilibrium_arrays.h>
#include <fem/solver/elastic/evaluate_tets.h>
#include <fem/solver/elastic/node_volume.h>
#include <fem/solver/elastic/patch_volume.h>
#include <fem/solver/elastic/tet_stress.h>
#include <fem/solver/material_split.h>
#include <fem/solver/settings.h>
#include <physgen/launch/reduce.h>

#include <memory>
#include <vector>

namespace physgen::fem {

/// Leaves the energy of the tets of a material in quasistatic::Equilibrium: adds it to that of those before.
template <class StateView>
struct StoreElasticEnergy {
  StateView state;
  bool is_first;
  PHYSGEN_FUNCTION void operator()(double energy) const {
    const auto s = state[index_t{0}];
    const double before = is_first ? 0.0 : double(s.elastic());
    s.elastic() = before + energy;
  }
};

/// Leaves the energy of the mean volumes of a material in quasistatic::Equilibrium: adds it to that of those before.
template <class StateView>
struct StoreVolumetric {
  StateView state;
  bool is_first;
  PHYSGEN_FUNCTION void operator()(double energy) const {
    const auto s = state[index_t{0}];
    const double before = is_first ? 0.0 : double(s.volumetric());
    s.volumetric() = before + energy;
  }
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
  /// @param material 0 where the body has one
  [[nodiscard]] virtual VolumeTerm volume(std::size_t material) const = 0;
};

/// The steps of a material, or of several of one model, each over the tets that are of it.
template <class Material>
class MaterialSteps {
 public:
  /// @param averages whether volumes are averaged. @pre then the material's volume can be split off
  MaterialSteps(const Material& material, bool averages) { add(material, averages); }
  /// @throw Error when constants are out of range
  MaterialSteps(const std::vector<ElasticConstants>& constants, bool averages) {
    for (const ElasticConstants& c : constants) add(Material::from(c.youngs_modulus, c.poissons_ratio), averages);
  }
  template <class On, class Arrays, class Positions>
  void evaluate_volumes(On& on, Arrays& a, const Positions& positions, bool restart) {
    // Apart from the sum, in which a device forms fewer terms at once.
    const auto evaluate = [&](std::size_t m, const MaterialRange& range, const VolumeTerm& volume, const auto& kernel) {
      on.run(a.volumes.size(), kernel);
      on.reduce(a.volumes.size(), MeanVolumeEnergy{range, volume.law, volume.modulus, a.volumes.const_view()}, Sum{},
                StoreVolumetric{a.state.view(), m == 0});
    };
    const auto of_patches = [&](auto& p) {
      a.each_material([&](std::size_t m, const MaterialRange& range) {
        const VolumeTerm& volume = volumes_[m];
        evaluate(
            m, range, volume,
            EvaluatePatches{range, volume.law, volume.modulus, restart, p.patch_tets.const_view(), a.tets.const_view(),
                            a.rest.const_view(), positions, a.volumes.view(), p.tangent.view()});
      });
    };
    const auto at_nodes = [&](auto& rings) {  // of one material
      const VolumeTerm& volume = volumes_[0];
      evaluate(0, MaterialRange{0, 0, 0, a.volumes.size()}, volume,
               EvaluateNodeVolumes{volume.law, volume.modulus, restart, a.node_tets.const_view(), a.tets.const_view(),
                                   a.rest.const_view(), positions, a.volumes.view(), rings.nodes.view(),
                                   rings.tangent.view()});
    };
    if (!where(a.patches, of_patches)) where(a.rings, at_nodes);
  }
  template <class On, class Arrays, class Positions>
  void evaluate_forces(On& on, Arrays& a, const TetChunk& chunk, const Positions& positions) {
    with_pressures(a, [&](const auto& pressures) {
      on.reduce_part(
          {chunk.first_tet, chunk.tets(), a.tet_count()},
          ComputeTetForces{chunk, materials_[static_cast<std::size_t>(chunk.material)], pressures, a.tets.const_view(),
                           a.rest.const_view(), positions, a.chunk_arrays->corners.view()},
          Sum{}, StoreElasticEnergy{a.state.view(), chunk.material == 0});
    });
  }
  template <class On, class Arrays>
  void evaluate_tangents(On& on, Arrays& a, const TetChunk& chunk, TangentFilter filter) {
    with_pressures(a, [&](const auto& pressures) {
      on.run(chunk.tets(), ComputeTetTangents{chunk, filter, materials_[static_cast<std::size_t>(chunk.material)],
                                              pressures, a.tets.const_view(), a.rest.const_view(),
                                              a.positions.const_view(), a.chunk_arrays->tangent.view()});
    });
  }
  template <class On, class Arrays, class Stresses>
  void evaluate_stress(On& on, Arrays& a, Stresses& stresses) {
    with_pressures(a, [&](const auto& pressures) {
      a.each_material([&](std::size_t m, const MaterialRange& range) {
        on.run(a.tet_count(), EvaluateStress{range, materials_[m], pressures, a.tets.const_view(), a.rest.const_view(),
                                             a.positions.const_view(), stresses.view()});
      });
    });
  }
  [[nodiscard]] VolumeTerm volume(std::size_t material) const { return volumes_[material]; }

 private:
  void add(Material material, bool averages) {
    VolumeTerm volume;
    if constexpr (splits_volume<Material>) {
      if (averages) volume = split_volume(material);
    }
    materials_.push_back(material);
    volumes_.push_back(volume);
  }

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

  std::vector<Material> materials_;
  std::vector<VolumeTerm> volumes_;  ///< of each
};

template <class On, class Arrays, class Material>
class MaterialEvaluator final : public Evaluator<On, Arrays> {
 public:
  using typename Evaluator<On, Arrays>::PositionView;
  using typename Evaluator<On, Arrays>::Stresses;

  /// See MaterialSteps.
  MaterialEvaluator(const std::vector<ElasticConstants>& constants, bool averages) : steps_(constants, averages) {}
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
  [[nodiscard]] VolumeTerm volume(std::size_t material) const override { return steps_.volume(material); }

 private:
  MaterialSteps<Material> steps_;
};

/// @throw Error when constants are out of range
template <class On, class Arrays>
[[nodiscard]] std::unique_ptr<Evaluator<On, Arrays>> make_evaluator(const std::string& material,
                                                                    const std::vector<ElasticConstants>& constants,
                                                                    bool averages);

}  // namespace physgen::fem
