// The parts of solvers by Newton's method, over one executor and in one precision: levels, their arrays and the
// material.
#pragma once

#include <fem/solver/arrays/host_points.h>
#include <fem/solver/loads/loading_arrays.h>
#include <fem/solver/loads/pressed_faces.h>
#include <fem/solver/newton/newton.h>
#include <fem/solver/preconditioners/make_linear_levels.h>
#include <fem/solver/quasistatic.h>
#include <fem/solver/solvers/make_executor.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

namespace physgen::fem {

/// @tparam Types SolverTypes of solver_types.h, or a struct of its names
template <class On, class Types>
class SolverParts {
 protected:
  using Real = typename Types::Real;
  using Space = typename On::Space;
  using Arrays = typename Types::Arrays;
  using Level = typename Types::Level;
  using Vectors = typename Types::Vectors;
  using Material = typename Types::Material;

  /// Takes parts that are made; the caller fills in the rest.
  SolverParts(On& on, const SolverSettings& settings, std::unique_ptr<Material> material, std::size_t solved)
      : settings_(settings), on_(&on), evaluator_(std::move(material)), solved_(solved) {}
  SolverParts(const std::vector<MeshLevel>& levels, const Loading& loading, const SolverSettings& settings)
      : SolverParts(loading, settings, levels_in_use(levels, settings)) {}

  /// The arrays of a mesh that are made.
  /// @param groups its body, materials, patches or NoArrays, chunk, krylov, and facts
  template <class Groups>
  void take(Groups& groups) {
    arrays_.push_back(std::make_unique<Arrays>(std::move(groups.body)));
    Arrays& arrays = *arrays_.back();
    arrays.chunks = groups.facts.chunks;
    arrays.materials = groups.materials;
    arrays.chunk_arrays = std::make_shared<decltype(groups.chunk)>(std::move(groups.chunk));
    if constexpr (may_have<decltype(arrays.patches)>) {
      if (arrays.volumes.size() > 0) {
        arrays.patches = std::make_unique<GroupOf<decltype(arrays.patches)>>(std::move(groups.patches));
      }
    }
    vectors_.push_back(std::make_unique<Vectors>(std::move(groups.krylov)));
    loops_.emplace_back();
    rounding_forces_.push_back(groups.facts.rounding_force);
    moves_.push_back(groups.facts.moves);
    all_prescribed_.push_back(groups.facts.all_prescribed);
  }
  /// Levels that are made. @param groups levels, finest first, and facts of them
  template <class Groups>
  void take_levels(Groups& groups) {
    for (std::size_t l = 0; l < groups.levels.size(); ++l) {
      linear_.push_back(std::make_unique<Level>(std::move(groups.levels[l])));
      if constexpr (Level::Choices::assembled) {
        linear_.back()->sums = std::move(groups.facts.sums[l]);
        linear_.back()->rows = std::move(groups.facts.rows[l]);
      } else {
        linear_.back()->assembled = false;
      }
    }
  }

  [[nodiscard]] index_t bytes() const {
    index_t sum = arrays_.front()->chunk_arrays->bytes();
    for (const auto& level : linear_) sum += level->bytes();
    for (const auto& arrays : arrays_) sum += arrays->bytes();
    for (const auto& vectors : vectors_) sum += vectors->bytes();
    return sum;
  }

