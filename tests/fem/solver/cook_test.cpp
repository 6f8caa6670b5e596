// Cook's membrane: a tapered panel, 44 high where it is held and 16 where it is lifted, 48 long; bending and shear in
// distorted cells. In plane strain, one cell thick.
#include <fem/mesh/boundary.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "bodies.h"

namespace physgen::fem {
namespace {

/// n x n x 1 cells of a box, carried to the panel; coarser levels are half as fine in its plane.
std::vector<MeshLevel> panel_levels(Index cells, bool patches) {
  std::vector<MeshLevel> levels;
  for (Index n = cells;; n /= 2) {
    MeshLevel level;
    level.mesh = make_box_mesh(n, n, 1);
    const bool last = n <= 4;
    const auto coarse_node = [&](Index x, Index y, Index z) { return x + (n / 2 + 1) * (y + (n / 2 + 1) * z); };
    for (Index z = 0; z <= 1; ++z) {
      for (Index y = 0; y <= n; ++y) {
        for (Index x = 0; x <= n; ++x) {
          const double s = double(x) / n, t = double(y) / n;
          level.rest.push_back({48 * s, 44 * s + t * (44 - 28 * s), double(z)});
          level.fixed.push_back(x == 0 ? 7 : 4);
          if (!last) {
            level.parents.push_back({coarse_node(x / 2, y / 2, z), coarse_node((x + 1) / 2, (y + 1) / 2, z)});
          }
        }
      }
    }
    if (patches) level.patches = cell_patches(level.mesh);
    for (Index c = 0; patches && !last && c < n * n; ++c) {
      level.patch_parents.push_back(c % n / 2 + n / 2 * (c / n / 2));
    }
    levels.push_back(std::move(level));
    if (last) return levels;
  }
}

struct Lift {
  double middle;  ///< how far the middle of the right side rises
  NewtonResult result;
};

/// @param force on the whole right side, upward
Lift lift(Index cells, bool patches, double youngs_modulus, double poissons_ratio, double force) {
  const auto levels = panel_levels(cells, patches);
  const MeshLevel& level = levels[0];
  std::vector<Face> right = boundary_faces(level.mesh);
  std::erase_if(right, [&](const Face& face) {
    return std::ranges::any_of(face, [&](Index n) { return level.rest[static_cast<std::size_t>(n)][0] < 48; });
  });
  Loading loading;
  loading.motion.assign(level.rest.size(), Point{});
  // A pressure of -1 / area pushes with 1 along x in all; the same share of the side's area pulls upward.
  for (const Force& f : pressure_loads(level.rest, right, -1.0 / 16)) loading.forces.push_back({0, force * f[0], 0});
  SolverSettings settings;
  settings.material = "neo-hookean";
  settings.youngs_modulus = youngs_modulus;
  settings.poissons_ratio = poissons_ratio;
  settings.precision = TangentPrecision::float64;
  settings.newton.tolerance = 1e-7;
  settings.coarsest_nested = 1;
  const auto solver = make_solver(levels, loading, settings);
  Lift found{0, solver->solve_to(1, {})};
  EXPECT_EQ(found.result.status, NewtonStatus::converged) << cells;
  const auto positions = solver->positions();
  int count = 0;
  for (std::size_t n = 0; n < positions.size(); ++n) {
    if (level.rest[n][0] == 48 && level.rest[n][1] == 52) {
      found.middle += (positions[n][1] - 52) / 2;
      ++count;
    }
  }
  EXPECT_EQ(count, 2);
  return found;
}

void print(Index cells, bool patches, double poissons_ratio, const Lift& found, double reference) {
  std::printf("nu %g, %2d x %2d cells, %s: lifted by %.5g of %.5g; %d Newton steps, %d iterations, %d bisections\n",
              poissons_ratio, int(cells), int(cells), patches ? "patches" : "tets", found.middle, reference,
              found.result.steps, found.result.iterations, found.result.bisections);
}

/// A small force, and constants by which plane strain is plane stress of E = 1, nu = 1/3: E / (1 - nu^2) = 1 and
/// nu / (1 - nu) = 1/3. Cook's own case: 23.96 times the force (Cook 1974).
TEST(CooksMembrane, under_a_small_force_rises_as_cook_has_it) {
  constexpr double force = 1e-4, reference = 23.96 * force;
  double before = INFINITY;
  for (const Index cells : {8, 16, 32}) {
    const Lift tets = lift(cells, false, 0.9375, 0.25, force);
    print(cells, false, 0.25, tets, reference);
    const double error = std::abs(tets.middle / reference - 1);
    EXPECT_LE(error, 0.5 * before) << cells;
    before = error;
  }
  EXPECT_LE(before, 0.03);
}

/// Nearly incompressible and lifted by a seventh of its length. The reference is that of quadratic quadrilaterals in
/// plane strain of the same material, by a program of its own: with 8, 16, 32, 64 elements a side 6.7006, 6.8556,
/// 6.9121, 6.9383 when integrated by 3 x 3 points, and 6.9963, 6.9792, 6.9732, 6.9710 by 2 x 2, which do not lock.
TEST(CooksMembrane, nearly_incompressible_rises_fully_with_patches_while_tets_lock) {
  constexpr double reference = 6.97, youngs_modulus = 240.565, poissons_ratio = 0.499, force = 100;
  double before = INFINITY;
  for (const Index cells : {8, 16, 32}) {
    const Lift tets = lift(cells, false, youngs_modulus, poissons_ratio, force);
    const Lift patches = lift(cells, true, youngs_modulus, poissons_ratio, force);
    print(cells, false, poissons_ratio, tets, reference);
    print(cells, true, poissons_ratio, patches, reference);
    const double error = std::abs(patches.middle / reference - 1);
    EXPECT_LE(error, 0.6 * before) << cells;
    EXPECT_LE(tets.middle, 0.7 * reference) << cells;
    before = error;
  }
  EXPECT_LE(before, 0.03);
}

}  // namespace
}  // namespace physgen::fem
