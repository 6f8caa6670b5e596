// implicit_steps: time steps of the scene implicit_dynamics, for a cube whose nodes fly apart while its upper plate
// comes down, on as many ranks as it is started with: of irregular tets with block Jacobi, or of regular ones with
// multigrid.
//
//   --cells N      along each side (default 12)
//   --levels N     multigrid over so many meshes at most (default 1: none)
//   --ordinary 1   one process by the solver's ordinary way
#include <fem/solver/loads/inertia_arrays.h>
#include <fem/solver/loads/loading_arrays.h>
#include <fem/solver/masses.h>
#include <implicit_dynamics.halos.h>
#include <implicit_dynamics.scene.h>
#include <scenes/implicit_dynamics.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "newton_runs.h"

namespace {

using namespace physgen;
using namespace physgen::fem;
namespace of_scene = scenes::implicit_dynamics_scene;

constexpr double density = 1200, damping = 3, length = 2e-3;  // [kg/m^3], [1/s], [s]

/// The masses of each level's nodes, and random velocities of the finest.
std::vector<of_scene::Inertia<>> whole_inertia(const Body& body, std::vector<double> masses) {
  std::vector<of_scene::Inertia<>> levels;
  for (std::size_t l = 0; l < body.levels.size(); ++l) {
    if (l > 0) masses = coarsened_masses(masses, body.levels[l - 1].parents, body.levels[l].mesh.nodes);
    levels.push_back(InertiaOver<of_scene::Inertia<>>(masses, l == 0));
  }
  of_scene::Inertia<>& inertia = levels.front();
  std::mt19937_64 random(4);
  std::normal_distribution<double> speed(0, 0.05);
  for (index_t n = 0; n < inertia.velocities.size(); ++n) {
    for (int k = 0; k < 3; ++k) inertia.velocities.view()[n].v()[k] = speed(random);
  }
  inertia.measured.view()[0].elastic() = 0;
  return levels;
}

struct ImplicitSteps : NothingBesides {
  bool is_first;                             ///< whether this rank prints
  std::vector<of_scene::Inertia<>> inertia;  ///< of each level
  SolverSettings settings;
  std::vector<of_scene::Inertia<>> whole{};  ///< where `inertia` is a rank's part of it

  template <class On, class Groups>
  NewtonResult solve(On& on, Groups& groups, const Report& report) {
    NewtonResult result;
    for (int k = 1; k <= 3; ++k) {
      const TimeStep step{length, 0.1 * k, damping};
      result = scenes::implicit_dynamics::program(on, groups.body, groups.patches, groups.chunk, groups.levels, inertia,
                                                  groups.krylov, material_of_the_cube(settings), settings, groups.facts,
                                                  step);
      const auto measured = on.value(inertia.front().measured);
      if (is_first) std::printf("status %d kinetic %a\n", static_cast<int>(result.status), double{measured.kinetic});
      report({.number = k,
              .residual = result.residual,
              .energy = result.energy,
              .smallest_J = result.smallest_J,
              .iterations = result.iterations});
      settings.newton.start_load = step.load;
      settings.newton.last_reaction = result.reaction;
    }
    return result;
  }

  void add_to(DistributedArrays& arrays) {
    whole = std::exchange(inertia, std::vector<of_scene::Inertia<>>(inertia.size()));
    arrays.add_set("moving_node", whole.front().velocities.size());
    arrays.same_set("moving_node", "node");
    arrays.add("inertia.centres", "moving_node", inertia.front().centres);
    arrays.add("inertia.velocities", "moving_node", inertia.front().velocities);
    for (std::size_t l = 0; l < inertia.size(); ++l) {
      const std::string number = "[" + std::to_string(l) + "].";
      arrays.add("inertia" + number + "masses", "level" + number + "node", inertia[l].masses.contents());
    }
  }
  template <class Part>
  void fill(Part& part) {
    DistributedArrays& arrays = part.arrays;
    for (std::size_t l = 0; l < inertia.size(); ++l) arrays.fill(inertia[l].masses.contents(), whole[l].masses);
    arrays.fill(inertia.front().velocities, whole.front().velocities);
    inertia.front().measured = whole.front().measured;
  }
  template <class Each>
  void print(const Digests<Each>& digests) const {
    digests.print("velocities", inertia.front().velocities,
                  [](const auto& node, int k) -> double { return node.v()[k]; });
  }
};

void run(const Ranks& ranks, Index cells, std::size_t levels, bool is_ordinary) {
  const Body body = pressed_cube(cells, true, levels);
  const MeshLevel& level = body.levels.front();
  const std::vector<double> masses = lumped_masses(level.mesh, level.rest, density);
  ImplicitSteps steps{{}, ranks.is_first(), whole_inertia(body, masses), settings_of_the_cube()};
  if (levels > 1) steps.settings.newton.preconditioner.kind = Preconditioner::multigrid;
  SceneGroups<of_scene::Body<>, of_scene::Patches<>, of_scene::Chunk<>, of_scene::Level<>, of_scene::Krylov<>> whole(
      body, steps.settings);
  whole.facts.node_stiffness =
      node_stiffness(steps.settings, false, whole.spacing) + std::ranges::max(masses) * (1 / length + damping) / length;
  if (is_ordinary) return run_ordinary(whole, steps);
  run_on_ranks(ranks, of_scene::halos, whole, steps);
}

}  // namespace

int main(int argc, char** argv) {
  const auto levels = static_cast<std::size_t>(asked(argc, argv, "--levels", 1));
  return run_as_asked(argc, argv, [levels](const Ranks& ranks, Index cells, bool /*patches*/, bool ordinary) {
    run(ranks, cells, levels, ordinary);
  });
}