  /// Evaluates a level's positions as they are.
  typename quasistatic::EquilibriumArray<double, Space>::Value evaluate_now(std::size_t level, double load) {
    Arrays& a = *arrays_[level];
    return evaluate_state(*on_, a, *linear_[level], *evaluator_, a.positions.const_view(), a.forces.view(), load, true);
  }
  /// Evaluates stresses at the finest level's positions as they are. @param stresses an array of elasticity::Stress in
  /// double, one per tet
  template <class Stresses>
  void evaluate_stresses(double load, Stresses& stresses) {
    (void)evaluate_now(0, load);
    evaluator_->evaluate_stress(*on_, *arrays_.front(), stresses);
    on_->wait();
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses_at(double load) {
    elasticity::StressArray<double, Space> stresses(arrays_.front()->tet_count());
    evaluate_stresses(load, stresses);
    return plain_stresses(*on_, stresses);
  }

  void store(Arrays& a, std::span<const Point> points) {
    elasticity::NodePositionArray<double> host(a.nodes());
    store_positions(points, host.view());
    on_->wait();
    copy(a.positions, host);
    copy(a.kept, host);
    synchronize();
  }

  /// @pre require_loading(), and no planes
  void replace_loading(const Loading& loading) {
    std::vector<Point> motion = loading.motion, forces = loading.forces;
    std::vector<PressedFace> faces = pressed_faces(loading.pressures);
    for (std::size_t l = 0; l < solved_; ++l) {
      store_loading(*arrays_[l], plain_constraints(*on_, linear_[l]->constraints), motion, forces);
      where(arrays_[l]->surface, [&](auto& surface) { surface.store(faces); });
      if (l + 1 == solved_) break;
      const auto parents = plain_parents(*on_, linear_[l]->parents);
      coarsen_loading(parents, static_cast<Index>(arrays_[l + 1]->nodes()), motion, forces);
      if (!faces.empty()) faces = coarser_faces(faces, parents);
    }
    synchronize();
  }

  SolverSettings settings_;
  std::unique_ptr<On> own_on_;
  On* on_;
  std::unique_ptr<Material> evaluator_;
  std::vector<std::unique_ptr<Level>> linear_;   ///< finest first
  std::vector<std::unique_ptr<Arrays>> arrays_;  ///< of the levels on which equilibrium is solved
  std::vector<std::unique_ptr<Vectors>> vectors_;
  std::deque<typename On::Loop> loops_;
  std::vector<double> rounding_forces_;       ///< per level on which equilibrium is solved [N]
  std::vector<bool> moves_, all_prescribed_;  ///< any component or plane is moved by the load; every component is
  std::size_t solved_;

 private:
  SolverParts(const Loading& loading, const SolverSettings& settings, LevelsInUse used)
      : settings_(settings),
        own_on_(make_executor<On>(index_t(used.levels.front().mesh.tets.size()), settings)),
        on_(own_on_.get()),
        evaluator_(Types::make_material(
            settings, used.levels.front().averages_at_nodes || !used.levels.front().patches.nodes.empty())),
        linear_(make_linear_levels<Level>(used, settings)),
        solved_(used.solved) {
    const TangentLists lists = tangent_lists<Space>(settings.newton);
    std::vector<Point> motion = loading.motion, forces = loading.forces;
    std::vector<PressedFace> faces = pressed_faces(loading.pressures);
    for (std::size_t l = 0; l < used.levels.size(); ++l) {
      const MeshLevel& level = used.levels[l];
      if (l < solved_) {
        InStage stage("arrays of meshes");
        arrays_.push_back(std::make_unique<Arrays>(level, used.graphs[l], l + 1 < solved_, lists,
                                                   l == 0 ? nullptr : arrays_.front()->chunk_arrays));
        vectors_.push_back(std::make_unique<Vectors>());
        vectors_.back()->allocate({.node = used.graphs[l].nodes});
        stage.moves(level.mesh.tets, level.mesh.node_tets.entries, level.mesh.edge_tets.entries);
        stage.moves_bytes(arrays_.back()->bytes() + vectors_.back()->bytes());
        loops_.emplace_back();
        store_loading(*arrays_.back(), level.fixed, motion, forces);
        if (!faces.empty()) make(arrays_.back()->surface, level, used.graphs[l], faces);
        rounding_forces_.push_back(
            rounding_force(settings, level, motion, !loading.planes.empty(), arrays_.back()->spacing));
        moves_.push_back(std::ranges::any_of(level.fixed, [](std::uint8_t fixed) { return fixed != 0; }) ||
                         !loading.planes.empty());
        all_prescribed_.push_back(std::ranges::all_of(level.fixed, [](std::uint8_t fixed) { return fixed == 7; }));
      }
      if (!loading.planes.empty() && !level.is_grid()) make_planes(l, level, loading.planes);
      if (l + 1 >= solved_) continue;
      coarsen_loading(level.parents, used.levels[l + 1].mesh.nodes, motion, forces);
      if (!faces.empty()) faces = coarser_faces(faces, level.parents);
    }
  }

  void make_planes(std::size_t l, const MeshLevel& level, const std::vector<RigidPlane>& planes) {
    if (l >= solved_) return make(linear_[l]->planes, index_t{level.mesh.nodes});
    const double per_area = settings_.plane_stiffness * settings_.youngs_modulus / arrays_[l]->spacing;
    make(linear_[l]->planes, level, planes, per_area);
  }
};

}  // namespace physgen::fem
