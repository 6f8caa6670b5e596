// newton_by_tets: as newton, of the scene quasistatic_matrix_free: tangents are not assembled, and volumes are averaged
// over patches of tets.
//
//   --cells N      along each side (default 12)
//   --ordinary 1   one process by the solver's ordinary way
#include <quasistatic_matrix_free.halos.h>
#include <quasistatic_matrix_free.scene.h>
#include <scenes/quasistatic_matrix_free.h>

#include "newton_runs.h"

namespace {

using namespace physgen;
using namespace physgen::fem;
namespace of_scene = scenes::quasistatic_matrix_free_scene;

struct Newton : NothingBesides {
  SolverSettings settings = settings_of_the_cube();

  Newton() { settings.newton.product = Product::matrix_free; }
  template <class On, class Groups>
  NewtonResult solve(On& on, Groups& groups, const Report& report) {
    NoArrays none;
    auto solver = solver_program<float, StoredAsComputed, ByTets>(
        on, settings, material_of_the_cube(settings), groups.facts,
        SolverGroups{groups.body, groups.patches, none, groups.chunk, groups.levels, none, none, none, none,
                     groups.krylov});
    return solver.solve_to(1, [&](std::size_t /*level*/, const NewtonStep& step) { report(step); });
  }
};

void run(const Ranks& ranks, Index cells, bool is_ordinary) {
  Newton newton;
  SceneGroups<of_scene::Body<>, of_scene::Patches<>, of_scene::Chunk<>, of_scene::Level<>, of_scene::Krylov<>, ByTets>
      whole(pressed_cube(cells, true), newton.settings);
  if (is_ordinary) return run_ordinary(whole, newton);
  run_on_ranks(ranks, of_scene::halos, whole, newton);
}

}  // namespace

int main(int argc, char** argv) {
  return run_as_asked(argc, argv, [](const Ranks& ranks, Index cells, bool /*patches*/, bool ordinary) {
    run(ranks, cells, ordinary);
  });
}
