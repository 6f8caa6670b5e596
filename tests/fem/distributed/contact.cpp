// contact: as newton, for a cube that two rigid planes push, of the scene everything: of irregular tets with block
// Jacobi, or of regular ones with multigrid, where equilibrium is sought on coarser meshes first.
//
//   --cells N      along each side (default 12)
//   --levels N     multigrid over so many meshes at most (default 1: none)
//   --replicate N  coarser levels of more nodes are cut, too, however few blocks ranks then have of them
//   --planes N     so many of the finest levels alone have planes
//   --ordinary 1   one process by the solver's ordinary way
#include <everything.halos.h>
#include <everything.scene.h>
#include <fem/solver/loads/plane_arrays.h>
#include <scenes/everything.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "coarser_meshes.h"

namespace {

using namespace physgen;
using namespace physgen::fem;
namespace of_scene = scenes::everything_scene;
using Whole = SceneGroups<of_scene::Body<>, NoArrays, of_scene::Chunk<>, of_scene::Level<>, of_scene::Krylov<>>;

/// A cube that stands on a plate.
Body standing_cube(Index cells, std::size_t levels) {
  Body body = pressed_cube(cells, false, levels);
  for (Point& motion : body.loading.motion) motion = {};
  for (MeshLevel& level : body.levels) {
    for (std::size_t n = 0; n < level.rest.size(); ++n) {
      if (level.rest[n][2] > 0) level.fixed[n] = 0;
    }
  }
  return body;
}
/// One that comes down on it, aslant, and one that pushes a side of it. Neither touches more than an edge at first.
std::vector<RigidPlane> planes_around_the_cube() {
  const double c = std::cos(0.1), s = std::sin(0.1);
  return {{{-s, 0, -c}, -(s + c) * side, 0.1 * side}, {{c, 0, s}, 0, 0.03 * side}};
}
/// Of each level.
std::vector<of_scene::Planes<>> planes_of(const Body& body, const SolverSettings& settings) {
  const auto [used, solved] = used_levels(settings, body.levels.size(), body.levels.size());
  std::vector<of_scene::Planes<>> planes;
  for (std::size_t l = 0; l < used; ++l) {
    const MeshLevel& level = body.levels[l];
    planes.push_back(l < solved ? PlanesOver<of_scene::Planes<>>(level, planes_around_the_cube(), 0)
                                : PlanesOver<of_scene::Planes<>>(index_t{level.mesh.nodes}));
  }
  return planes;
}
void note_planes(Whole& whole, const Body& body, const SolverSettings& settings) {
  whole.facts.plane_stiffness = settings.plane_stiffness * settings.youngs_modulus / whole.spacing;
  whole.facts.rounding_force = rounding_force(settings, body.levels.front(), body.loading.motion, true, whole.spacing);
}

struct Contact : NothingBesides {
  bool is_first;  ///< whether this rank prints
  int replicate;
  SolverSettings settings;
  CoarserParts<CoarserMeshOf<Whole>> coarser;
  std::vector<of_scene::Planes<>> planes, whole{};  ///< where `planes` are a rank's part of them
  std::size_t levels_cut = 1;

  template <class On, class Groups>
  NewtonResult solve(On& on, Groups& groups, const Report& report) {
    NoArrays none;
    auto solver = solver_program<float, StoredAsComputed, AssembledOnMeshes>(
        on, settings, material_of_the_cube(settings), groups.facts,
        SolverGroups{groups.body, groups.patches, none, groups.chunk, groups.levels, none, planes, none, none,
                     groups.krylov},
        coarser.parts);
    const NewtonResult result = solver.solve_to(1, [&](std::size_t level, const NewtonStep& step) {
      if (is_first) std::printf("level %zu\n", level);
      report(step);
    });
    for (std::size_t l = 0; l <= coarser.parts.size(); ++l) {
      for (const PlaneContact& contact : solver.plane_contacts_of(l)) {
        if (is_first) std::printf("plane force %a depth %a\n", contact.force, contact.depth);
      }
    }
    return result;
  }

  [[nodiscard]] std::size_t cut(std::span<const LevelGraph> graphs, int ranks) {
    levels_cut = levels_that_are_cut(graphs, ranks, replicated(replicate));
    return levels_cut;
  }
  void add_to(DistributedArrays& arrays) {
    coarser.add_to(arrays, levels_cut);
    whole = std::exchange(planes, std::vector<of_scene::Planes<>>(planes.size()));
    arrays.add_replicated_set("plane", whole.front().planes.size());
    for (std::size_t l = 0; l < planes.size(); ++l) {
      const std::string of_planes = "planes[" + std::to_string(l) + "].",
                        node = "level[" + std::to_string(l) + "].node";
      arrays.add(of_planes + "stiffness", node, planes[l].stiffness);
      if (!is_solved(l)) continue;
      arrays.add(of_planes + "planes", "plane", planes[l].planes.contents());
      arrays.add(of_planes + "areas", node, planes[l].areas.contents());
    }
  }
  template <class Part>
  void fill(Part& part) {
    DistributedArrays& arrays = part.arrays;
    coarser.fill(arrays, part.levels);
    for (std::size_t l = 0; l < planes.size(); ++l) {
      if (!is_solved(l)) continue;
      arrays.fill(planes[l].planes.contents(), whole[l].planes);
      arrays.fill(planes[l].areas.contents(), whole[l].areas);
      planes[l].contact.resize(1);
    }
  }
  template <class Each>
  void print(const Digests<Each>& digests) const {
    coarser.print(digests);
    for (const auto& of_level : planes) {
      digests.print("planes", of_level.stiffness, [](const auto& node, int k) -> double { return node.K()(k, 2); });
    }
  }

 private:
  /// Whether equilibrium is sought on a level.
  [[nodiscard]] bool is_solved(std::size_t l) const { return l <= coarser.parts.size(); }
};

struct Options {
  std::size_t levels, planes;
  int replicate;
};

void run(const Ranks& ranks, Index cells, const Options& options, bool is_ordinary) {
  const auto& [levels, with_planes, replicate] = options;
  const Body body = standing_cube(cells, levels);
  SolverSettings settings = settings_of_the_cube();
  settings.nested = levels > 1;
  if (levels > 1) settings.newton.preconditioner.kind = Preconditioner::multigrid;
  const auto note = [&](Whole& whole, const Body& of) { note_planes(whole, of, settings); };
  Contact contact{{},
                  ranks.is_first(),
                  replicate,
                  settings,
                  {coarser_meshes<Whole>(body, settings, note)},
                  planes_of(body, settings)};
  contact.planes.resize(std::min(contact.planes.size(), with_planes));
  Whole whole(body, settings);
  note(whole, body);
  if (is_ordinary) return run_ordinary(whole, contact);
  run_on_ranks(ranks, of_scene::halos, whole, contact);
}

}  // namespace

int main(int argc, char** argv) {
  const Options options{static_cast<std::size_t>(asked(argc, argv, "--levels", 1)),
                        static_cast<std::size_t>(asked(argc, argv, "--planes", 99)),
                        asked(argc, argv, "--replicate", 0)};
  return run_as_asked(argc, argv, [&](const Ranks& ranks, Index cells, bool /*patches*/, bool ordinary) {
    run(ranks, cells, options, ordinary);
  });
}
