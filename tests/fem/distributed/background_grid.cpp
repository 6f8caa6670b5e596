// background_grid: as newton, for a mesh of irregular tets that has no coarser ones, with multigrid on a background
// grid, of the scene everything.
//
//   --cells N      along each side (default 12)
//   --ordinary 1   one process by the solver's ordinary way
#include <everything.halos.h>
#include <everything.scene.h>
#include <fem/solver/hierarchy/background_grid.h>
#include <scenes/everything.h>

#include "newton_runs.h"

namespace {

using namespace physgen;
using namespace physgen::fem;
namespace of_scene = scenes::everything_scene;

struct OnGrid : NothingBesides {
  SolverSettings settings = settings_of_the_cube();

  template <class On, class Groups>
  NewtonResult solve(On& on, Groups& groups, const Report& report) {
    NoArrays none;
    auto solver = solver_program<float, StoredAsComputed, AssembledAnywhere>(
        on, settings, material_of_the_cube(settings), groups.facts,
        SolverGroups{groups.body, groups.patches, none, groups.chunk, groups.levels, none, none, none, none,
                     groups.krylov});
    return solver.solve_to(1, [&](std::size_t /*level*/, const NewtonStep& step) { report(step); });
  }
};

void run(const Ranks& ranks, Index cells, bool is_ordinary) {
  Body body = pressed_cube(cells, false);
  add_background_grid(body.levels);
  OnGrid program;
  program.settings.newton.preconditioner.kind = Preconditioner::multigrid;
  SceneGroups<of_scene::Body<>, NoArrays, of_scene::Chunk<>, of_scene::Level<>, of_scene::Krylov<>, AssembledAnywhere>
      whole(body, program.settings);
  if (is_ordinary) return run_ordinary(whole, program);
  run_on_ranks(ranks, of_scene::halos, whole, program);
}

}  // namespace

int main(int argc, char** argv) {
  return run_as_asked(argc, argv, [](const Ranks& ranks, Index cells, bool /*patches*/, bool ordinary) {
    run(ranks, cells, ordinary);
  });
}
