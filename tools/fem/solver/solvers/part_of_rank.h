// What a rank has of a body: its part of the finest mesh, and those of coarser ones.
#pragma once

#include <fem/solver/levels/level_halos.h>
#include <fem/solver/newton/newton.h>
#include <fem/solver/solvers/numbers_of_ranks.h>
#include <fem/solver/solvers/part_of_equilibrium.h>
#include <fem/solver/solvers/whole_body.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace physgen::fem {

/// The table of kernels of a scene. A file that makes its solver includes the table, and defines this.
template <class Scene>
[[nodiscard]] HaloUses halos_of();

namespace detail {

[[nodiscard]] inline std::string in_brackets(std::size_t k) { return "[" + std::to_string(k) + "]"; }

/// What a rank has of the finest mesh, of coarser ones and of rigid planes, and the executor over them.
template <class On, class Scene>
struct PartOfRank {
  using Space = typename On::Space;
  using Mesh = QuasistaticMesh<Space, Scene>;
  using WholeMesh = QuasistaticMesh<Host, Scene>;
  using Part = PartOfEquilibrium<WholeBody<Scene>, QuasistaticBody<Space, Scene>>;
  std::vector<Mesh> coarser;
  std::vector<typename QuasistaticBody<Space, Scene>::Planes> planes;  ///< of the level of each mesh, or none
  elasticity::StressArray<double, Space> stresses_of_tets;
  std::unique_ptr<Part> finest;
  std::unique_ptr<On> on;

  /// @param add_besides adds what a scene has besides, before the arrays are cut
  PartOfRank(const Ranks& ranks, WholeBody<Scene>& whole, const DistributedOptions& options,
             const std::function<void(DistributedArrays& arrays)>& add_besides = {})
      : coarser(whole.coarser.size()), planes(whole.planes.size()) {
    const InStage stage("parts of ranks");
    const auto add_more = [&](auto& part) {
      part.arrays.add("stresses.of_tets", "tet", stresses_of_tets);
      if constexpr (is_nested) add_coarser(part, whole);
      add_planes(part.arrays, whole);
      if (add_besides) add_besides(part.arrays);
    };
    finest = std::make_unique<Part>(ranks, table(), whole, whole.cut, add_more, [&whole] { whole.release_lists(); });
    finest->facts.all_prescribed = whole.facts.all_prescribed;
    fill_planes(whole);
    if constexpr (is_nested) fill_coarser(whole);
    on = std::make_unique<On>(ranks, finest->arrays, options);
  }

  /// What an iteration of conjugate gradients sends, with the tangent at the finest mesh's state, which is evaluated.
  /// @param a, levels, v arrays of this rank @param preconditioner of `levels`
  template <class Arrays, class Levels, class Vectors, class Evaluator>
  [[nodiscard]] Traffic traffic_of_iteration(Arrays& a, Levels& levels, Vectors& v, Evaluator& evaluator,
                                             const PreconditionerSettings& preconditioner, double load) {
    auto& level = *levels.front();
    form_tangent(*on, a, level, evaluator, TangentFilter::none, load);
    prepare_tangent(*on, a, levels, 0, preconditioner, true);
    return fem::traffic_of_iteration(*on, finest->arrays, a.forces, [&](int count) {
      on->run(a.nodes(),
              BeginResidual{a.forces.const_view(), level.constraints.const_view(), false, v.residual.view()});
      typename On::Loop loop;
      solve(*on, loop, a, levels, 0, v, preconditioner, 0, count);
    });
  }

 private:
  static constexpr bool assembled = Mesh::Choices::assembled;
  static constexpr bool is_nested = !may_have<decltype(Mesh::Types::Level::inertia)>;  // bodies that move are not
  static constexpr bool has_patches = !std::is_same_v<decltype(Mesh::patches), NoArrays>;
  static constexpr bool has_planes = !std::is_same_v<typename QuasistaticBody<Space, Scene>::Planes, NoArrays>;

