// newton: the solver's own Newton's method of the scene quasistatic, for a cube of irregular tets that is pressed
// between plates, preconditioned by the inverses of nodes' blocks, on as many ranks as it is started with. It prints
// what each step ends with, digests of positions, forces and the last linear step, and what has crossed between ranks.
//
//   --cells N      along each side (default 12)
//   --ordinary 1   one process by the solver's ordinary way: its executor, arrays that are made of the whole mesh, and
//                  chunks of tets
#include <fem/solver/levels/level_halos.h>
#include <quasistatic.halos.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "digest.h"
#include "part_of_equilibrium.h"

namespace {

using namespace physgen;
using namespace physgen::fem;

Body pressed_cube(Index cells) {
  Body body = make_cube(
      cells, side, false, 0.1, [](const Point& x) -> std::uint8_t { return x[2] == 0 || x[2] == side ? 7 : 0; },
      [](const Point& x) { return x[2] == side ? Point{0.004, 0, -0.2 * side} : Point{}; });
  body.levels.resize(1);
  return body;
}

SolverSettings settings_of_the_scene() {
  SolverSettings settings;
  settings.material = "stable-neo-hookean";
  settings.youngs_modulus = 1e4;
  settings.poissons_ratio = 0.45;
  settings.precision = TangentPrecision::float32;
  settings.nested = false;
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  return settings;
}

/// Called on all ranks. @param report called after every step
template <class On, class Groups, class Report>
NewtonResult solve(On& on, Groups& groups, const SolverSettings& settings, const Report& report) {
  NoArrays none;
  auto solver = solver_program<float, StoredAsComputed, AssembledOnMeshes>(
      on, settings, StableNeoHookean<double>::from(settings.youngs_modulus, settings.poissons_ratio), groups.facts,
      SolverGroups{groups.body, groups.patches, none, groups.chunk, groups.levels, none, none, none, none,
                   groups.krylov});
  return solver.solve_to(1, [&](std::size_t /*level*/, const NewtonStep& step) { report(step); });
}

void print(const NewtonStep& step) {
  std::printf("step %d iterations %d halvings %d filtered %d residual %a energy %a smallest %a\n", step.number,
              step.iterations, step.halvings, step.filtered ? 1 : 0, step.residual, step.energy, step.smallest_J);
}
template <class State>
void print(const NewtonResult& result, const State& linear) {
  std::printf("result status %d steps %d iterations %d bisections %d residual %a energy %a smallest %a reaction %a\n",
              static_cast<int>(result.status), result.steps, result.iterations, result.bisections, result.residual,
              result.energy, result.smallest_J, result.reaction);
  std::printf("linear iterations %d status %d rz %a first %a alpha %a beta %a\n", int{linear.iterations},
              int{linear.status}, double{linear.rz}, double{linear.rz_first}, double{linear.alpha},
              double{linear.beta});
}

/// Prints the digests of the arrays that a solve leaves. @param each each(array, visit) calls visit(view) for blocks of
/// objects in ascending order
template <class Groups, class Each>
void print_digests(const Groups& groups, bool is_first, const Each& each) {
  const auto print = [&](const char* name, const auto& array, const auto& element) {
    Digest digest;
    each(array, [&](const auto& view) {
      for (index_t i = 0; i < view.size(); ++i) {
        for (int k = 0; k < 3; ++k) digest.add(element(view[i], k));
      }
    });
    if (is_first) std::printf("%s %s\n", name, digest.text().c_str());
  };
  print("positions", groups.body.positions, [](const auto& node, int k) -> double { return node.x()[k]; });
  print("forces", groups.body.forces, [](const auto& node, int k) -> double { return node.f()[k]; });
  print("step", groups.krylov.step, [](const auto& node, int k) -> double { return node.dx()[k]; });
  print("stiffness", groups.levels.front().node_stiffness,
        [](const auto& node, int k) -> double { return node.K()(k, 0); });
}

void run_ordinary(WholeEquilibrium& groups, const SolverSettings& settings) {
  HostExecutor on;
  const NewtonResult result = solve(on, groups, settings, [](const NewtonStep& step) { print(step); });
  print(result, on.value(groups.krylov.state));
  print_digests(groups, true, [](const auto& array, const auto& visit) { visit(array.const_view()); });
  std::printf("chunks %zu\n", groups.facts.chunks.size());
}

void run_on_ranks(const Ranks& ranks, const WholeEquilibrium& whole, const SolverSettings& settings) {
  const std::vector<HaloUse> rows = with_halos_of_levels(scenes::quasistatic_scene::halos);
  PartOfEquilibrium groups(ranks, rows, whole);
  DistributedExecutor<HostExecutor> on(ranks, groups.arrays, {.poisons_stale_ghosts = true});
  Traffic before = on.traffic();
  const NewtonResult result = solve(on, groups, settings, [&](const NewtonStep& step) {
    const Traffic now = on.traffic();
    if (ranks.is_first()) {
      print(step);
      std::printf("traffic exchanges %lld gathers %lld\n", static_cast<long long>(now.exchanges - before.exchanges),
                  static_cast<long long>(now.gathers - before.gathers));
    }
    before = now;
  });
  const auto linear = on.value(groups.krylov.state);
  if (ranks.is_first()) print(result, linear);
  print_digests(groups, ranks.is_first(), [&](const auto& array, const auto& visit) {
    groups.arrays.each_block(array, [&](index_t /*first*/, const auto& view) { visit(view); });
  });
  if (!ranks.is_first()) return;
  for (const std::string& kernel : on.unknown_kernels()) std::printf("unknown %s\n", kernel.c_str());
}

void run(int argc, char** argv) {
  const Ranks ranks(argc, argv);
  Index cells = 12;
  bool is_ordinary = false;
  for (int a = 1; a + 1 < argc; a += 2) {
    if (argv[a] == std::string("--cells")) cells = std::atoi(argv[a + 1]);
    if (argv[a] == std::string("--ordinary")) is_ordinary = std::atoi(argv[a + 1]) != 0;
  }
  ranks.guard([&] {
    const Body body = pressed_cube(cells);
    const SolverSettings settings = settings_of_the_scene();
    WholeEquilibrium whole(body, settings);
    if (is_ordinary) return run_ordinary(whole, settings);
    run_on_ranks(ranks, whole, settings);
  });
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
