// motion_on_ranks: motion by the solvers of several ranks, for a cube whose nodes fly apart while its upper plate comes
// down, with poisoned ghosts; all that they hand out.
//
//   --scene NAME      implicit_dynamics (where none is given) or explicit_dynamics
//   --cells N         along each side (default 12)
//   --levels N        multigrid over so many meshes at most (default 1: block Jacobi, of irregular tets)
//   --replicate N     coarser meshes of more nodes are cut, too
//   --precision NAME  float or double, of explicit steps
//   --seed N          of velocities
//   --iteration 1     says what an iteration sends, before the first step
//   --ordinary 1      by the ordinary solver of the scene, in one process
#include <fem/dynamics/explicit.h>
#include <fem/dynamics/explicit_on_ranks.h>
#include <fem/solver/solvers/scene_solvers.h>
#include <fem/solver/solvers/solvers_on_ranks.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "named_objects.h"
#include "newton_runs.h"
#include "printed_state.h"

namespace {

using namespace physgen;
using namespace physgen::fem;

std::vector<Point> random_velocities(std::size_t nodes, unsigned seed, double deviation) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> speed(0, deviation);  // [m/s]
  std::vector<Point> velocities(nodes);
  for (Point& velocity : velocities) {
    for (double& component : velocity) component = speed(random);
  }
  return velocities;
}

void print(const NewtonResult& result, const MotionMeasure& measure) {
  std::printf("moved status %d steps %d iterations %d residual %a energy %a smallest %a reaction %a\n",
              static_cast<int>(result.status), result.steps, result.iterations, result.residual, result.energy,
              result.smallest_J, result.reaction);
  std::printf("kinetic %a elastic %a momentum %a %a %a\n", measure.kinetic, measure.elastic, measure.momentum[0],
              measure.momentum[1], measure.momentum[2]);
}

/// The first rank has all values, and others have none.
void print_state(const Ranks& ranks, DynamicSolver& solver) {
  const auto positions = solver.positions(), velocities = solver.velocities(), forces = solver.forces();
  const auto stresses = solver.stresses();
  const bool has_none = positions.empty() && velocities.empty() && forces.empty() && stresses.empty();
  if (has_none == ranks.is_first()) ranks.fail("values are on a wrong rank");
  if (!ranks.is_first()) return;
  std::printf("positions %s velocities %s forces %s stresses %s\n", digest_of(positions).c_str(),
              digest_of(velocities).c_str(), digest_of(forces).c_str(), digest_of(stresses).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const bool is_explicit = asked_word(argc, argv, "--scene", "implicit_dynamics") == "explicit_dynamics";
  const auto levels = static_cast<std::size_t>(asked(argc, argv, "--levels", 1));
  const auto most = replicated(asked(argc, argv, "--replicate", 0));
  DynamicSettings settings{settings_of_the_cube(), 1200, 3};
  if (is_explicit) settings.solver.material = "neo-hookean";
  if (levels > 1) settings.solver.newton.preconditioner.kind = Preconditioner::multigrid;
  if (asked_word(argc, argv, "--precision", "float") == "double") {
    settings.solver.precision = TangentPrecision::float64;
  }
  const int steps = is_explicit ? 20 : 3;
  const double length = is_explicit ? 1e-4 : 2e-3, load = is_explicit ? 0.01 : 0.1;  // [s], of each step
  return run_as_asked(argc, argv, [&](const Ranks& ranks, Index cells, bool patches, bool ordinary) {
    const Body body = pressed_cube(cells, patches, levels);
    const auto make = [&]() -> std::unique_ptr<DynamicSolver> {
      const DistributedOptions options{.poisons_stale_ghosts = true};
      if (is_explicit) {
        return ordinary ? make_explicit_solver(body.levels.front(), body.loading, settings)
                        : make_explicit_solver_on_ranks(ranks, body.levels.front(), body.loading, settings, options);
      }
      return ordinary ? make_scene_implicit_solver(body.levels, body.loading, settings)
                      : make_implicit_solver_on_ranks(ranks, body.levels, body.loading, settings, most, options);
    };
    const auto traffic = [&](DynamicSolver& solver) {
      return ordinary ? Traffic() : dynamic_cast<MotionOnRanks&>(solver).traffic();
    };
    auto solver = make();
    solver->set_velocities(random_velocities(body.levels.front().rest.size(),
                                             static_cast<unsigned>(asked(argc, argv, "--seed", 4)),
                                             is_explicit ? 0.5 : 0.05));
    if (!ordinary && asked(argc, argv, "--iteration", 0) != 0) {
      print_traffic(ranks, "an iteration", dynamic_cast<MotionOnRanks&>(*solver).traffic_of_iteration());
    }
    const auto step = [&](int number) {
      const Traffic before = traffic(*solver);
      const NewtonResult result = solver->step(length, load * number);
      const MotionMeasure measure = solver->measure();
      if (ranks.is_first()) print(result, measure);
      if (!ordinary) print_traffic(ranks, "a step", traffic(*solver) - before);
    };
    for (int k = 1; k <= steps; ++k) step(k);
    print_state(ranks, *solver);
    if (!ordinary) check_named(ranks, *solver, body.levels.front().mesh.tets.size());
    // Another goes on from what was handed out.
    const std::vector<Point> positions = solver->positions(), velocities = solver->velocities();
    solver = make();
    solver->set_positions(positions);
    solver->set_velocities(velocities);
    step(steps);
    print_state(ranks, *solver);
    if (!ordinary) print_unknown(ranks, dynamic_cast<MotionOnRanks&>(*solver));
  });
}