  static HaloUses table() {
    static const std::vector<HaloUse> rows = with_halos_of_levels(halos_of<Scene>());
    return rows;
  }
  static std::string name_of_level(std::size_t l) { return "level" + (l == 0 ? "" : in_brackets(l)); }
  static void add_set(DistributedArrays& arrays, const std::string& set, index_t size, bool is_cut,
                      const std::string& followed) {
    if (!is_cut) return arrays.add_replicated_set(set, size);
    arrays.add_set(set, size);
    if (!followed.empty()) arrays.follow(set, followed);
  }
  /// Adds the coarser meshes, on which equilibrium is sought first.
  void add_coarser(Part& part, const WholeBody<Scene>& whole) {
    for (std::size_t k = 0; k < coarser.size(); ++k) {
      const bool is_cut = k + 1 < whole.cut;
      if constexpr (!assembled) add_level(part.arrays, part.levels, whole, k, is_cut);
      add(part.arrays, whole.coarser[k], k, is_cut, whole.listed.levels[k + 1]);
    }
    if constexpr (has_patches) {
      for (std::size_t k = 0; k < coarser.size(); ++k) {
        add_parents(part.arrays, k == 0 ? part.patches : coarser[k - 1].patches,
                    k == 0 ? whole.patches : whole.coarser[k - 1].patches, k, whole.listed);
      }
    }
  }
  void fill_coarser(const WholeBody<Scene>& whole) {
    for (std::size_t k = 0; k < coarser.size(); ++k) {
      Mesh& mesh = coarser[k];
      const MeshFacts& facts = whole.coarser[k].facts;
      const ListedObjects nodes = whole.listed.levels[k + 1].nodes;
      fill_mesh(finest->arrays, mesh.body, mesh.krylov, whole.coarser[k].body, nodes);
      if constexpr (!assembled) fill_level_by_tets(finest->arrays, finest->levels[k + 1], whole.graphs[k + 1], nodes);
      mesh.facts.rounding_force = facts.rounding_force;
      mesh.facts.plane_stiffness = facts.plane_stiffness;
      mesh.facts.moves = facts.moves;
      mesh.facts.all_prescribed = facts.all_prescribed;
      mesh.materials = materials_of(finest->arrays, mesh.body, whole.coarser[k].materials);
      mesh.facts.chunks = chunks_of_part<assembled>(finest->arrays.transport(), mesh.body,
                                                    finest->levels[k + 1].edges.contents(), mesh.materials);
    }
  }
  /// Adds level k + 1, whose tangents are not assembled, and the parents of level k.
  template <class Levels>
  static void add_level(DistributedArrays& arrays, Levels& levels, const WholeBody<Scene>& whole, std::size_t k,
                        bool is_cut) {
    const ListedObjects own = whole.listed.levels[k].nodes, of_coarser = whole.listed.coarser[k].nodes;
    const std::string fine = k == 0 ? "node" : name_of_level(k) + ".node", coarse = name_of_level(k + 1) + ".node";
    add_set(arrays, coarse, of_coarser.size, is_cut, "");
    add_level_by_tets(arrays, in_brackets(k + 1), coarse, levels[k + 1]);
    arrays.add(name_of_level(k) + ".parents", fine, levels[k].parents.contents());
    arrays.connect(
        levels[k].parents.contents(), "nodes", coarse,
        [&graph = whole.graphs[k], own, before = static_cast<Index>(of_coarser.offset)](index_t node) {
          const auto& [p, q] = graph.parents[at(own.here(node))];
          return std::array{p + before, q + before};
        },
        own.known);
  }
  /// Adds mesh k + 1, which is cut, or which all ranks have.
  void add(DistributedArrays& arrays, const WholeMesh& whole, std::size_t k, bool is_cut, const ListedLevel& listed) {
    const std::string number = in_brackets(k + 1), level = "level" + number, tet = "tet" + number,
                      patch = "patch" + number;
    Mesh& mesh = coarser[k];
    const MeshSets sets{level + ".node", tet, tet, tet};
    add_set(arrays, tet, listed.tets.size, is_cut, sets.node);
    add_mesh(arrays, number, sets, mesh.body, mesh.chunk, mesh.krylov, whole.body, listed, !assembled);
    if constexpr (assembled) add_edge_tets(arrays, number, level + ".edge", tet, mesh.body, whole.body, listed);
    if constexpr (has_patches) {
      if (whole.body.volumes.size() == 0) return;
      add_set(arrays, patch, listed.patches.size, is_cut, sets.node);
      add_patches(arrays, number, sets, patch, mesh.body, mesh.patches, whole.patches, listed);
      if constexpr (assembled) {
        add_edge_patches(arrays, number, level + ".edge", patch, mesh.patches, whole.patches, listed);
      } else {
        add_node_patches(arrays, number, sets.node, patch, mesh.patches, whole.patches, listed);
      }
    }
  }
  /// Adds the rigid planes, which all ranks have, and what nodes have of them.
  void add_planes(DistributedArrays& arrays, const WholeBody<Scene>& whole) {
    if constexpr (has_planes) {
      if (!planes.empty()) arrays.add_replicated_set("plane", whole.planes.front().planes.size());
      for (std::size_t l = 0; l < planes.size(); ++l) {
        const std::string of_planes = "planes" + in_brackets(l) + ".", node = "level" + in_brackets(l) + ".node";
        arrays.add(of_planes + "stiffness", node, planes[l].stiffness);
        if (l > coarser.size()) continue;
        arrays.add(of_planes + "planes", "plane", planes[l].planes.contents());
        arrays.add(of_planes + "areas", node, planes[l].areas.contents());
      }
    }
  }
  /// Fills the planes of the meshes on which equilibrium is sought. @pre cut() was called
  void fill_planes(const WholeBody<Scene>& whole) {
    if constexpr (has_planes) {
      for (std::size_t l = 0; l < std::min(planes.size(), 1 + coarser.size()); ++l) {
        finest->arrays.fill(planes[l].planes.contents(), whole.planes[l].planes);
        finest->arrays.fill(planes[l].areas.contents(), whole.planes[l].areas);
        planes[l].contact.resize(1);
      }
    }
  }
  /// Adds and connects the parents of the patches of mesh k, which are among those of the next coarser one.
  template <class Patches, class WholePatches>
  static void add_parents(DistributedArrays& arrays, Patches& patches, const WholePatches& whole, std::size_t k,
                          const ListedLevels& listed) {
    if (whole.parents.size() == 0) return;
    const std::string number = k == 0 ? "" : in_brackets(k);
    arrays.add("patches" + number + ".parents", "patch" + number, patches.parents.contents());
    arrays.connect(patches.parents.contents(), "patch", "patch" + in_brackets(k + 1),
                   patch_of(whole.parents, listed.levels[k].patches, listed.coarser[k].patches),
                   listed.levels[k].patches.known);
  }
};

}  // namespace detail

}  // namespace physgen::fem
