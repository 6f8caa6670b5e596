// nested_newton: the solver's own Newton's method of the scene quasistatic with multigrid, as the solver does it unless
// it is told otherwise: blocks of the preconditioner are stored in half, and equilibrium is sought on coarser meshes
// first, where there are more than the two coarsest. For a cube that is pressed between plates, on as many ranks as it
// is started with.
//
//   --cells N      along each side (default 12); levels halve them as long as their number is even
//   --percent N    Poisson's ratio (default 45)
//   --nested 0     on one mesh
//   --replicate N  coarser levels of more nodes are cut, too, however few blocks ranks then have of them
//   --steps N      of Newton's method at most
//   --without N    row N of those that the scene's table lacks says nothing; --rows 1 lists them
//   --ordinary 1   one process by the solver's ordinary way
#include <quasistatic.halos.h>
#include <quasistatic.scene.h>
#include <scenes/quasistatic.h>

#include "coarser_meshes.h"

namespace {

using namespace physgen;
using namespace physgen::fem;
namespace of_scene = scenes::quasistatic_scene;
using Whole = SceneGroups<of_scene::Body<>, NoArrays, of_scene::Chunk<>, of_scene::Level<Host, float, StoredInHalf>,
                          of_scene::Krylov<>>;

struct Options {
  int percent, nested, replicate, steps, without;

  Options(int argc, char** argv)
      : percent(asked(argc, argv, "--percent", 45)),
        nested(asked(argc, argv, "--nested", 1)),
        replicate(asked(argc, argv, "--replicate", 0)),
        steps(asked(argc, argv, "--steps", 60)),
        without(asked(argc, argv, "--without", -1)) {}

  [[nodiscard]] SolverSettings settings() const {
    SolverSettings settings = settings_of_the_cube();
    settings.poissons_ratio = 0.01 * percent;
    settings.precision = TangentPrecision::half;
    settings.nested = nested != 0;
    settings.newton.preconditioner.kind = Preconditioner::multigrid;
    settings.newton.most_steps = steps;
    settings.most_bisections = 0;
    return settings;
  }
};

struct PressedCube : NothingBesides {
  const Options& options;
  bool is_first;  ///< whether this rank prints
  CoarserParts<CoarserMeshOf<Whole>> coarser;
  SolverSettings settings = options.settings();
  std::size_t levels_cut = 1;

  template <class On, class Groups>
  NewtonResult solve(On& on, Groups& groups, const Report& report) {
    NoArrays none;
    auto solver = solver_program<float, StoredInHalf, AssembledOnMeshes>(
        on, settings, material_of_the_cube(settings), groups.facts,
        SolverGroups{groups.body, groups.patches, none, groups.chunk, groups.levels, none, none, none, none,
                     groups.krylov},
        coarser.parts);
    return solver.solve_to(1, [&](std::size_t level, const NewtonStep& step) {
      if (is_first) std::printf("level %zu\n", level);
      report(step);
    });
  }

  [[nodiscard]] std::size_t cut(std::span<const LevelGraph> graphs, int ranks) {
    levels_cut = levels_that_are_cut(graphs, ranks, replicated(options.replicate));
    return levels_cut;
  }
  void change(std::vector<HaloUse>& rows) const {
    if (options.without >= 0) rows.at(std::size_t(options.without)).access = {};
  }
  void add_to(DistributedArrays& arrays) { coarser.add_to(arrays, levels_cut); }
  template <class Part>
  void fill(Part& part) {
    coarser.fill(part.arrays, part.levels);
  }
  template <class Each>
  void print(const Digests<Each>& digests) const {
    coarser.print(digests);
  }
};

void run(const Ranks& ranks, const Options& options, Index cells, bool is_ordinary) {
  const Body body = pressed_cube(cells, false, 16);
  const auto note = [](const Whole& /*whole*/, const Body& /*body*/) {};
  PressedCube cube{{}, options, ranks.is_first(), {coarser_meshes<Whole>(body, options.settings(), note)}};
  Whole whole(body, options.settings());
  if (is_ordinary) return run_ordinary(whole, cube);
  run_on_ranks(ranks, of_scene::halos, whole, cube);
}

void print_rows() {
  int number = 0;
  for (const HaloUse& row : physgen::fem::detail::halos_of_levels) {
    const char* const what = row.access.reads_others ? "reads others" : row.access.writes_own ? "writes" : "reads";
    std::printf("%d %s %d %s %s\n", number++, std::string(row.kernel).c_str(), row.view, std::string(row.field).c_str(),
                what);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (asked(argc, argv, "--rows", 0) != 0) return print_rows(), 0;
  const Options options(argc, argv);
  return run_as_asked(argc, argv, [&](const Ranks& ranks, Index cells, bool /*patches*/, bool ordinary) {
    run(ranks, options, cells, ordinary);
  });
}
