// Bodies without forces at the end, without free components, and states that are set from outside; and what is called
// while a solver is made.
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <cmath>
#include <string>
#include <utility>

#include "bodies.h"

namespace physgen::fem {
namespace {

TEST(BeforeDevice, is_called_once_while_a_solver_is_made_and_ends_it_by_what_it_throws) {
  const Body body = make_truth_cube_body(4, false);
  SolverSettings settings;
  int calls = 0;
  settings.before_device = [&] { ++calls; };
  const auto solver = make_solver(body.levels, body.loading, settings);
  EXPECT_EQ(calls, 1);
  ASSERT_EQ(solver->solve_to(0.05, {}).status, NewtonStatus::converged);
  EXPECT_EQ(calls, 1);
  (void)make_linear_solver(body.levels, body.loading, settings);
  EXPECT_EQ(calls, 2);
  settings.before_device = [] { throw Error("the device is taken"); };
  EXPECT_THROW((void)make_solver(body.levels, body.loading, settings), Error);
}

TEST(NoForces, unloading_leads_back_to_rest) {
  for (const bool patches : {false, true}) {
    for (const bool nested : {false, true}) {
      const Body body = make_truth_cube_body(8, patches);
      SolverSettings settings;
      settings.nested = nested;
      const auto solver = make_solver(body.levels, body.loading, settings);
      ASSERT_EQ(solver->solve_to(0.125, {}).status, NewtonStatus::converged);
      const NewtonResult result = solver->solve_to(0, {});
      EXPECT_EQ(result.status, NewtonStatus::converged) << patches << nested;
      EXPECT_LE(result.steps, 10) << patches << nested;
      EXPECT_EQ(solver->load(), 0) << patches << nested;
      EXPECT_LE(largest_distance(solver->positions(), body.levels[0].rest), 1e-5 * side) << patches << nested;
    }
  }
}

TEST(NoForces, a_load_that_moves_nothing_or_carries_all_is_reached) {
  for (const double way : {0.0, 0.01}) {
    Body body = make_truth_cube_body(8, true);
    for (Point& motion : body.loading.motion) motion = {way, 0, 0};
    SolverSettings settings;
    const auto solver = make_solver(body.levels, body.loading, settings);
    const NewtonResult result = solver->solve_to(1, {});
    EXPECT_EQ(result.status, NewtonStatus::converged) << way;
    EXPECT_LE(result.steps, 5) << way;
    auto expected = body.levels[0].rest;
    for (Point& x : expected) x[0] += way;
    EXPECT_LE(largest_distance(solver->positions(), expected), 1e-5 * side) << way;
  }
}

TEST(NoFreeComponent, plates_take_all_nodes_with_them) {
  const Body body = make_truth_cube_body(1, false);
  SolverSettings settings;
  const auto solver = make_solver(body.levels, body.loading, settings);
  EXPECT_EQ(solver->solve_to(0.1, {}).status, NewtonStatus::converged);
  EXPECT_NEAR(solver->positions()[7][2], 0.9 * side, 1e-15);
}

TEST(SetPositions, prescribed_components_are_where_the_load_has_them_in_the_end) {
  for (const bool nested : {false, true}) {
    const Body body = make_truth_cube_body(8, false);
    SolverSettings settings;
    settings.nested = nested;
    settings.coarsest_nested = 0;
    const auto solver = make_solver(body.levels, body.loading, settings);
    auto squashed = body.levels[0].rest;
    for (Point& x : squashed) x[2] *= 0.9;
    solver->set_positions(squashed);
    EXPECT_EQ(solver->solve_to(0, {}).status, NewtonStatus::converged) << nested;
    EXPECT_LE(largest_distance(solver->positions(), body.levels[0].rest), 1e-5 * side) << nested;
  }
}

/// Where forces near plates are many times the reaction, a loose measure of convergence would accept other states.
TEST(NearlyIncompressible, reactions_are_those_of_a_tight_tolerance_in_every_precision) {
  const auto reaction = [](TangentPrecision precision, double tolerance) {
    const Body body = make_truth_cube_body(8, true);
    SolverSettings settings;
    settings.poissons_ratio = 0.49999;
    settings.precision = precision;
    settings.newton.tolerance = tolerance;
    settings.newton.most_steps = 200;
    const auto solver = make_solver(body.levels, body.loading, settings);
    EXPECT_EQ(solver->solve_to(0.1, {}).status, NewtonStatus::converged);
    const auto forces = solver->forces();
    double sum = 0;
    for (std::size_t n = 0; n < forces.size(); ++n) sum -= body.levels[0].rest[n][2] == side ? forces[n][2] : 0.0;
    return sum;
  };
  const double exact = reaction(TangentPrecision::float64, 1e-9);
  EXPECT_NEAR(reaction(TangentPrecision::float64, 1e-4) / exact, 1, 1e-3);
  EXPECT_NEAR(reaction(TangentPrecision::float32, 1e-4) / exact, 1, 1e-3);
}

TEST(Result, of_a_load_that_is_already_reached_tells_of_its_state) {
  const Body body = make_truth_cube_body(4, true);
  const auto solver = make_solver(body.levels, body.loading, SolverSettings{});
  EXPECT_EQ(solver->solve_to(0, {}).smallest_J, 1);
  const NewtonResult first = solver->solve_to(0.1, {}), again = solver->solve_to(0.1, {});
  EXPECT_DOUBLE_EQ(again.smallest_J, first.smallest_J);
  EXPECT_DOUBLE_EQ(again.reaction, first.reaction);
  EXPECT_DOUBLE_EQ(again.energy, first.energy);
}

TEST(BadInput, volumes_averaged_in_two_ways_or_on_some_levels_only_are_refused) {
  const Body patches = make_truth_cube_body(8, true), tets = make_truth_cube_body(8, false);
  EXPECT_THROW((void)make_solver(with(Volume::nodes, patches.levels), patches.loading, SolverSettings{}), Error);
  auto some = tets.levels;
  some[1].averages_at_nodes = true;
  EXPECT_THROW((void)make_solver(some, tets.loading, SolverSettings{}), Error);
  some = with(Volume::nodes, tets.levels);
  some[1].averages_at_nodes = false;
  EXPECT_THROW((void)make_solver(some, tets.loading, SolverSettings{}), Error);
}

TEST(BadInput, materials_whose_volume_cannot_be_averaged_at_nodes_are_refused_with_those_that_can) {
  const Body body = with(Volume::nodes, make_truth_cube_body(4, false));
  SolverSettings settings;
  settings.material = "st-venant-kirchhoff";
  try {
    (void)make_solver(body.levels, body.loading, settings);
    FAIL() << "no error";
  } catch (const Error& error) {
    const std::string text = error.what();
    for (const char* word : {"st-venant-kirchhoff", "nodes", "neo-hookean", "mooney-rivlin", "tets"}) {
      EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
    }
  }
}

TEST(BadInput, cubes_without_cells_are_refused_however_coarse_the_coarsest_may_be) {
  for (const Index cells : {0, -2}) {
    for (const Index coarsest : {2, 0, -4}) EXPECT_THROW((void)make_cube_levels(cells, side, false, coarsest), Error);
  }
}

TEST(BadInput, patch_parents_that_do_not_fit_are_refused) {
  const Body body = make_truth_cube_body(8, true);
  auto fewer = body.levels, outside = body.levels;
  fewer[0].patch_parents.resize(3);
  outside[0].patch_parents[5] = 1 << 30;
  EXPECT_THROW((void)make_solver(fewer, body.loading, SolverSettings{}), Error);
  EXPECT_THROW((void)make_solver(outside, body.loading, SolverSettings{}), Error);
}

TEST(State, that_is_no_equilibrium_is_solved_for_after_it_is_restored) {
  const Body body = make_truth_cube_body(8, true);
  SolverSettings settings = exact_settings("neo-hookean", 0.4);
  const auto solver = make_solver(body.levels, body.loading, settings);
  ASSERT_EQ(solver->solve_to(0.1, {}).status, NewtonStatus::converged);
  const auto expected = solver->positions();
  auto moved = expected;
  for (Point& x : moved) x[0] *= 1.05;
  solver->set_positions(moved);
  const SolverState state = solver->state();
  EXPECT_FALSE(state.is_equilibrium);
  solver->restore(state);
  EXPECT_FALSE(solver->coarser_equilibrium().has_value());
  const NewtonResult result = solver->solve_to(0.1, {});
  EXPECT_EQ(result.status, NewtonStatus::converged);
  EXPECT_GT(result.steps, 0);
  EXPECT_LE(largest_distance(solver->positions(), expected), 1e-9 * side);
}

TEST(NoLoad, is_no_equilibrium_where_a_plane_pushes_at_rest) {
  Body body = make_truth_cube_body(4, false);
  body.loading.planes = {{{1, 0, 0}, 0.004, 0}};
  const auto solver = make_solver(body.levels, body.loading, exact_settings("neo-hookean", 0.3));
  const NewtonResult result = solver->solve_to(0, {});
  EXPECT_EQ(result.status, NewtonStatus::converged);
  EXPECT_GT(result.steps, 0);
  EXPECT_LE(result.residual, 1e-10);
  EXPECT_GT(solver->plane_contacts().at(0).force, 0);
}

/// Squares of such forces are 0 in float.
TEST(SmallBodies, of_micrometres_meet_planes_as_large_ones_do) {
  constexpr double scale = 1e-5 / side;
  Body body = make_truth_cube_body(8, true);
  for (MeshLevel& level : body.levels) {
    for (Point& x : level.rest) {
      for (double& component : x) component *= scale;
    }
  }
  body.loading.motion.assign(body.levels[0].rest.size(), Point{});
  body.loading.planes = {{{1, 0, 0}, -0.01 * 1e-5, 0.1 * 1e-5}};
  SolverSettings settings;
  settings.youngs_modulus = 1e3;
  const auto solver = make_solver(body.levels, body.loading, settings);
  EXPECT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
  EXPECT_GT(solver->plane_contacts().at(0).force, 0);
}

std::string refusal(const Body& body, const SolverSettings& settings) {
  try {
    (void)make_solver(body.levels, body.loading, settings);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BadInput, rest_positions_that_are_not_finite_and_tets_without_volume_are_named) {
  const Body good = make_truth_cube_body(4, false);
  Body nan = good, inverted = good, flat = good;
  nan.levels[1].rest[13][1] = NAN;
  EXPECT_NE(refusal(nan, {}).find("level 1: the rest position of node 13 is ("), std::string::npos) << refusal(nan, {});
  EXPECT_NE(refusal(nan, {}).find(", nan, "), std::string::npos) << refusal(nan, {});
  auto tets = good.levels[0].mesh.tets;
  std::swap(tets[5][0], tets[5][1]);
  inverted.levels[0].mesh = make_tet_mesh(good.levels[0].mesh.nodes, tets);
  EXPECT_NE(refusal(inverted, {}).find("level 0: tet 5 has the volume -1.33333e-06 m^3 at rest"), std::string::npos)
      << refusal(inverted, {});
  for (Point& x : flat.levels[0].rest) x[2] = 0;
  EXPECT_NE(refusal(flat, {}).find("level 0: tet 0 has the volume 0 m^3 at rest"), std::string::npos);
}

TEST(BadInput, moduli_and_lengths_beyond_single_precision_are_refused_and_double_takes_them) {
  constexpr struct {
    double modulus, scale;
  } cases[] = {{1e36, 1}, {1e-36, 1}, {1, 1e-12}, {1e30, 1e-9}, {1e20, 1e9}};
  for (const auto& [modulus, scale] : cases) {
    Body body = make_truth_cube_body(2, true);
    for (MeshLevel& level : body.levels) {
      for (Point& x : level.rest) {
        for (double& component : x) component *= scale;
      }
    }
    for (Point& motion : body.loading.motion) motion[2] *= scale;
    SolverSettings settings;
    settings.youngs_modulus = modulus;
    for (const TangentPrecision precision : {TangentPrecision::half, TangentPrecision::float32}) {
      settings.precision = precision;
      EXPECT_NE(refusal(body, settings).find("is out of range for float: take double precision"), std::string::npos)
          << modulus << " " << scale;
    }
    settings.precision = TangentPrecision::float64;
    const auto solver = make_solver(body.levels, body.loading, settings);
    const NewtonResult result = solver->solve_to(0.1, {});
    EXPECT_EQ(result.status, NewtonStatus::converged) << modulus << " " << scale;
    EXPECT_LE(result.steps, 4) << modulus << " " << scale;
  }
}

TEST(BadInput, nodes_in_no_tet_are_named_where_volumes_are_averaged_at_nodes) {
  Body body = make_truth_cube_body(2, false);
  body.levels.resize(1);
  MeshLevel& level = body.levels[0];
  level.parents.clear();
  level.mesh = make_tet_mesh(level.mesh.nodes + 1, level.mesh.tets);
  level.rest.push_back({1, 1, 1});
  level.fixed.push_back(0);
  level.averages_at_nodes = true;
  body.loading.motion.push_back({});
  try {
    (void)make_solver(body.levels, body.loading, SolverSettings{});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("node 27 is in no tet"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace physgen::fem
