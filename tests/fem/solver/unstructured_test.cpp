// Meshes as users bring them, refined twice: multigrid over their levels with volumes averaged over
// greedy patches or at nodes, and nested iteration.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "bodies.h"
#include "irregular.h"

namespace physgen::fem {
namespace {

/// A cube without a quarter: two arms that meet in an edge, the foot of one held, the end of the other moved.
Tets angle_piece() {
  const Tets whole = irregular_box({4, 4, 2}, {2 * side, 2 * side, side}, 0.15, 43);
  const Tets angle = irregular_box({4, 4, 2}, {2 * side, 2 * side, side}, 0, 43);
  // Which tets stay is said by the cells before they were jittered.
  Tets kept = whole;
  kept.tets.clear();
  for (const auto& tet : angle.tets) {
    double x = 0, y = 0;
    for (const Index n : tet) {
      x += angle.rest[static_cast<std::size_t>(n)][0] / 4;
      y += angle.rest[static_cast<std::size_t>(n)][1] / 4;
    }
    if (x < side || y < side) kept.tets.push_back(tet);
  }
  return shuffled(cut(kept, [](const Point&) { return true; }), 47);
}

struct Case {
  const char* name;
  Tets tets;
  std::function<std::uint8_t(const Point&)> fixed;
  std::function<Point(const Point&)> motion;  ///< at a load of 1
};

std::vector<Case> make_cases() {
  std::vector<Case> result;
  result.push_back({"cube", shuffled(irregular_box({3, 3, 3}, {side, side, side}, 0.2, 53), 59),
                    [](const Point& x) -> std::uint8_t { return x[2] == 0 || x[2] == side ? 7 : 0; },
                    [](const Point& x) { return x[2] == side ? Point{0, 0, -side} : Point{}; }});
  result.push_back({"angle piece", angle_piece(),
                    [](const Point& x) -> std::uint8_t { return x[1] == 2 * side || x[0] == 2 * side ? 7 : 0; },
                    [](const Point& x) { return x[0] == 2 * side ? Point{-side, 0.5 * side, 0.25 * side} : Point{}; }});
  return result;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> once = make_cases();
  return once;
}

SolverSettings settings_of(double poissons_ratio, Preconditioner kind) {
  SolverSettings settings = exact_settings("neo-hookean", poissons_ratio);
  settings.precision = TangentPrecision::half;
  settings.newton.tolerance = 1e-10;
  settings.newton.preconditioner.kind = kind;
  settings.coarsest_nested = 0;
  return settings;
}

int iterations_over(const std::vector<MeshLevel>& levels, double poissons_ratio, Preconditioner kind) {
  Loading loading;
  loading.motion.assign(levels[0].rest.size(), Point{});
  const auto solver = make_solver(levels, loading, settings_of(poissons_ratio, kind));
  std::mt19937_64 random(61);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Point> forces(levels[0].rest.size());
  for (Point& f : forces) f = {number(random), number(random), number(random)};
  const LinearResult result = solver->solve_linear(forces, 1e-4, nullptr);
  EXPECT_EQ(result.status, LinearStatus::converged);
  return result.iterations;
}

TEST(Unstructured, multigrid_takes_few_iterations_on_refined_meshes_and_no_more_after_a_further_refinement) {
  for (const Case& body : cases()) {
    for (const Volume volume : volumes) {
      const double poissons_ratio = volume == Volume::tets ? .45 : .49;
      std::vector<int> multigrid, jacobi;
      for (const int refinements : {1, 2}) {
        const auto levels = with(volume, make_levels(body.tets, refinements, volume == Volume::patches, body.fixed));
        multigrid.push_back(iterations_over(levels, poissons_ratio, Preconditioner::multigrid));
        jacobi.push_back(iterations_over(levels, poissons_ratio, Preconditioner::block_jacobi));
        std::printf("%s, %s, nu %g, %zu tets, coarsest %d nodes: %d iterations by multigrid, %d by block Jacobi\n",
                    body.name, name_of(volume), poissons_ratio, levels[0].mesh.tets.size(),
                    int(levels.back().mesh.nodes), multigrid.back(), jacobi.back());
      }
      EXPECT_LE(multigrid[1], volume == Volume::tets ? 12 : 24) << body.name;
      EXPECT_LE(multigrid[1], multigrid[0] * 5 / 4 + 2) << body.name;
      EXPECT_GE(jacobi[1], 4 * multigrid[1]) << body.name;
    }
  }
}

TEST(Unstructured, multigrid_and_block_jacobi_and_nested_and_load_steps_lead_to_the_same_state) {
  for (const Case& body : cases()) {
    for (const Volume volume : volumes) {
      const auto levels = with(volume, make_levels(body.tets, 2, volume == Volume::patches, body.fixed));
      const Loading loading{at_nodes(levels[0].rest, body.motion), {}};
      const struct {
        const char* name;
        Preconditioner kind;
        bool nested;
        std::vector<double> loads;
      } ways[] = {{"multigrid, nested", Preconditioner::multigrid, true, {0.15}},
                  {"multigrid, three load steps", Preconditioner::multigrid, false, {0.05, 0.1, 0.15}},
                  {"block Jacobi, three load steps", Preconditioner::block_jacobi, false, {0.05, 0.1, 0.15}}};
      std::vector<std::vector<Point>> found;
      for (const auto& way : ways) {
        SolverSettings settings = settings_of(volume == Volume::tets ? .45 : .49, way.kind);
        settings.nested = way.nested;
        const auto solver = make_solver(levels, loading, settings);
        int steps = 0, iterations = 0, coarse = 0;
        for (const double load : way.loads) {
          const NewtonResult result = solver->solve_to(load, {});
          ASSERT_EQ(result.status, NewtonStatus::converged) << body.name << ", " << way.name;
          EXPECT_EQ(result.bisections, 0) << body.name << ", " << way.name;
          steps += result.steps;
          iterations += result.iterations;
          coarse += result.coarse_steps;
        }
        EXPECT_EQ(coarse > 0, way.nested);
        EXPECT_LE(steps, way.nested ? 6 : 18) << body.name;  // the coarser levels led near
        std::printf("%s, %s, %s: %d Newton steps, %d iterations, %d steps on coarser levels\n", body.name,
                    name_of(volume), way.name, steps, iterations, coarse);
        found.push_back(solver->positions());
      }
      EXPECT_GT(largest_distance(found[0], levels[0].rest), 0.1 * side);
      EXPECT_LE(largest_distance(found[0], found[1]), 1e-8 * side) << body.name;
      EXPECT_LE(largest_distance(found[0], found[2]), 1e-8 * side) << body.name;
    }
  }
}

TEST(Unstructured, pressures_of_the_coarser_level_spare_newton_steps_and_filtered_tangents) {
  const Case& cube = cases()[0];
  std::vector<NewtonResult> results;
  for (const bool injects : {true, false}) {
    auto levels = make_levels(cube.tets, 2, true, cube.fixed);
    for (MeshLevel& level : levels) {
      if (!injects) level.patch_parents.clear();
    }
    const Loading loading{at_nodes(levels[0].rest, cube.motion), {}};
    SolverSettings settings;
    settings.poissons_ratio = .499;
    settings.coarsest_nested = 0;
    results.push_back(make_solver(levels, loading, settings)->solve_to(0.1825, {}));
    const NewtonResult& r = results.back();
    EXPECT_EQ(r.status, NewtonStatus::converged);
    std::printf("pressures %s: %d Newton steps, %d iterations, %d filtered\n", injects ? "injected" : "begun anew",
                r.steps, r.iterations, r.filtered);
  }
  EXPECT_LE(results[0].steps, 4);
  EXPECT_EQ(results[0].filtered, 0);
  EXPECT_LT(results[0].steps, results[1].steps);
}

TEST(Unstructured, order_of_nodes_and_tets_does_not_change_the_state) {
  const Tets ordered = irregular_box({3, 3, 3}, {side, side, side}, 0.2, 53);  // as the first case has it
  const Case& cube = cases()[0];
  std::vector<std::vector<Point>> found;
  for (const Tets& tets : {ordered, cube.tets}) {
    const auto levels = make_levels(tets, 1, false, cube.fixed);
    const Loading loading{at_nodes(levels[0].rest, cube.motion), {}};
    const auto solver = make_solver(levels, loading, settings_of(.45, Preconditioner::multigrid));
    ASSERT_EQ(solver->solve_to(0.1, {}).status, NewtonStatus::converged);
    // Fine nodes of both, by their places at rest.
    std::vector<std::array<Point, 2>> pairs;
    const auto positions = solver->positions();
    for (std::size_t n = 0; n < positions.size(); ++n) {
      Point place = levels[0].rest[n];
      for (double& x : place) x = std::round(x / side * 1e10);
      pairs.push_back({place, positions[n]});
    }
    std::ranges::sort(pairs);
    found.emplace_back();
    for (const auto& pair : pairs) found.back().push_back(pair[1]);
  }
  EXPECT_LE(largest_distance(found[0], found[1]), 1e-9 * side);
}

}  // namespace
}  // namespace physgen::fem
