// Loads that follow curves of their own: against loads given one by one, up and down, and curves that are none.
#include <fem/solver/load_history.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include "grouped_bar.h"

namespace physgen::fem {
namespace {

/// A pull in x that rises and falls, a pull in z that grows with the load, a weight from the beginning, and an end that
/// is moved along y when the pull has fallen.
LoadCase moving_case() {
  LoadCase load_case{{{"z0"}, {"z1", {.y = 0.03}, "late"}}, {{"tip", {0.4, 0, 0}, "breath"}}, {}, {}, {0, 0, -1}, 900};
  load_case.tractions.push_back({"z1", {0, 0, 40}});
  load_case.gravity_curve = "always";
  load_case.curves = {{"breath", {{0, 0}, {1, 1}, {2, 0}}}, {"always", {{0, 1}}}, {"late", {{1, 0}, {3, 2}}}};
  return load_case;
}

/// What the factors make of it at once.
LoadCase case_at(double load) {
  LoadCase at = moving_case();
  const auto factor = [&](const std::string& curve) {
    if (curve == "breath") return std::max(0.0, 1 - std::abs(load - 1));
    return curve == "late" ? std::clamp(load - 1, 0.0, 2.0) : (curve == "always" ? 1.0 : load);
  };
  at.supports[1].displacement.y = 0.03 * factor("late");
  at.forces[0].force[0] *= factor("breath");
  at.tractions[0].traction[2] *= factor("");
  at.supports[1].curve = at.forces[0].curve = at.gravity_curve = "";
  at.curves.clear();
  return at;
}

TEST(LoadHistories, lead_through_the_equilibria_of_their_loads_on_nested_meshes_too) {
  for (const int refinements : {0, 1}) {
    GroupedBar bar(refinements > 0, refinements);
    SolverSettings settings = settings_of(0.4);
    settings.nested = refinements > 0;
    settings.coarsest_nested = 0;
    const LoadHistory history = make_load_history(moving_case(), bar.levels, bar.groups);
    const auto solver = follow(make_solver(bar.levels, history.at(0), settings), history);
    for (const double load : {0.0, 0.5, 1.0, 2.5, 1.0, 4.0}) {
      ASSERT_EQ(solver->solve_to(load, {}).status, NewtonStatus::converged) << load;
      EXPECT_EQ(solver->load(), load);
      GroupedBar other(refinements > 0, refinements);
      const Loading at_once = apply_load_case(case_at(load), other.levels, other.groups);
      const auto expected = make_solver(other.levels, at_once, settings);
      ASSERT_EQ(expected->solve_to(1, {}).status, NewtonStatus::converged) << load;
      EXPECT_GT(largest_distance(expected->positions(), bar.levels[0].rest), 1e-4) << load;
      EXPECT_LT(largest_distance(expected->positions(), solver->positions()), 1e-9) << refinements << " " << load;
    }
  }
}

TEST(LoadHistories, of_linear_elastic_bodies_are_sums_of_what_their_loads_do) {
  GroupedBar bar;
  const LoadHistory history = make_load_history(moving_case(), bar.levels, bar.groups);
  const auto solver = follow(make_linear_solver(bar.levels, history.at(0), settings_of()), history);
  for (const double load : {0.0, 1.0, 1.75, 0.5}) {
    ASSERT_EQ(solver->solve_to(load, {}).status, NewtonStatus::converged) << load;
    GroupedBar other;
    const Loading at_once = apply_load_case(case_at(load), other.levels, other.groups);
    const auto expected = make_linear_solver(other.levels, at_once, settings_of());
    ASSERT_EQ(expected->solve_to(1, {}).status, NewtonStatus::converged);
    EXPECT_LT(largest_distance(expected->positions(), solver->positions()), 1e-11) << load;
  }
}

TEST(LoadHistories, are_gone_along_in_halves_where_a_step_is_too_large_and_keep_their_last_equilibrium) {
  GroupedBar bar;
  LoadCase load_case{{{"z0"}, {"z1", {.x = 0.0, .y = 0.0, .z = -0.05}, "down"}}, {}, {}, {}, {}, 0};
  load_case.curves = {{"down", {{0, 0}, {1, 2}, {2, 20}}}};
  const LoadHistory history = make_load_history(load_case, bar.levels, bar.groups);
  SolverSettings settings = settings_of();
  settings.newton.most_steps = 8;
  const auto solver = follow(make_solver(bar.levels, history.at(0), settings), history, 3);
  ASSERT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
  const std::vector<Point> before = solver->positions();
  const NewtonResult beyond = solver->solve_to(2, {});  // the end would be past the base
  EXPECT_NE(beyond.status, NewtonStatus::converged);
  EXPECT_GT(beyond.bisections, 0);
  EXPECT_GE(solver->load(), 1);
  EXPECT_LT(solver->load(), 2);
  ASSERT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
  EXPECT_LT(largest_distance(before, solver->positions()), 1e-8);
}

TEST(LoadHistories, go_on_from_a_state_that_is_restored) {
  GroupedBar bar;
  const LoadHistory history = make_load_history(moving_case(), bar.levels, bar.groups);
  const auto solver = follow(make_solver(bar.levels, history.at(0), settings_of()), history);
  ASSERT_EQ(solver->solve_to(0.5, {}).status, NewtonStatus::converged);
  const SolverState state = solver->state();
  ASSERT_EQ(solver->solve_to(2, {}).status, NewtonStatus::converged);
  const auto other = follow(make_solver(bar.levels, history.at(0), settings_of()), history);
  other->restore(state);
  EXPECT_EQ(other->load(), 0.5);
  ASSERT_EQ(other->solve_to(2, {}).status, NewtonStatus::converged);
  EXPECT_LT(largest_distance(other->positions(), solver->positions()), 1e-9);
}

TEST(LoadCurves, are_linear_between_their_points_and_constant_beyond) {
  const LoadCurve curve{"c", {{1, 3}, {2, -1}, {4, 0}}};
  for (const auto& [load, factor] :
       std::vector<std::array<double, 2>>{{-5, 3}, {1, 3}, {1.5, 1}, {2, -1}, {3, -0.5}, {4, 0}, {9, 0}}) {
    EXPECT_DOUBLE_EQ(curve.at(load), factor) << load;
  }
}

template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return std::string(error.what()).substr(std::string("physgen: ").size());
  }
  return "accepted";
}

