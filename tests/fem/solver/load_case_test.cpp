// Bodies that are held and loaded on groups of their mesh: against exact solutions, in equilibrium with their
// reactions, turned, and back at rest; and load cases that no body can be in.
#include <fem/mesh/boundary.h>
#include <fem/solver/load_case.h>
#include <fem/solver/rigid_motions.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "grouped_bar.h"

namespace physgen::fem {
namespace {

double area_mean(const GroupedBar& bar, const std::string& group, const std::vector<Point>& positions, std::size_t k) {
  const auto areas = surface_areas(bar.levels[0].rest, bar.group(group).faces);
  double sum = 0, area = 0;
  for (const Index n : bar.group(group).nodes) {
    const auto at = static_cast<std::size_t>(n);
    sum += areas[at] * (positions[at][k] - bar.levels[0].rest[at][k]);
    area += areas[at];
  }
  return sum / area;
}

std::string refusal(LoadCase load_case) {
  GroupedBar bar;
  try {
    static_cast<void>(apply_load_case(load_case, bar.levels, bar.groups));
  } catch (const Error& error) {
    return std::string(error.what()).substr(std::string("physgen: ").size());
  }
  return "accepted";
}

TEST(LoadCases, that_pull_a_linear_elastic_bar_give_its_uniform_stress_to_rounding) {
  constexpr double pull = 70, nu = 0.3, young = 1e4;
  // As a traction, a force, and a pressure, and as what prescribes the end that these find.
  for (int way = 0; way < 4; ++way) {
    GroupedBar bar;
    LoadCase load_case{symmetric(), {}, {}, {}, {}, 0};
    if (way == 0) load_case.tractions.push_back({"z1", {0, 0, pull}});
    if (way == 1) load_case.forces.push_back({"z1", {0, 0, pull * size[0] * size[1]}});
    if (way == 2) load_case.pressures.push_back({"z1", -pull});
    if (way == 3) load_case.supports.push_back({"z1", {.z = pull / young * size[2]}});
    const Loading loading = apply_load_case(load_case, bar.levels, bar.groups);
    const auto solver = make_linear_solver(bar.levels, loading, settings_of(nu));
    ASSERT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
    const auto positions = solver->positions();
    for (std::size_t n = 0; n < positions.size(); ++n) {
      const Point& x = bar.levels[0].rest[n];
      for (std::size_t k = 0; k < 3; ++k) {
        const double strain = pull / young * (k == 2 ? 1 : -nu);
        EXPECT_NEAR(positions[n][k], x[k] * (1 + strain), 1e-11) << way << " node " << n;
      }
    }
    for (const auto& stress : solver->stresses()) {
      for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(stress[k], k == 8 ? pull : 0, 1e-7 * pull) << way;
    }
  }
}

TEST(LoadCases, of_gravity_move_the_end_of_a_hanging_bar_by_what_beams_say) {
  // By duality with a uniform pull, which tets have exactly, the mean of the end's motion is exact on any mesh.
  constexpr double density = 1000, g = 9.81, young = 1e4;
  GroupedBar bar;
  const LoadCase load_case{symmetric(), {}, {}, {}, {0, 0, -g}, density};
  const Loading loading = apply_load_case(load_case, bar.levels, bar.groups);
  const auto solver = make_linear_solver(bar.levels, loading, settings_of());
  ASSERT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
  const double exact = -density * g * size[2] * size[2] / (2 * young);
  EXPECT_NEAR(area_mean(bar, "z1", solver->positions(), 2), exact, 1e-9 * std::abs(exact));
  const Point held = reaction_of(bar.group("z0").nodes, bar.levels[0], solver->forces());
  const double weight = density * g * size[0] * size[1] * size[2];
  EXPECT_NEAR(held[2], weight, 1e-9 * weight);
}

TEST(LoadCases, are_balanced_by_reactions_on_nested_meshes_with_patches_too) {
  for (const bool patches : {false, true}) {
    GroupedBar bar(patches, 1);
    LoadCase load_case{
        {{"z0"}}, {{"z1", {0.9, 0, 0.4}}, {"tip", {0, 0.1, 0}}, {"all", {0, -0.3, 0}}}, {}, {}, {0.3, 0, -0.5}, 800};
    load_case.tractions.push_back({"x1", {2, 3, 4}});
    load_case.pressures.push_back({"y1", 9});
    const Loading loading = apply_load_case(load_case, bar.levels, bar.groups);
    SolverSettings settings = settings_of(0.45);
    settings.nested = true;
    settings.coarsest_nested = 0;
    const auto solver = make_solver(bar.levels, loading, settings);
    ASSERT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
    const double mass = 800 * size[0] * size[1] * size[2], side = size[1] * size[2];
    const Point total{0.9 + 0.3 * mass + 2 * side, 0.1 - 0.3 + 3 * side - 9 * size[0] * size[2],
                      0.4 - 0.5 * mass + 4 * side};
    const Point held = reaction_of(bar.group("z0").nodes, bar.levels[0], solver->forces());
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(held[k], -total[k], 1e-9 * mass) << patches << " " << k;
    const Point given = sum_of(bar.group("all").nodes, loading.forces);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(given[k], total[k], 1e-12 * mass) << k;
  }
}

TEST(LoadCases, of_a_turned_body_give_turned_results) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
  const auto turned = [&](const Point& x) {
    const Eigen::Vector3d y = turn * Eigen::Vector3d(x.data());
    return Point{y[0], y[1], y[2]};
  };
  const auto solve = [&](bool turns) {
    GroupedBar bar(true);
    const auto seen = [&](const Point& x) { return turns ? turned(x) : x; };
    for (Point& x : bar.levels[0].rest) x = seen(x);
    LoadCase load_case{{{"z0"}},     {{"z1", seen({2, 0, 0})}}, {{"x1", seen({0, 3, -2})}},
                       {{"y1", 20}}, seen({0, 0, -2}),          1000};
    const Loading loading = apply_load_case(load_case, bar.levels, bar.groups);
    const auto solver = make_solver(bar.levels, loading, settings_of(0.45));
    EXPECT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
    EXPECT_GT(largest_distance(solver->positions(), bar.levels[0].rest), 0.02);
    return solver->positions();
  };
  std::vector<Point> straight = solve(false);
  for (Point& x : straight) x = turned(x);
  EXPECT_LT(largest_distance(straight, solve(true)), 1e-9);
}

TEST(LoadCases, that_are_unloaded_lead_back_to_rest) {
  GroupedBar bar;
  const LoadCase load_case{{{"z0"}, {"z1", {.x = 0.04}}}, {}, {{"y1", {0, 0, -60}}}, {}, {0, -1, 0}, 1000};
  const Loading loading = apply_load_case(load_case, bar.levels, bar.groups);
  const auto solver = make_solver(bar.levels, loading, settings_of());
  std::vector<Point> up;
  for (const double load : {0.5, 1.0, 0.5, 0.0, -0.5, 0.0}) {
    ASSERT_EQ(solver->solve_to(load, {}).status, NewtonStatus::converged) << load;
    if (load == 0.5 && up.empty()) up = solver->positions();
    if (load == 0.5) {
      EXPECT_LT(largest_distance(solver->positions(), up), 1e-9);
    }
    if (load == 0) {
      EXPECT_LT(largest_distance(solver->positions(), bar.levels[0].rest), 1e-9);
    }
  }
}

TEST(LoadCases, that_leave_a_body_free_are_refused_and_its_rigid_motions_are_named) {
  const std::string start = "nothing keeps the body from moving as a rigid body: ",
                    end = "; add supports that prescribe components against that";
  EXPECT_EQ(refusal({{}, {{"z1", {0, 0, 1}}}, {}, {}, {}, 0}),
            start +
                "translation along x, translation along y, translation along z, rotation about x, rotation about y, "
                "rotation about z" +
                end);
  EXPECT_EQ(refusal({{{"z0", {.z = 0.0}}}, {}, {}, {}, {}, 0}),
            start + "translation along x, translation along y, rotation about z" + end);
  EXPECT_EQ(refusal({{{"tip"}}, {}, {}, {}, {}, 0}),
            start +
                "rotation about x through (0, 0.3, 0.5) m, rotation about y through (0.2, 0, 0.5) m, rotation about z "
                "through (0.2, 0.3, 0) m" +
                end);
  EXPECT_EQ(refusal({{{"x0", {.x = 0.0}}, {"y0", {.y = 0.0}}}, {}, {}, {}, {}, 0}),
            start + "translation along z" + end);
  EXPECT_EQ(refusal({symmetric(), {}, {}, {}, {}, 0}), "accepted");
  EXPECT_EQ(refusal({{{"x0", {.x = 0.0}}, {"tip"}}, {}, {}, {}, {}, 0}),
            start + "rotation about x through (0, 0.3, 0.5) m" + end);
}

TEST(LoadCases, of_a_part_that_nothing_holds_name_the_part) {
  const std::vector<Point> rest{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0}, {6, 1, 1}, {5, 1, 0}, {5, 0, 1}};
  const TetMesh mesh = make_tet_mesh(8, {{0, 1, 2, 3}, {4, 5, 6, 7}});
  // Two nodes of the second one, along a diagonal: it may turn about that.
  const std::vector<std::uint8_t> fixed{7, 7, 7, 0, 7, 7, 0, 0};
  try {
    require_held(mesh, rest, fixed);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "physgen: nothing keeps the part with the node at (5, 0, 0) m from moving as a rigid body: rotation "
              "about (0.5774, 0.5774, "
              "0.5774) through (3.333, -1.667, -1.667) m; add supports that prescribe components against that");
  }
}

