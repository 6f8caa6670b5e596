#include "scene.h"

#include <fem/mesh/boundary.h>
#include <fem/mesh/check.h>
#include <fem/mesh/flatness.h>
#include <fem/mesh/gmsh_file.h>
#include <fem/mesh/graded_cube.h>
#include <fem/mesh/material_order.h>
#include <fem/mesh/refine.h>
#include <fem/solver/hierarchy/background_grid.h>
#include <fem/solver/hierarchy/cube_levels.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "memory.h"
#include "run_bytes.h"
#include "scene_choice.h"
#include "state_windows.h"

namespace physgen::truthcube {

namespace {

using fem::Index;
using fem::MeshLevel;

constexpr double cube_side = 0.08;  // [m]

void set_plates(MeshLevel& level, const std::vector<Index>& base, const std::vector<Index>& top, TopPlate plate) {
  level.fixed.assign(level.rest.size(), 0);
  for (const Index n : base) level.fixed[static_cast<std::size_t>(n)] = 7;
  for (const Index n : top) level.fixed[static_cast<std::size_t>(n)] = plate == TopPlate::bonded ? 7 : 4;
}

/// @throw Error when a mesh whose tets are cut into 8 so often is too large for the memory or for 32-bit numbers,
/// before any of it is made
void require_refined_fits(const fem::TetMesh& mesh, int refinements) {
  LevelCounts counts;
  counts.nodes = mesh.nodes;
  counts.tets = static_cast<std::int64_t>(mesh.tets.size());
  counts.tet_edges = static_cast<std::int64_t>(mesh.edges.size());
  if (refinements == 0) return;
  std::int64_t faces = (4 * counts.tets + static_cast<std::int64_t>(fem::boundary_faces(mesh).size())) / 2;
  for (int k = 1; k <= refinements; ++k) {
    counts.nodes += counts.tet_edges;
    counts.tet_edges = 2 * counts.tet_edges + 3 * faces + counts.tets;
    faces = 4 * faces + 8 * counts.tets;
    counts.tets *= 8;
    const std::string who = "the mesh refined " + std::to_string(k) + " times",
                      remedy = "--refine " + std::to_string(k - 1) + " takes an eighth of it";
    if (!fem::fits_32_bits(static_cast<std::size_t>(counts.nodes), static_cast<std::size_t>(counts.tets))) {
      throw Error(who + " has " + std::to_string(counts.nodes) + " nodes and " + std::to_string(counts.tets) +
                  " tets, more than 32-bit numbers can count; " + remedy);
    }
    require_memory(who, bytes_of_mesh(counts), "this machine", host_memory(), remedy);
  }
}

/// @throw Error where multigrid needs a background grid, and the scene has none
void require_scene_with_grid(const Options& options, const Scene& scene) {
  const bool has_no_grid =
      options.scene == SceneKind::quasistatic || options.scene == SceneKind::quasistatic_fixed_corotated;
  if (scene.grid[0] > 0 && has_no_grid) {
    throw Error("multigrid of this mesh needs a background grid, which --scene " + name_of(scene_kinds, options.scene) +
                " does not have; add --preconditioner block-jacobi, or take --scene everything" +
                (options.is_case() ? "" : " --material " + options.solver.material) +
                " --precision float, which has one");
  }
}

}  // namespace

GivenMesh read_mesh(const Options& options, std::vector<std::string>& notes) {
  fem::ReadMesh read = fem::read_gmsh(options.mesh);
  if (const double scale = options.given_case.scale; scale != 1) {
    for (fem::Point& x : read.rest) x = {scale * x[0], scale * x[1], scale * x[2]};
  }
  if (!read.left_out_nodes.empty()) {
    notes.push_back(std::to_string(read.left_out_nodes.size()) + " nodes of " + options.mesh.string() +
                    " belong to no tet and are left out");
  }
  std::vector<Index> material_ends;
  if (const auto& named = options.given_case.material_groups; !named.empty()) {
    material_ends = fem::sort_by_material(read, named);
  }
  const fem::MeshReport report = fem::check_mesh(read.rest, read.tets);
  const auto errors = report.errors(read.node_tags, read.tet_tags);
  if (!errors.empty()) {
    std::string text = options.mesh.string() + " cannot be used:";
    for (const std::string& error : errors) text += "\n  " + error;
    throw Error(text);
  }
  for (const std::string& warning : report.warnings(read.node_tags, read.tet_tags)) notes.push_back(warning);
  std::vector<MeshLevel> levels(1);
  levels[0].mesh = fem::make_tet_mesh(static_cast<Index>(read.rest.size()), std::move(read.tets));
  levels[0].rest = std::move(read.rest);
  levels[0].material_ends = std::move(material_ends);
  require_refined_fits(levels.front().mesh, options.refinements);
  std::vector<std::vector<fem::MeshGroup>> groups{std::move(read.groups)};
  for (int k = 0; k < options.refinements; ++k) {
    if (options.is_case()) groups.insert(groups.begin(), fem::refine_groups(levels.front().mesh, groups.front()));
    fem::Refined refinement = fem::refine(levels.front().mesh, levels.front().rest);
    MeshLevel finer;
    finer.mesh = std::move(refinement.mesh);
    finer.rest = std::move(refinement.rest);
    finer.parents = std::move(refinement.parents);
    for (const Index end : levels.front().material_ends) finer.material_ends.push_back(8 * end);
    levels.insert(levels.begin(), std::move(finer));
  }
  if (options.volume == VolumeTreatment::patches) {
    for (MeshLevel& level : levels) level.patches = fem::greedy_patches(level.mesh, level.material_ends);
    for (std::size_t l = 0; l + 1 < levels.size(); ++l) {  // refined tets 8 t .. 8 t + 7 are parts of tet t
      const fem::IncidenceList& tets = levels[l].patches.patch_tets;
      for (std::size_t p = 0; p + 1 < tets.first.size(); ++p) {
        const Index tet = tets.entries[static_cast<std::size_t>(tets.first[p])].element;
        levels[l].patch_parents.push_back(levels[l + 1].patches.tet_patch[static_cast<std::size_t>(tet / 8)]);
      }
    }
  }
  return {std::move(levels), std::move(read.tet_tags), std::move(groups), {}, {}};
}

std::vector<MeshLevel> make_cube(const Options& options, std::size_t without_lists) {
  constexpr Index coarsest = 2;
  auto levels = fem::make_cube_levels_without_lists(
      options.cells, cube_side, options.volume == VolumeTreatment::patches, coarsest, without_lists);
  for (std::size_t l = 0; l < levels.size(); ++l) {
    fem::grade_cube(levels[l].rest, options.cells >> l, cube_side, options.grading);
  }
  return levels;
}

Scene make_scene(const Options& options, std::vector<MeshLevel> levels) {
  Scene scene;
  if (options.is_cube()) scene.grading = options.grading;
  for (MeshLevel& level : levels) level.averages_at_nodes = options.volume == VolumeTreatment::nodes;
  scene.levels = std::move(levels);
  scene.plates = hold_between_plates(scene.levels, options.plate_tolerance);
  require_faces(scene.plates);
  const Plate &lower = scene.plates.lower, &upper = scene.plates.upper;
  for (std::size_t l = 0; l < scene.levels.size(); ++l) {
    set_plates(scene.levels[l], lower.nodes[l], upper.nodes[l], options.top);
  }
  const MeshLevel& finest = scene.levels.front();
  if (std::ranges::all_of(finest.fixed, [](std::uint8_t fixed) { return fixed == 7; })) {
    throw Error("the plates hold every node, so that nothing is left to solve for: the mesh needs nodes between them");
  }
  const double height = scene.plates.height();
  if (options.plates == Plates::contact) {
    scene.loading.planes.push_back({{0, 0, 1}, scene.plates.low, 0});
    scene.loading.planes.push_back({{0, 0, -1}, -scene.plates.high, height});
  }
  scene.loading.motion.assign(finest.rest.size(), fem::Point{});
  for (const Index n : upper.nodes.front()) scene.loading.motion[static_cast<std::size_t>(n)][2] = -height;
  if (!options.is_cube() && options.solver.newton.preconditioner.kind == fem::Preconditioner::multigrid) {
    scene.grid = fem::add_background_grid(scene.levels);
  }
  require_scene_with_grid(options, scene);
  return scene;
}

Scene make_case_scene(const Options& options, GivenMesh given) {
  Scene scene;
  for (MeshLevel& level : given.levels) level.averages_at_nodes = options.volume == VolumeTreatment::nodes;
  scene.levels = std::move(given.levels);
  scene.tet_tags = std::move(given.tet_tags);
  scene.order = std::move(given.order);
  scene.numbers = std::move(given.numbers);
  scene.refinements = options.refinements;
  scene.history = fem::make_load_history(options.given_case.load_case, scene.levels, given.groups);
  scene.groups = std::move(given.groups.front());
  if (options.solver.newton.preconditioner.kind == fem::Preconditioner::multigrid) {
    scene.grid = fem::add_background_grid(scene.levels);
  }
  require_scene_with_grid(options, scene);
  return scene;
}

std::vector<std::string> adapt_solver(Options& options, const Scene& scene, const std::vector<LevelCounts>& levels) {
  if (options.solver.newton.preconditioner.kind != fem::Preconditioner::multigrid) return {};
  if (scene.grid[0] > 0) {
    std::vector<std::string> notes{"multigrid over a background grid of " + std::to_string(scene.grid[0]) + " x " +
                                   std::to_string(scene.grid[1]) + " x " + std::to_string(scene.grid[2]) + " cells"};
    if (options.refinements == 0 && options.solver.nested) {
      options.solver.nested = false;
      notes.back() += ", and load steps on this mesh alone: nested steps need a coarser mesh, which --refine makes";
    }
    return notes;
  }
  const std::int64_t coarsest = levels.back().nodes;
  if (coarsest <= fem::most_coarse_nodes) return {};  // which is solved exactly
  if (levels.size() == 1) {
    options.solver.newton.preconditioner.kind = fem::Preconditioner::block_jacobi;
    return {"an odd number of cells has no coarser mesh, so block Jacobi replaces multigrid; take " +
            std::to_string(options.cells + 1) + " cells to have one"};
  }
  return {"the coarsest mesh has " + std::to_string(coarsest) + " nodes, and more than " +
          std::to_string(fem::most_coarse_nodes) +
          " are smoothed, not solved: numbers of cells that are 2^k or 3 * 2^k are faster"};
}

void adapt_smoother(Options& options, const Scene& scene) {
  fem::PreconditionerSettings& preconditioner = options.solver.newton.preconditioner;
  const bool is_uniform = options.is_cube() && options.grading == 1;
  if (is_uniform || preconditioner.kind != fem::Preconditioner::multigrid) return;
  // Near a Poisson's ratio of 0.5 the largest eigenvalues belong to a few patches of a refined mesh. Ten steps of power
  // iteration fall short of them, and multigrid is then not definite.
  if (options.refinements > 0) preconditioner.first_power_steps = 40;
  // Measured on graded cubes: in as long as by degree 2, a third to a half of the iterations less.
  struct Smoother {
    double flatter_than;
    int degree;
    double low;
  };
  constexpr std::array<Smoother, 2> smoothers{{{2, 3, 0.05}, {6, 4, 0.04}}};
  const fem::MeshLevel& finest = scene.levels.front();
  const double flatness = fem::flatness(finest.mesh, finest.rest);
  for (const auto& [flatter_than, degree, low] : smoothers) {
    if (flatness <= flatter_than) return;
    preconditioner.degree = degree;
    preconditioner.low = low;
  }
}

std::string name_of_tet(const Scene& scene, Index tet) {
  if (const auto& own = scene.numbers.tet_order; !own.empty()) tet = own[static_cast<std::size_t>(tet)];
  const std::string name = "tet " + std::to_string(tet);
  const auto element = static_cast<std::size_t>(tet) >> (3 * static_cast<unsigned>(scene.refinements));
  if (element >= scene.tet_tags.size()) return name;
  return name + (scene.refinements > 0 ? " (part of element " : " (element ") +
         std::to_string(scene.tet_tags[element]) + " of the mesh file)";
}

double reach_past_plates(const Scene& scene, double compression, BodyState& state, std::size_t window) {
  const double upper = scene.plates.low + scene.plates.height() * (1 - compression);
  double most = 0;
  each_window(0, scene.levels.front().rest.size(), WindowSizes(window).nodes(), [&](std::span<const Index> nodes) {
    for (const fem::Point& x : state.positions(0, nodes))
      most = std::max({most, x[2] - upper, scene.plates.low - x[2]});
  });
  return most;
}

}  // namespace physgen::truthcube
