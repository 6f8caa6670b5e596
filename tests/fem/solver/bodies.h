// Bodies that the tests of the solver deform: cubes of the paper, irregular and patched, and what they are compared
// with.
#pragma once

#include <fem/mesh/refine.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/quasistatic.h>

#include <cmath>
#include <functional>
#include <random>

namespace physgen::fem {

struct Body {
  std::vector<MeshLevel> levels;
  Loading loading;
};

/// The parts of a body over which the change of volume is averaged.
enum class Volume { tets, patches, nodes };
inline constexpr std::array volumes{Volume::tets, Volume::patches, Volume::nodes};
inline const char* name_of(Volume volume) {
  if (volume == Volume::nodes) return "nodes";
  return volume == Volume::patches ? "patches" : "tets";
}

/// The same with volumes averaged at nodes, where these are asked for; patches are made with the levels.
inline std::vector<MeshLevel> with(Volume volume, std::vector<MeshLevel> levels) {
  for (MeshLevel& level : levels) level.averages_at_nodes = volume == Volume::nodes;
  return levels;
}
inline Body with(Volume volume, Body body) {
  body.levels = with(volume, std::move(body.levels));
  return body;
}

/// A cube; fixed and motion are given for each rest position.
/// @param jitter of nodes inside, and inside of faces, as a part of a cell; one level then
inline Body make_cube(Index cells, double side, bool patches, double jitter,
                      const std::function<std::uint8_t(const Point&)>& fixed,
                      const std::function<Point(const Point&)>& motion) {
  Body body{make_cube_levels(cells, side, patches), {}};
  if (jitter > 0) {
    body.levels.resize(1);
    body.levels[0].parents.clear();
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> part(-jitter, jitter);
    for (Point& x : body.levels[0].rest) {
      for (double& number : x) {
        const bool inside = number > 1e-9 * side && number < side * (1 - 1e-9);
        if (inside) number += part(random) * side / cells;
      }
    }
    if (patches) body.levels[0].patches = greedy_patches(body.levels[0].mesh);
  }
  for (MeshLevel& level : body.levels) {
    for (std::size_t n = 0; n < level.rest.size(); ++n) level.fixed[n] = fixed(level.rest[n]);
  }
  for (const Point& x : body.levels[0].rest) body.loading.motion.push_back(motion(x));
  return body;
}

/// The same cube with all cells cut along one diagonal, so that the tets around a node inside are symmetric in it.
inline Body cut_along_one_diagonal(Body body, Index cells) {
  for (MeshLevel& level : body.levels) {
    level.mesh = make_box_mesh(cells, cells, cells);
    if (!level.patches.nodes.empty()) level.patches = cell_patches(level.mesh);
    cells /= 2;
    if (!level.parents.empty()) level.parents = box_parents(cells, cells, cells);
  }
  return body;
}

inline constexpr double side = 0.08;  ///< of the Truth Cube [m]

/// The Truth Cube: base bonded, top moved down by its height at a load of 1.
inline Body make_truth_cube_body(Index cells, bool patches, bool frictionless = false) {
  return make_cube(
      cells, side, patches, 0,
      [=](const Point& x) -> std::uint8_t {
        if (x[2] == 0) return 7;
        return x[2] == side ? (frictionless ? 4 : 7) : 0;
      },
      [](const Point& x) { return x[2] == side ? Point{0, 0, -side} : Point{}; });
}

/// The same between its plates as rigid planes, which its free sides may touch.
inline Body with_contact(Body body) {
  body.loading.planes = {{{0, 0, 1}, 0, 0}, {{0, 0, -1}, -side, side}};
  return body;
}

inline SolverSettings exact_settings(const std::string& material, double poissons_ratio) {
  SolverSettings settings;
  settings.material = material;
  settings.youngs_modulus = 1;
  settings.poissons_ratio = poissons_ratio;
  settings.precision = TangentPrecision::float64;
  settings.newton.tolerance = 1e-11;
  return settings;
}

/// The largest distance of two sets of positions.
inline double largest_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  double largest = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    largest = std::max(largest, std::hypot(a[n][0] - b[n][0], a[n][1] - b[n][1], a[n][2] - b[n][2]));
  }
  return a.size() == b.size() ? largest : INFINITY;
}

}  // namespace physgen::fem