TEST(LoadCases, that_contradict_themselves_or_the_mesh_are_refused_with_group_value_and_remedy) {
  const LoadCase held{{{"z0"}}, {}, {}, {}, {}, 0};
  LoadCase wrong = held;
  wrong.supports.push_back({"x0", {.x = 0.01}});
  EXPECT_EQ(
      refusal(wrong),
      "groups 'z0' and 'x0' share the node at (0, 0, 0) m at rest and prescribe different displacements along x there, "
      "0 and 0.01 m; leave that component free in one of them");
  wrong = held;
  wrong.tractions.push_back({"tip", {1, 0, 0}});
  EXPECT_EQ(refusal(wrong), "group 'tip' has no faces, and a traction needs them; take a group of a surface");
  wrong = held;
  wrong.forces.push_back({"empty", {1, 0, 0}});
  EXPECT_TRUE(
      refusal(wrong).starts_with("group 'empty' has no node of a tet, so that there is nothing for a force to act on"));
  wrong = held;
  wrong.forces.push_back({"z2", {1, 0, 0}});
  EXPECT_TRUE(refusal(wrong).starts_with("the mesh has no group 'z2'; did you mean 'z"));
  wrong = held;
  wrong.gravity[1] = NAN;
  EXPECT_EQ(refusal(wrong), "gravity is nan and must be a finite number");
}

}  // namespace
}  // namespace physgen::fem
