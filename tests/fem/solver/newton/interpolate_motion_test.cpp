// How nested iteration carries the motion of a coarser mesh to the next finer one.
#include <fem/mesh/geometry.h>
#include <fem/mesh/graded_cube.h>
#include <fem/mesh/mesh_arrays.h>
#include <fem/solver/newton/interpolate_motion.h>
#include <gtest/gtest.h>
#include <physgen/parallel_for.h>

#include <cstdio>

#include "../bodies.h"

namespace physgen::fem {
namespace {

constexpr double extent = 2;

/// Positions on the finer of two meshes of a cube, where `motion` was found on the coarser one, beside a rest that is
/// already moved by `start`.
std::vector<Point> interpolated(const Body& body, const std::function<Point(const Point&)>& motion, double start,
                                bool bends = true) {
  const MeshLevel &fine = body.levels[0], &coarse = body.levels[1];
  const auto coarse_nodes = index_t{coarse.mesh.nodes}, fine_nodes = index_t{fine.mesh.nodes};
  quasistatic::NodeParentsArray<float> parents(fine_nodes);
  quasistatic::NodeConstraintArray<float> constraints(fine_nodes);
  elasticity::NodePositionArray<double> positions(fine_nodes), fine_rest(fine_nodes), rest(coarse_nodes),
      before(coarse_nodes), now(coarse_nodes);
  elasticity::TetArray<float> tets(index_t(coarse.mesh.tets.size()));
  store_tets(coarse.mesh, tets.view());
  elasticity::IncidenceRangeArray<float> ranges(coarse_nodes);
  quasistatic::PackedIncidenceArray<float> entries(4 * tets.size());
  put_packed<NodeTetEntry>(ranges, entries, coarse.mesh.node_tets, tets.size(), "tets");
  const Rows node_tets(ranges.const_view(), entries.const_view(), tets.size());
  for (index_t n = 0; n < fine_nodes; ++n) {
    const auto& [a, b] = fine.parents[std::size_t(n)];
    parents.view().put(n, {{a, b}});
    constraints.view().put(n, {int{fine.fixed[std::size_t(n)]}});
    const Point& x = fine.rest[std::size_t(n)];
    fine_rest.view().put(n, {{x[0], x[1], x[2]}});
    positions.view().put(n, {{x[0] + start, x[1] + start, x[2] + start}});
  }
  for (index_t n = 0; n < coarse_nodes; ++n) {
    const Point& x = coarse.rest[std::size_t(n)];
    const Point w = motion(x);
    rest.view().put(n, {{x[0], x[1], x[2]}});
    before.view().put(n, {{x[0] + 7, x[1] - 5, x[2] + 3}});
    now.view().put(n, {{x[0] + 7 + w[0], x[1] - 5 + w[1], x[2] + 3 + w[2]}});
  }
  elasticity::NodePositionArray<double> along_x(coarse_nodes);
  elasticity::NodeForceArray<double> along_y(coarse_nodes);
  elasticity::NodeDisplacementArray<double> along_z(coarse_nodes);
  const NodeMatrices gradients{along_x.view(), along_y.view(), along_z.view()};
  for (index_t n = 0; n < coarse_nodes; ++n) {
    gradients.first.put(n, {{NAN, NAN, NAN}});
    gradients.second.put(n, {{NAN, NAN, NAN}});
    gradients.third.put(n, {{NAN, NAN, NAN}});
  }
  if (bends) {
    parallel_for(Host{}, coarse_nodes,
                 lanes<1>(AverageMotionGradients{node_tets, tets.const_view(), rest.const_view(), before.const_view(),
                                                 now.const_view(), gradients}));
  }
  parallel_for(Host{}, fine_nodes,
               lanes<1>(InterpolateMotion{bends, parents.const_view(), fine_rest.const_view(), rest.const_view(),
                                          before.const_view(), now.const_view(), gradients, constraints.const_view(),
                                          positions.view()}));
  std::vector<Point> result(std::size_t(fine_nodes), Point{});
  for (index_t n = 0; n < fine_nodes; ++n) {
    const auto x = positions.view().get(n).x;
    result[std::size_t(n)] = {x[0], x[1], x[2]};
  }
  return result;
}

/// Cells of 1/4, and of 1/2, some of whose components are prescribed.
Body cube_with(std::uint8_t fixed_below) {
  return make_cube(
      8, extent, false, 0, [&](const Point& x) { return x[2] == 0 ? fixed_below : std::uint8_t{0}; },
      [](const Point& /*x*/) { return Point{}; });
}

/// The same in cells of different widths, whose nodes lie beside the middles of coarse edges.
Body graded(Body body, double grading) {
  Index cells = 8;
  for (MeshLevel& level : body.levels) {
    grade_cube(level.rest, cells, extent, grading);
    cells /= 2;
  }
  return body;
}

TEST(InterpolateMotion, is_exact_for_affine_motions_everywhere) {
  for (const Body& body : {cube_with(0), graded(cube_with(0), 1.5), graded(cube_with(0), 2)}) {
    const auto motion = [](const Point& x) {
      return Point{0.3 + 0.2 * x[0] - 0.7 * x[1], 0.1 + 0.5 * x[2] - x[0], 0.9 * x[1] - 0.4 * x[2]};
    };
    const auto positions = interpolated(body, motion, 0.25);
    for (std::size_t n = 0; n < positions.size(); ++n) {
      const Point& x = body.levels[0].rest[n];
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(positions[n][k], x[k] + 0.25 + motion(x)[k], 1e-13) << n;
    }
  }
}

/// On the middle line of the cube along x. Its diagonals run towards the middle: a node has the six tets of the cells
/// whose inner corner it is, and two of the cells behind it; all have the same gradient of x^2 along an edge.
TEST(InterpolateMotion, takes_the_cubic_where_a_node_lies_off_the_middle_of_an_edge) {
  const Body body = graded(cube_with(0), 1.5);
  const auto positions = interpolated(body, [](const Point& x) { return Point{x[0] * x[0], 0, 0}; }, 0);
  const std::vector<double> at = graded_positions(4, extent, 1.5);
  const auto gradient = [&](std::size_t k) {
    const double before = (k <= 2 ? 6 : 2) * (at[k] - at[k - 1]), behind = (k >= 2 ? 6 : 2) * (at[k + 1] - at[k]);
    return (before * (at[k] + at[k - 1]) + behind * (at[k] + at[k + 1])) / (before + behind);
  };
  for (const std::size_t k : {1U, 2U}) {
    const std::size_t node = 2 * k + 1 + 9 * (4 + 9 * 4);
    const double x = body.levels[0].rest[node][0], length = at[k + 1] - at[k], s = (x - at[k]) / length;
    EXPECT_GT(std::abs(s - 0.5), 0.02);
    const double rise = at[k + 1] * at[k + 1] - at[k] * at[k];
    const double bend = (1 - s) * (gradient(k) * length - rise) - s * (gradient(k + 1) * length - rise);
    EXPECT_NEAR(positions[node][0], x + at[k] * at[k] + s * rise + s * (1 - s) * bend, 1e-13) << k;
  }
}

/// A straight line between parents would be off by h^2/8 times the second derivative. The mean gradient at
/// a node is exact where the tets around it are symmetric in it.
TEST(InterpolateMotion, is_exact_for_quadratic_motions_between_nodes_inside) {
  const Body body = cut_along_one_diagonal(cube_with(0), 8);
  const auto motion = [](const Point& x) {
    return Point{x[0] * x[0] - 0.5 * x[1] * x[2], 0.7 * x[1] * x[1] + x[0] * x[2], x[2] * (x[0] - x[1] - 0.3 * x[2])};
  };
  const auto positions = interpolated(body, motion, 0);
  const double spacing = extent / 4;
  int inside = 0;
  for (std::size_t n = 0; n < positions.size(); ++n) {
    const Point& x = body.levels[0].rest[n];
    const bool near_surface = std::ranges::any_of(
        x, [&](double number) { return number < spacing * 0.9 || number > extent - spacing * 0.9; });
    if (near_surface) continue;
    ++inside;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(positions[n][k], x[k] + motion(x)[k], 1e-13) << n;
  }
  EXPECT_EQ(inside, 125);
}

TEST(InterpolateMotion, without_bends_takes_the_mean_of_both_parents) {
  const Body body = cube_with(0);
  const auto motion = [](const Point& x) { return Point{x[0] * x[1], x[2] * x[2], 1 / (1 + x[0] + x[2])}; };
  const auto positions = interpolated(body, motion, 0.25, false);
  const MeshLevel &fine = body.levels[0], &coarse = body.levels[1];
  for (std::size_t n = 0; n < positions.size(); ++n) {
    const auto& [a, b] = fine.parents[n];
    const Point first = motion(coarse.rest[std::size_t(a)]), second = motion(coarse.rest[std::size_t(b)]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(positions[n][k], fine.rest[n][k] + 0.25 + (first[k] + second[k]) / 2, 1e-13) << n;
    }
  }
}

TEST(InterpolateMotion, leaves_prescribed_components_where_they_are) {
  const Body body = cube_with(5);
  const auto positions = interpolated(body, [](const Point& /*x*/) { return Point{0.5, 0.25, -0.125}; }, 0);
  int prescribed = 0;
  for (std::size_t n = 0; n < positions.size(); ++n) {
    const Point& x = body.levels[0].rest[n];
    const bool below = x[2] == 0;
    prescribed += below;
    EXPECT_EQ(positions[n][0], below ? x[0] : x[0] + 0.5);
    EXPECT_NEAR(positions[n][1], x[1] + 0.25, 1e-14);
    EXPECT_EQ(positions[n][2], below ? x[2] : x[2] - 0.125);
  }
  EXPECT_EQ(prescribed, 81);
}

/// The cube is flattened in one step, which cubics from the coarser mesh would follow beyond flat tets.
TEST(NestedIteration, begins_on_straight_lines_where_cubics_would_invert_tets) {
  constexpr double load = 0.8;
  Body body = make_cube(
      8, extent, false, 0, [](const Point& x) -> std::uint8_t { return x[2] == 0 || x[2] == extent ? 7 : 0; },
      [](const Point& x) { return x[2] == extent ? Point{0, 0, -extent} : Point{}; });
  body.levels.resize(2);
  body.levels[1].parents.clear();
  const MeshLevel &fine = body.levels[0], &coarse = body.levels[1];
  SolverSettings settings = exact_settings("neo-hookean", 0.45);
  settings.coarsest_nested = 0;
  settings.newton.least_forcing = settings.newton.most_forcing = 1e-10;
  const auto first_step_of = [&](QuasistaticSolver& solver) {
    NewtonStep first;
    const NewtonResult result = solver.solve_to(load, [&](std::size_t level, const NewtonStep& step) {
      if (level == 0 && step.number == 1) first = step;
    });
    EXPECT_EQ(result.status, NewtonStatus::converged);
    EXPECT_EQ(result.bisections, 0);
    return first;
  };
  const auto nested = make_solver(body.levels, body.loading, settings);
  const NewtonStep found = first_step_of(*nested);
  const auto coarser = nested->coarser_equilibrium();
  ASSERT_TRUE(coarser.has_value());

  const auto motion = [&](const Point& x) {
    const auto at = [&](std::size_t axis) { return std::lround(x[axis] / extent * 4); };
    const auto n = static_cast<std::size_t>(at(0) + 5 * (at(1) + 5 * at(2)));
    const Point &from = coarse.rest[n], &to = coarser->positions[n];
    return Point{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  };
  const auto start = [&](bool bends) {
    std::vector<Point> positions = interpolated(body, motion, 0, bends);
    for (std::size_t n = 0; n < positions.size(); ++n) {
      if (fine.rest[n][2] == extent) positions[n][2] = extent * (1 - load);
    }
    return positions;
  };
  const auto smallest_ratio = [&](const std::vector<Point>& positions) {
    double smallest = INFINITY;
    for (const auto& tet : fine.mesh.tets) {
      smallest = std::min(smallest, six_volumes(tet, positions) / six_volumes(tet, fine.rest));
    }
    return smallest;
  };
  EXPECT_LT(smallest_ratio(start(true)), -0.01);
  EXPECT_GT(smallest_ratio(start(false)), 0.1);

  settings.nested = false;
  const auto alone = make_solver(body.levels, body.loading, settings);
  alone->set_positions(start(false));
  const NewtonStep expected = first_step_of(*alone);
  EXPECT_NEAR(found.energy / expected.energy, 1, 1e-7);
  EXPECT_NEAR(found.smallest_J, expected.smallest_J, 1e-6);
}

}  // namespace
}  // namespace physgen::fem
