// newton: the solver's own Newton's method of the scene quasistatic, for a cube of irregular tets that is pressed
// between plates, preconditioned by the inverses of nodes' blocks or by multigrid, on as many ranks as it is started
// with.
//
//   --cells N      along each side (default 12)
//   --levels N     multigrid over so many meshes of regular tets
//   --patches 1    volumes are averaged over patches of tets
//   --ordinary 1   one process by the solver's ordinary way
#include <quasistatic.halos.h>
#include <quasistatic.scene.h>
#include <scenes/quasistatic.h>

#include <type_traits>

#include "newton_runs.h"

namespace {

using namespace physgen;
using namespace physgen::fem;
namespace of_scene = scenes::quasistatic_scene;

struct Newton : NothingBesides {
  SolverSettings settings = settings_of_the_cube();

  template <class On, class Groups>
  NewtonResult solve(On& on, Groups& groups, const Report& report) {
    NoArrays none;
    auto solver = solver_program<float, StoredAsComputed, AssembledOnMeshes>(
        on, settings, material_of_the_cube(settings), groups.facts,
        SolverGroups{groups.body, groups.patches, none, groups.chunk, groups.levels, none, none, none, none,
                     groups.krylov});
    return solver.solve_to(1, [&](std::size_t /*level*/, const NewtonStep& step) { report(step); });
  }
};

/// @tparam Patches over which volumes are averaged, or NoArrays
template <class Patches>
void run(const Ranks& ranks, Index cells, std::size_t levels, bool is_ordinary) {
  Newton newton;
  if (levels > 1) newton.settings.newton.preconditioner.kind = Preconditioner::multigrid;
  SceneGroups<of_scene::Body<>, Patches, of_scene::Chunk<>, of_scene::Level<>, of_scene::Krylov<>> whole(
      pressed_cube(cells, !std::is_same_v<Patches, NoArrays>, levels), newton.settings);
  if (is_ordinary) return run_ordinary(whole, newton);
  run_on_ranks(ranks, of_scene::halos, whole, newton);
}

}  // namespace

int main(int argc, char** argv) {
  const auto levels = static_cast<std::size_t>(asked(argc, argv, "--levels", 1));
  return run_as_asked(argc, argv, [levels](const Ranks& ranks, Index cells, bool patches, bool ordinary) {
    (patches ? run<of_scene::Patches<>> : run<NoArrays>)(ranks, cells, levels, ordinary);
  });
}
