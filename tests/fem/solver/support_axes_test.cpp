// Supports along axes other than x, y and z: a turned body on turned supports moves as the body does, two directions
// leave a node a line, and directions that no body can have are refused.
#include <fem/solver/dynamic_solver.h>
#include <fem/solver/hierarchy/background_grid.h>
#include <fem/solver/load_case.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <Eigen/Geometry>
#include <bitset>
#include <cmath>
#include <limits>
#include <numbers>

#include "grouped_bar.h"

namespace physgen::fem {
namespace {

const Eigen::Matrix3d turn_by_30 =
    Eigen::AngleAxisd(std::numbers::pi / 6, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();

Point turned_by_30(const Point& x) {
  const Eigen::Vector3d y = turn_by_30 * Eigen::Vector3d(x.data());
  return {y[0], y[1], y[2]};
}

Support along(const std::string& group, const Point& direction, double displacement = 0) {
  Support support{group};
  support.axis = SupportAxis{direction, false, displacement};
  return support;
}

Support along_normal(const std::string& group, double displacement = 0) {
  Support support{group};
  support.axis = SupportAxis{{}, true, displacement};
  return support;
}

void expect_near(const std::vector<Point>& found, const std::vector<Point>& plain, double error, const char* what) {
  ASSERT_EQ(found.size(), plain.size());
  double worst = 0;
  for (std::size_t n = 0; n < found.size(); ++n) {
    const Point wanted = turned_by_30(plain[n]);
    for (std::size_t k = 0; k < 3; ++k) worst = std::max(worst, std::abs(found[n][k] - wanted[k]));
  }
  EXPECT_LT(worst, error) << what;
}

TEST(SupportAxes, of_a_turned_body_give_its_motion_reactions_and_stresses_turned) {
  struct Way {
    const char* name;
    bool patches, grid, nested, linear;
    Preconditioner preconditioner;
  };
  for (const Way& way : {Way{"block Jacobi", false, false, false, false, Preconditioner::block_jacobi},
                         Way{"linear", false, false, false, true, Preconditioner::block_jacobi},
                         Way{"multigrid over a grid", true, true, false, false, Preconditioner::multigrid},
                         Way{"nested multigrid", true, false, true, false, Preconditioner::multigrid}}) {
    SCOPED_TRACE(way.name);
    SolverSettings settings = settings_of(0.4);
    settings.newton.preconditioner.kind = way.preconditioner;
    settings.nested = way.nested;
    settings.coarsest_nested = 0;
    GroupedBar plain(way.patches, way.nested ? 1 : 0), bar(way.patches, way.nested ? 1 : 0);
    for (MeshLevel& level : bar.levels) {
      for (Point& x : level.rest) x = turned_by_30(x);
    }
    LoadCase load_case{symmetric(), {}, {{"x1", {40, 10, 0}}}, {}, {1, -2, -9}, 1000};
    load_case.supports.push_back({"z1", {.z = 0.02}});
    LoadCase other{{}, {}, {{"x1", turned_by_30({40, 10, 0})}}, {}, turned_by_30({1, -2, -9}), 1000};
    other.supports = {along("x0", turned_by_30({-3, 0, 0})), along_normal("y0"),
                      along("z0", turned_by_30({0, 0, 1e-200})), along_normal("z1", 0.02)};
    const Loading loading = apply_load_case(load_case, plain.levels, plain.groups);
    const Loading turned_loading = apply_load_case(other, bar.levels, bar.groups);
    for (std::size_t n = 0; n < bar.levels[0].fixed.size(); ++n) {
      EXPECT_EQ(std::bitset<8>(bar.levels[0].fixed[n]).count(), std::bitset<8>(plain.levels[0].fixed[n]).count()) << n;
    }
    if (way.grid) {
      add_background_grid(plain.levels);
      add_background_grid(bar.levels);
    }
    const auto solved = [&](const std::vector<MeshLevel>& levels, const Loading& load) {
      std::unique_ptr<EquilibriumSolver> solver =
          way.linear ? make_linear_solver(levels, load, settings) : make_solver(levels, load, settings);
      for (const double to : {0.5, 1.0}) EXPECT_EQ(solver->solve_to(to, {}).status, NewtonStatus::converged);
      return solver;
    };
    const auto one = solved(plain.levels, loading), two = solved(bar.levels, turned_loading);
    expect_near(two->positions(), one->positions(), 1e-9 * size[2], "positions");
    expect_near(two->forces(), one->forces(), 1e-7, "forces");
    for (const char* group : {"x0", "y0", "z0", "z1"}) {
      const auto reaction = [&](const GroupedBar& body, EquilibriumSolver& solver) {
        return reaction_of(body.group(group).nodes, body.levels[0], solver.forces());
      };
      expect_near({reaction(bar, *two)}, {reaction(plain, *one)}, 1e-7, group);
    }
    const auto stresses = one->stresses(), turned_stresses = two->stresses();
    double worst = 0;
    for (std::size_t t = 0; t < stresses.size(); ++t) {
      const Eigen::Map<const Eigen::Matrix3d> P(stresses[t].data()), Q(turned_stresses[t].data());
      worst = std::max(worst, (Q - turn_by_30 * P * turn_by_30.transpose()).cwiseAbs().maxCoeff());
    }
    EXPECT_LT(worst, 1e-4);  // of some 400 Pa
    // A state of the body's coordinates leads back.
    const SolverState state = two->state();
    ASSERT_EQ(two->solve_to(0.5, {}).status, NewtonStatus::converged);
    two->restore(state);
    EXPECT_EQ(two->load(), 1);
    expect_near(two->positions(), one->positions(), 1e-9 * size[2], "restored");
  }
}

TEST(SupportAxes, of_a_solver_give_its_tangent_and_linear_steps_turned) {
  const auto made = [](GroupedBar& bar, const LoadCase& load_case) {
    const Loading loading = apply_load_case(load_case, bar.levels, bar.groups);
    return make_solver(bar.levels, loading, settings_of());
  };
  GroupedBar plain, bar;
  for (Point& x : bar.levels[0].rest) x = turned_by_30(x);
  const auto one = made(plain, {symmetric(), {}, {}, {}, {}, 0});
  const auto two = made(bar, {{along_normal("x0"), along_normal("y0"), along_normal("z0")}, {}, {}, {}, {}, 0});
  std::vector<Point> force(plain.levels[0].rest.size()), turned_force(force.size()), positions, moved;
  for (std::size_t n = 0; n < force.size(); ++n) {
    const Point& x = plain.levels[0].rest[n];
    force[n] = {std::sin(30 * x[0] + 1), std::cos(40 * x[1]), x[2]};
    turned_force[n] = turned_by_30(force[n]);
    positions.push_back({x[0] + 0.01 * x[2], x[1], x[2] * 1.02});
    moved.push_back(turned_by_30(positions.back()));
  }
  one->set_positions(positions);
  two->set_positions(moved);
  std::vector<Point> step, turned_step;
  one->solve_linear(force, 1e-13, &step);
  two->solve_linear(turned_force, 1e-13, &turned_step);
  expect_near(turned_step, step, 1e-9 * std::abs(step.back()[2]) + 1e-13, "step");
  expect_near(two->stiffness().product(moved), one->stiffness().product(positions), 1e-9 * 1e4, "product");
}

TEST(SupportAxes, at_any_angle_prescribe_a_node_whose_directions_they_span) {
  // Along x and along (1, 1, 0), which leave z alone: u_x = 0.01, and (u_x + u_y) / sqrt(2) = 0.02.
  GroupedBar bar;
  LoadCase load_case{
      {along("x0", {1, 0, 0}, 0.01), along("x0", {1, 1, 0}, 0.02), {"z0", {.z = 0.0}}}, {}, {}, {}, {}, 0};
  load_case.supports.push_back(along("x0", {0, 1, 0}, 0.02 * std::numbers::sqrt2 - 0.01));  // what follows from these
  const Loading loading = apply_load_case(load_case, bar.levels, bar.groups);
  EXPECT_FALSE(bar.levels[0].axes.has_value());
  const auto solver = make_solver(bar.levels, loading, settings_of());
  ASSERT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
  const auto positions = solver->positions();
  for (const Index n : bar.group("x0").nodes) {
    const auto at = static_cast<std::size_t>(n);
    EXPECT_NEAR(positions[at][0] - bar.levels[0].rest[at][0], 0.01, 1e-12);
    EXPECT_NEAR(positions[at][1] - bar.levels[0].rest[at][1], 0.02 * std::numbers::sqrt2 - 0.01, 1e-12);
  }
}

std::string refusal_of(const std::vector<Support>& supports) {
  GroupedBar bar;
  MeshGroup corner{"corner", {}, {}, bar.group("x0").faces, {}};
  corner.faces.insert(corner.faces.end(), bar.group("y0").faces.begin(), bar.group("y0").faces.end());
  complete(corner, bar.levels[0].mesh.tets);
  bar.groups[0].push_back(corner);
  try {
    static_cast<void>(apply_load_case({supports, {}, {}, {}, {}, 0}, bar.levels, bar.groups));
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

void expect_refused(const std::vector<Support>& supports, const std::string& words) {
  const std::string said = refusal_of(supports);
  EXPECT_NE(said.find(words), std::string::npos) << said;
}

TEST(SupportAxes, that_cannot_be_are_refused_with_their_groups) {
  const Support base{"z0"};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal_of({base, along("x1", {1, 1, 0})}), "accepted");
  expect_refused({base, along("x1", {0, 0, 0})}, "the axis of group 'x1' is (0, 0, 0) and must be a direction");
  expect_refused({base, along("x1", {nan, 0, 1})}, "the axis of group 'x1' is (nan, 0, 1) and must be a direction");
  expect_refused({base, along("x1", {0, 1, 0}, nan)}, "a displacement of group 'x1' is nan");
  expect_refused({base, along_normal("tip")}, "group 'tip' has no faces, and the axis \"normal\" is theirs");
  expect_refused({base, along_normal("corner")}, "the faces of group 'corner' are not flat");
  expect_refused({base, along("x1", {1, 1, 0}, 0.1), along("x1", {2, 2, 0}, 0.2)},
                 "prescribe different displacements along (0.707107, 0.707107, 0) there");
  expect_refused({base, along("x1", {1, 1, 0}), along("y1", {1, 0, 0})},
                 "of group 'x1', (0.707107, 0.707107, 0), and of group 'y1', (1, 0, 0), are at 45 degrees");
  expect_refused({along("z0", {0, 1, 1})}, "rotation about (0, 0.7071, 0.7071)");
}

TEST(SupportAxes, are_refused_where_solvers_do_not_take_them) {
  GroupedBar bar;
  const Loading loading =
      apply_load_case({{{"z0"}, along("x1", {1, 1, 0})}, {}, {}, {}, {}, 0}, bar.levels, bar.groups);
  ASSERT_TRUE(bar.levels[0].axes.has_value());
  (*bar.levels[0].axes)[0][0] *= 1.01;
  try {
    static_cast<void>(make_solver(bar.levels, loading, settings_of()));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("must be perpendicular to each other, of length 1"), std::string::npos);
  }
  DynamicSettings settings;
  settings.solver = settings_of();
  try {
    static_cast<void>(make_implicit_solver(bar.levels, loading, settings));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("motions take x, y, z alone"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace physgen::fem
