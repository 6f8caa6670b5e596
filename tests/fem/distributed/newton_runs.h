// Runs of Newton's method that are compared: by the solver's ordinary way in one process, with its executor, arrays
// that are made of the whole mesh, and chunks of tets; and on several ranks. They print what each step ends with,
// digests of arrays, and what has crossed between ranks.
#pragma once

#include <fem/materials/stable_neo_hookean.h>
#include <fem/solver/levels/level_halos.h>
#include <fem/solver/solvers/part_of_equilibrium.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <optional>
#include <string>

#include "../solver/scene_groups.h"
#include "digest.h"

namespace physgen::fem {

/// A cube that is pressed between plates: on one mesh of irregular tets, or on so many meshes that halve cells.
inline Body pressed_cube(Index cells, bool patches, std::size_t levels = 1) {
  Body body = make_cube(
      cells, side, patches, levels == 1 ? 0.1 : 0,
      [](const Point& x) -> std::uint8_t { return x[2] == 0 || x[2] == side ? 7 : 0; },
      [](const Point& x) { return x[2] == side ? Point{0.004, 0, -0.2 * side} : Point{}; });
  body.levels.resize(std::min(levels, body.levels.size()));
  return body;
}

/// Of this cube, preconditioned by the inverses of nodes' blocks.
inline SolverSettings settings_of_the_cube() {
  SolverSettings settings;
  settings.material = "stable-neo-hookean";
  settings.youngs_modulus = 1e4;
  settings.poissons_ratio = 0.45;
  settings.precision = TangentPrecision::float32;
  settings.nested = false;
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  return settings;
}
inline StableNeoHookean<double> material_of_the_cube(const SolverSettings& settings) {
  return StableNeoHookean<double>::from(settings.youngs_modulus, settings.poissons_ratio);
}

/// Called after every step of Newton's method.
using Report = std::function<void(const NewtonStep&)>;

inline void print(const NewtonStep& step) {
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

/// Prints digests. @param each each(array, visit) calls visit(view) for blocks of objects in ascending order
template <class Each>
struct Digests {
  bool is_first;  ///< whether this rank prints
  Each each;

  /// @param element element(object, k) for k = 0, 1, 2
  template <class Array, class Element>
  void print(const char* name, const Array& array, const Element& element) const {
    Digest digest;
    each(array, [&](const auto& view) {
      for (index_t i = 0; i < view.size(); ++i) {
        for (int k = 0; k < 3; ++k) digest.add(element(view[i], k));
      }
    });
    if (is_first) std::printf("%s %s\n", name, digest.text().c_str());
  }
  /// Of the arrays that every solve leaves.
  template <class Groups>
  void print_groups(const Groups& groups) const {
    print("positions", groups.body.positions, [](const auto& node, int k) -> double { return node.x()[k]; });
    print("forces", groups.body.forces, [](const auto& node, int k) -> double { return node.f()[k]; });
    print("step", groups.krylov.step, [](const auto& node, int k) -> double { return node.dx()[k]; });
    print("stiffness", groups.levels.front().node_stiffness,
          [](const auto& node, int k) -> double { return node.K()(k, 0); });
  }
};
template <class Each>
Digests(bool, Each) -> Digests<Each>;

/// What a program has besides the groups of PartOfEquilibrium: nothing. Programs that have more hide these.
struct NothingBesides {
  /// How many of the levels are cut.
  [[nodiscard]] std::size_t cut(std::span<const LevelGraph> /*graphs*/, int /*ranks*/) const { return 1; }
  /// The table of kernels, before it is used.
  void change(std::vector<HaloUse>& /*rows*/) const {}
  /// Before the arrays are cut, and after it.
  void add_to(DistributedArrays& /*arrays*/) {}
  template <class Part>
  void fill(Part& /*part*/) {}
  template <class Each>
  void print(const Digests<Each>& /*digests*/) const {}
};

/// @param program program.solve(on, groups, report), and what NothingBesides has
template <class Groups, class Program>
void run_ordinary(Groups& groups, Program& program) {
  HostExecutor on;
  const NewtonResult result = program.solve(on, groups, [](const NewtonStep& step) { print(step); });
  print(result, on.value(groups.krylov.state));
  const Digests digests{true, [](const auto& array, const auto& visit) { visit(array.const_view()); }};
  digests.print_groups(groups);
  program.print(digests);
  std::printf("chunks %zu\n", groups.facts.chunks.size());
}

/// @param scene the table of kernels of its scene
template <class Groups, class Program>
void run_on_ranks(const Ranks& ranks, HaloUses scene, const Groups& whole, Program& program) {
  std::vector<HaloUse> rows = with_halos_of_levels(scene);
  program.change(rows);
  PartOfEquilibrium groups(ranks, rows, whole, program.cut(whole.graphs, ranks.count()),
                           [&](auto& part) { program.add_to(part.arrays); });
  program.fill(groups);
  DistributedExecutor<HostExecutor> on(ranks, groups.arrays, {.poisons_stale_ghosts = true});
  Traffic before = on.traffic();
  const NewtonResult result = program.solve(on, groups, [&](const NewtonStep& step) {
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
  const Digests digests{ranks.is_first(), [&](const auto& array, const auto& visit) {
                          groups.arrays.each_block(array, [&](index_t /*first*/, const auto& view) { visit(view); });
                        }};
  digests.print_groups(groups);
  program.print(digests);
  if (!ranks.is_first()) return;
  for (const std::string& kernel : on.unknown_kernels()) std::printf("unknown %s\n", kernel.c_str());
}

/// The number behind an option of the command line.
inline int asked(int argc, char** argv, const std::string& option, int otherwise) {
  for (int a = 1; a + 1 < argc; a += 2) {
    if (argv[a] == option) return std::atoi(argv[a + 1]);
  }
  return otherwise;
}
/// `most` as levels_that_are_cut() takes it. @param most 0: it says itself
inline std::optional<index_t> replicated(int most) { return most > 0 ? std::optional<index_t>(most) : std::nullopt; }
/// What main() does. @param run run(ranks, cells, patches, ordinary) with what the command line says
template <class Run>
int run_as_asked(int argc, char** argv, const Run& run) {
  try {
    const Ranks ranks(argc, argv);
    const Index cells = asked(argc, argv, "--cells", 12);
    const bool patches = asked(argc, argv, "--patches", 0) != 0, ordinary = asked(argc, argv, "--ordinary", 0) != 0;
    ranks.guard([&] { run(ranks, cells, patches, ordinary); });
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

}  // namespace physgen::fem