TEST(LoadCurves, that_are_none_or_missing_are_refused_with_name_and_remedy) {
  const auto with = [](const std::vector<std::array<double, 2>>& points, const std::string& named = "c") {
    return refusal([&] {
      GroupedBar bar;
      LoadCase load_case{{{"z0", {0.0, 0.0, 0.0}, named}}, {}, {}, {}, {}, 0};
      load_case.curves = {{"c", points}};
      static_cast<void>(make_load_history(load_case, bar.levels, bar.groups));
    });
  };
  EXPECT_EQ(with({{0, 1}}), "accepted");
  EXPECT_EQ(with({}), "the curve 'c' has no points; give at least one: a load and a factor");
  EXPECT_EQ(with({{0, NAN}}), "the curve 'c' has a point 0 that is not finite; give a load and a factor");
  EXPECT_EQ(with({{0, 1}, {0, 2}}),
            "the curve 'c' does not ascend at point 1: 0.000000 follows 0.000000; order the points by their loads");
  EXPECT_EQ(with({{0, 1}}, "cc"), "there is no curve 'cc'; did you mean 'c'?");
  GroupedBar bar;
  EXPECT_EQ(refusal([&] { static_cast<void>(apply_load_case(moving_case(), bar.levels, bar.groups)); }),
            "a load case with curves is a history of loads; take make_load_history(), and follow() it");
}

TEST(Loadings, that_cannot_replace_another_are_refused) {
  GroupedBar bar;
  const Loading loading = apply_load_case({symmetric(), {}, {}, {}, {}, 0}, bar.levels, bar.groups);
  const auto solver = make_solver(bar.levels, loading, settings_of());
  Loading other = loading;
  other.planes.push_back({{0, 0, 1}, 0, 0});
  EXPECT_EQ(refusal([&] { solver->set_loading(other); }),
            "a loading with rigid planes cannot be replaced, nor can it replace one; make another solver");
  other = loading;
  other.pressures.push_back({{{0, 1, 2}}, 1});
  EXPECT_TRUE(refusal([&] {
                solver->set_loading(other);
              }).starts_with("pressures that follow the surface push other faces than those of the loading"));
  other = loading;
  other.forces.resize(2);
  EXPECT_TRUE(refusal([&] { solver->set_loading(other); }).starts_with("the external force is given for 2 nodes of "));
}

}  // namespace
}  // namespace physgen::fem
