// solver_on_ranks: equilibria of a scene by the solver of several ranks, for a cube that is pressed
// between plates in two loads, with poisoned ghosts; all that it hands out.
//
//   --cells N         along each side (default 12); levels halve them as long as their number is even
//   --levels N        so many of them at most; 1: of irregular tets
//   --scene NAME      quasistatic where none is given; or linear_elastic, whose --product is assembled or matrix-free
//   --precision NAME  half, float (where none is given) or double
//   --percent N       Poisson's ratio (default 45)
//   --preconditioner  multigrid, block-jacobi or none
//   --nested 0        on one mesh
//   --replicate N     coarser meshes of more nodes are cut, too
//   --restored 1      a second solver goes on behind the first load
//   --iteration 1     says what an iteration sends, before the first load, and what each Newton step has sent
//   --ordinary 1      by the ordinary solver of the scene, in one process
//   --device cuda     on GPUs
//   --nccl 0          through pinned memory and MPI
#include <fem/solver/solvers/scene_solvers.h>
#include <fem/solver/solvers/solvers_on_ranks.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "newton_runs.h"
#include "printed_state.h"

namespace {

using namespace physgen;
using namespace physgen::fem;

/// The first rank has all values, and others have none.
void print_state(const Ranks& ranks, EquilibriumSolver& solver) {
  const auto positions = solver.positions(), forces = solver.forces();
  const auto stresses = solver.stresses();
  std::string text = "load " + std::to_string(solver.load()) + " positions " + digest_of(positions) + " forces " +
                     digest_of(forces) + " stresses " + digest_of(stresses);
  const auto coarser = solver.coarser_equilibrium();
  if (coarser) text += " coarser " + digest_of(coarser->positions) + " forces " + digest_of(coarser->forces);
  const bool has_none = positions.empty() && forces.empty() && stresses.empty() &&
                        (!coarser || (coarser->positions.empty() && coarser->forces.empty()));
  if (has_none == ranks.is_first()) ranks.fail("values are on a wrong rank");
  if (ranks.is_first()) std::printf("%s\n", text.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  SolverSettings settings = settings_of_the_cube();
  settings.poissons_ratio = 0.01 * asked(argc, argv, "--percent", 45);
  settings.nested = asked(argc, argv, "--nested", 1) != 0;
  const std::string preconditioner = asked_word(argc, argv, "--preconditioner", "multigrid");
  for (const PreconditionerRow& row : preconditioner_rows) {
    if (preconditioner == row.name) settings.newton.preconditioner.kind = row.kind;
  }
  if (asked_word(argc, argv, "--device", "cpu") == "cuda") settings.device = Device::cuda;
  const bool uses_nccl = asked(argc, argv, "--nccl", 1) != 0;
  if (asked_word(argc, argv, "--product", "assembled") == "matrix-free") settings.newton.product = Product::matrix_free;
  const std::string precision = asked_word(argc, argv, "--precision", "float");
  if (precision == "half") settings.precision = TangentPrecision::half;
  if (precision == "double") settings.precision = TangentPrecision::float64;
  const std::string scene = asked_word(argc, argv, "--scene", "quasistatic");
  for (const SceneRow& row : equilibrium_scenes()) {
    if (scene != row.name) continue;
    settings.material = row.material;
    settings.newton.product = row.assembled ? Product::assembled : Product::matrix_free;
  }
  const int replicate = asked(argc, argv, "--replicate", 0);
  const bool is_restored = asked(argc, argv, "--restored", 0) != 0;
  return run_as_asked(argc, argv, [&](const Ranks& ranks, Index cells, bool patches, bool ordinary) {
    const Body body = pressed_cube(cells, patches, static_cast<std::size_t>(asked(argc, argv, "--levels", 16)));
    const DistributedOptions options{.poisons_stale_ghosts = true, .uses_nccl = uses_nccl};
    const auto make = [&]() -> std::unique_ptr<EquilibriumSolver> {
      if (scene == "linear_elastic") {
        if (ordinary) return make_linear_solver(body.levels, body.loading, settings);
        return make_linear_solver_on_ranks(ranks, body.levels, body.loading, settings, replicated(replicate), options);
      }
      if (ordinary) return make_scene_solver(scene, body.levels, body.loading, settings);
      return make_solver_on_ranks(ranks, scene, body.levels, body.loading, settings, replicated(replicate), options);
    };
    auto solver = make();
    const bool tells = asked(argc, argv, "--iteration", 0) != 0 && !ordinary;
    const auto on_ranks = [&]() -> SolverOnRanks& { return dynamic_cast<SolverOnRanks&>(*solver); };
    if (tells) print_traffic(ranks, "an iteration", on_ranks().traffic_of_iteration());
    Traffic before = tells ? on_ranks().traffic() : Traffic();
    for (const double load : {0.4, 1.0}) {
      const NewtonResult result = solver->solve_to(load, [&](std::size_t level, const NewtonStep& step) {
        if (tells) {
          print_traffic(ranks, "a step", on_ranks().traffic() - before);
          before = on_ranks().traffic();
        }
        if (!ranks.is_first()) return;
        std::printf("level %zu\n", level);
        print(step);
      });
      if (ranks.is_first()) {
        std::printf("status %d residual %a energy %a reaction %a\n", static_cast<int>(result.status), result.residual,
                    result.energy, result.reaction);
      }
      print_state(ranks, *solver);
      if (!is_restored || load == 1) continue;
      const SolverState state = solver->state();
      solver = make();
      solver->restore(state);
    }
    if (!ordinary) print_unknown(ranks, on_ranks());
  });
}
