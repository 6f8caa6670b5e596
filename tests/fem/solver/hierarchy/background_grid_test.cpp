// Meshes that have no coarser ones of their own: multigrid over a background grid.
#include <fem/solver/hierarchy/background_grid.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "../bodies.h"
#include "../irregular.h"

namespace physgen::fem {
namespace {

using Fixed = std::function<std::uint8_t(const Point&)>;

struct Shape {
  const char* name;
  std::function<Tets(Index)> make;  ///< in so many cells along an edge of the box around it
  Fixed fixed;
  std::function<Point(const Point&)> motion;  ///< at a load of 1
};

Tets jittered(Index cells) { return irregular_box({cells, cells, cells}, {side, side, side}, 0.2, 53); }

std::vector<Shape> make_shapes() {
  const auto lift = [](double from) {
    return [from](const Point& x) { return x[2] >= from ? Point{0.2 * side, 0, -side} : Point{}; };
  };
  std::vector<Shape> shapes;
  shapes.push_back({"cube between plates", [](Index cells) { return shuffled(jittered(cells), 59); },
                    [](const Point& x) -> std::uint8_t { return x[2] == 0 || x[2] == side ? 7 : 0; }, lift(side)});
  shapes.push_back({"angle piece",
                    [](Index cells) {
                      const auto inside = [](const Point& x) { return x[0] < side / 2 || x[2] < side / 2; };
                      return shuffled(cut(jittered(cells), inside), 59);
                    },
                    [](const Point& x) -> std::uint8_t { return x[0] == side || x[2] == side ? 7 : 0; }, lift(side)});
  shapes.push_back({"ball held at its caps",
                    [](Index cells) {
                      const auto inside = [](const Point& x) {
                        const double r = side / 2;
                        return std::hypot(x[0] - r, x[1] - r, x[2] - r) < r;
                      };
                      return shuffled(cut(jittered(cells), inside), 59);
                    },
                    [](const Point& x) -> std::uint8_t { return x[2] < 0.2 * side || x[2] > 0.8 * side ? 7 : 0; },
                    lift(0.8 * side)});
  const auto bone = [](const Point& x) { return std::hypot(x[0] - 0.45 * side, x[1] - 0.55 * side) < 0.15 * side; };
  shapes.push_back({"cube around a bone", [](Index cells) { return shuffled(jittered(cells), 59); },
                    [=](const Point& x) -> std::uint8_t { return bone(x) ? 7 : (x[2] == side ? 4 : 0); },
                    [=](const Point& x) { return x[2] == side && !bone(x) ? Point{0, 0, -side} : Point{}; }});
  return shapes;
}

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> once = make_shapes();
  return once;
}

std::vector<MeshLevel> levels_of(const Shape& shape, Index cells, bool patches) {
  auto levels = make_levels(shape.make(cells), 0, patches, shape.fixed);
  (void)add_background_grid(levels);
  return levels;
}

SolverSettings settings_of(double poissons_ratio, Preconditioner kind) {
  SolverSettings settings = exact_settings("neo-hookean", poissons_ratio);
  settings.precision = TangentPrecision::half;
  settings.newton.preconditioner.kind = kind;
  return settings;
}

int iterations(const std::vector<MeshLevel>& levels, double poissons_ratio, Preconditioner kind) {
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

/// The largest error of interpolation of a linear function, which is about 1, from each level to the next finer one.
double worst_interpolation(const std::vector<MeshLevel>& levels) {
  const auto linear = [](const Point& x) { return 0.3 + (2 * x[0] - 3 * x[1] + 5 * x[2]) / side; };
  double worst = 0;
  for (std::size_t l = 0; l + 1 < levels.size(); ++l) {
    const auto coarse = [&](Index n) { return linear(levels[l + 1].rest[static_cast<std::size_t>(n)]); };
    for (std::size_t n = 0; n < levels[l].rest.size(); ++n) {
      double sum = 0;
      if (levels[l].grid_parents.empty()) {
        for (const Index p : levels[l].parents[n]) sum += 0.5 * coarse(p);
      } else {
        const auto& [nodes, weights] = levels[l].grid_parents[n];
        for (std::size_t k = 0; k < 4; ++k) sum += weights[k] * coarse(nodes[k]);
      }
      worst = std::max(worst, std::abs(sum - linear(levels[l].rest[n])));
    }
  }
  return worst;
}

TEST(BackgroundGrid, interpolates_linear_functions_exactly_with_positive_weights_that_add_up_to_1) {
  for (const Shape& shape : shapes()) {
    for (const Index cells : {7, 12}) {
      const auto levels = levels_of(shape, cells, false);
      EXPECT_LE(worst_interpolation(levels), 1e-7) << shape.name;
      for (const GridLocation& location : levels[0].grid_parents) {
        double sum = 0;
        for (const double weight : location.weights) {
          EXPECT_GE(weight, 0);
          sum += weight;
        }
        EXPECT_NEAR(sum, 1, 1e-15);
      }
    }
  }
}

TEST(BackgroundGrid, has_an_eighth_of_the_nodes_and_levels_down_to_one_that_is_solved_exactly) {
  for (const Index cells : {8, 12, 20, 24}) {
    auto levels = make_levels(jittered(cells), 0, false, shapes()[0].fixed);
    const auto grid = add_background_grid(levels);
    for (const Index along : grid) EXPECT_NEAR(along, cells / 2, cells / 8.0) << cells;
    EXPECT_LE(levels.back().mesh.nodes, most_coarse_nodes) << cells;
    for (std::size_t l = 1; l + 1 < levels.size(); ++l) EXPECT_GT(levels[l].mesh.nodes, most_coarse_nodes);
  }
}

TEST(BackgroundGrid, of_a_long_or_a_flat_body_has_as_many_cells_as_it_is_long_and_flat) {
  struct Box {
    std::array<Index, 3> cells;
    std::array<Index, 3> grid;
  };
  for (const Box& box : {Box{{64, 4, 4}, {32, 2, 2}}, Box{{24, 24, 2}, {12, 12, 1}}, Box{{32, 16, 6}, {16, 8, 4}}}) {
    const Point size{double(box.cells[0]), double(box.cells[1]), double(box.cells[2])};
    auto levels = make_levels(irregular_box(box.cells, size, 0.2, 53), 0, false, [](const Point&) { return 0; });
    EXPECT_EQ(add_background_grid(levels), box.grid);
    EXPECT_LE(levels.back().mesh.nodes, most_coarse_nodes);
    EXPECT_LE(worst_interpolation(levels), 1e-4);  // of numbers that reach 4000
  }
}

TEST(BackgroundGrid, has_no_node_on_which_none_hangs) {
  for (const Shape& shape : shapes()) {
    const auto levels = levels_of(shape, 12, false);
    for (std::size_t l = 1; l < levels.size(); ++l) {
      std::vector<double> weights(levels[l].rest.size(), 0.0);
      for (const GridLocation& location : levels[l - 1].grid_parents) {
        for (std::size_t k = 0; k < 4; ++k) {
          weights[static_cast<std::size_t>(location.nodes[k])] += location.weights[k];
        }
      }
      for (const auto& parents : levels[l - 1].parents) {
        for (const Index p : parents) weights[static_cast<std::size_t>(p)] += 0.5;
      }
      EXPECT_GT(*std::ranges::min_element(weights), 0) << shape.name << ", level " << l;
    }
  }
}

TEST(BackgroundGrid, is_not_added_to_a_mesh_that_is_solved_exactly) {
  auto levels = make_levels(jittered(4), 0, false, shapes()[0].fixed);
  EXPECT_EQ(add_background_grid(levels), (std::array<Index, 3>{}));
  EXPECT_EQ(levels.size(), 1U);
}

TEST(BackgroundGrid, is_prescribed_only_where_all_is_that_hangs_on_it) {
  for (const Shape& shape : shapes()) {
    const auto levels = levels_of(shape, 12, false);
    std::vector<std::uint8_t> expected(levels[1].rest.size(), 7);
    for (std::size_t n = 0; n < levels[0].rest.size(); ++n) {
      const auto& [nodes, weights] = levels[0].grid_parents[n];
      for (std::size_t k = 0; k < 4; ++k) {
        if (weights[k] >= 1e-3) expected[static_cast<std::size_t>(nodes[k])] &= levels[0].fixed[n];
      }
    }
    EXPECT_EQ(levels[1].fixed, expected) << shape.name;
  }
}

TEST(BackgroundGrid, takes_few_iterations_which_hardly_grow_as_meshes_become_finer) {
  for (const Shape& shape : shapes()) {
    for (const bool patches : {false, true}) {
      const double poissons_ratio = patches ? .49 : .45;
      std::vector<int> found;
      for (const Index cells : {6, 12, 24}) {
        const auto levels = levels_of(shape, cells, patches);
        found.push_back(iterations(levels, poissons_ratio, Preconditioner::multigrid));
        const int jacobi = cells == 12 ? iterations(levels, poissons_ratio, Preconditioner::block_jacobi) : 0;
        std::printf("%s, %s, nu %g, %d nodes: %d iterations", shape.name, patches ? "patches" : "tets", poissons_ratio,
                    int(levels[0].mesh.nodes), found.back());
        std::printf(jacobi > 0 ? ", %d by block Jacobi\n" : "\n", jacobi);
        if (jacobi > 0) {
          EXPECT_GE(jacobi, 6 * found.back()) << shape.name;
        }
      }
      // The smallest ball is held almost everywhere.
      EXPECT_LE(2 * found[2], 3 * std::max(found[0], patches ? 14 : 7)) << shape.name;
      EXPECT_LE(4 * found[2], 5 * found[1]) << shape.name;
      EXPECT_LE(found[2], patches ? 24 : 12) << shape.name;
    }
  }
}

TEST(BackgroundGrid, leads_to_the_state_to_which_block_jacobi_leads) {
  for (const Shape& shape : shapes()) {
    for (const bool patches : {false, true}) {
      const auto levels = levels_of(shape, 8, patches);
      const Loading loading{at_nodes(levels[0].rest, shape.motion), {}};
      std::vector<std::vector<Point>> found;
      std::vector<int> iterations;
      for (const Preconditioner kind : {Preconditioner::multigrid, Preconditioner::block_jacobi}) {
        SolverSettings settings = settings_of(patches ? .49 : .45, kind);
        settings.newton.tolerance = 1e-10;
        const auto solver = make_solver(levels, loading, settings);
        const NewtonResult result = solver->solve_to(0.1, {});
        ASSERT_EQ(result.status, NewtonStatus::converged) << shape.name;
        EXPECT_EQ(result.coarse_steps, 0);  // a grid is no mesh on which to solve
        iterations.push_back(result.iterations);
        found.push_back(solver->positions());
      }
      EXPECT_GT(largest_distance(found[0], levels[0].rest), 0.05 * side);
      EXPECT_LE(largest_distance(found[0], found[1]), 1e-8 * side) << shape.name;
      EXPECT_LT(3 * iterations[0], iterations[1]) << shape.name;
    }
  }
}

TEST(BackgroundGrid, goes_on_below_a_coarse_mesh_with_many_nodes) {
  const Shape& cube = shapes()[0];
  auto levels = make_levels(cube.make(6), 1, true, cube.fixed);
  (void)add_background_grid(levels);
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_TRUE(levels[0].grid_parents.empty() && levels[2].is_grid());
  EXPECT_LE(iterations(levels, .49, Preconditioner::multigrid), 24);
  const Loading loading{at_nodes(levels[0].rest, cube.motion), {}};
  SolverSettings settings = settings_of(.49, Preconditioner::multigrid);
  settings.coarsest_nested = 0;
  settings.newton.tolerance = 1e-8;
  const NewtonResult result = make_solver(levels, loading, settings)->solve_to(0.1, {});
  EXPECT_EQ(result.status, NewtonStatus::converged);
  EXPECT_GT(result.coarse_steps, 0);  // on the coarse mesh, not on the grid
}

TEST(BackgroundGrid, errors_say_what_is_wrong) {
  const auto message = [](const std::vector<MeshLevel>& levels) -> std::string {
    try {
      (void)make_level_graphs(levels);
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  };
  const auto good = levels_of(shapes()[0], 6, false);
  EXPECT_EQ(message(good), "none");
  auto outside = good;
  outside[0].grid_parents[5].nodes[2] = outside[1].mesh.nodes;
  const std::string expected = "level 0: every node needs parents among the 64 nodes of the next coarser level";
  EXPECT_NE(message(outside).find(expected), std::string::npos) << message(outside);
  auto missing = good;
  missing[0].grid_parents.pop_back();
  EXPECT_EQ(message(missing), message(outside));

  auto flat = make_levels(jittered(6), 0, false, shapes()[0].fixed);
  for (Point& x : flat[0].rest) x[1] = 0.01;
  EXPECT_THROW((void)add_background_grid(flat), Error);
}

}  // namespace
}  // namespace physgen::fem
