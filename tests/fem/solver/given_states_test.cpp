// States and positions that are set from outside: which are refused; and that arrays are read and written from outside
// only when the steps that use them have ended.
#include <fem/solver/arrays/host_points.h>
#include <fem/solver/arrays/node_vectors.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bodies.h"

namespace physgen::fem {
namespace {

TEST(State, of_other_meshes_or_with_numbers_that_are_not_finite_is_refused_and_changes_nothing) {
  const Body body = make_truth_cube_body(8, true);
  SolverSettings settings;
  settings.coarsest_nested = 0;
  const auto solver = make_solver(body.levels, body.loading, settings);
  ASSERT_EQ(solver->solve_to(0.05, {}).status, NewtonStatus::converged);
  const SolverState good = solver->state();
  ASSERT_GE(good.positions.size(), 2U);
  const auto expect_refused = [&](const std::string& said, const auto& spoil) {
    SolverState state = good;
    spoil(state);
    try {
      solver->restore(state);
      ADD_FAILURE() << "accepted: " << said;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
    }
    EXPECT_EQ(solver->load(), 0.05);
    EXPECT_EQ(solver->state().positions, good.positions);
  };
  expect_refused("the load of a state is nan", [](SolverState& state) { state.load = NAN; });
  expect_refused("the load of a state is inf", [](SolverState& state) { state.load = INFINITY; });
  expect_refused("of a state: the position of node 7 is (", [](SolverState& state) { state.positions[0][7][1] = NAN; });
  expect_refused("level 1 of a state: the position of node 3 is (inf",
                 [](SolverState& state) { state.positions[1][3][0] = INFINITY; });
  expect_refused("level 1 has 125 nodes, but that of the state has 124",
                 [](SolverState& state) { state.positions[1].pop_back(); });
  expect_refused("levels, but this solver solves on", [](SolverState& state) { state.positions.pop_back(); });
  solver->restore(good);
  EXPECT_EQ(solver->solve_to(0.1, {}).status, NewtonStatus::converged);
}

TEST(SetPositions, that_are_not_finite_or_not_one_of_each_node_is_refused_with_the_node) {
  const Body body = make_truth_cube_body(2, false);
  const auto solver = make_solver(body.levels, body.loading, SolverSettings{});
  const auto refusal = [&](const std::vector<Point>& positions) -> std::string {
    try {
      solver->set_positions(positions);
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  auto positions = body.levels[0].rest;
  positions[5] = {0, NAN, 0.01};
  EXPECT_NE(refusal(positions).find("the position of node 5 is (0, nan, 0.01): give finite components"),
            std::string::npos);
  positions.pop_back();
  EXPECT_NE(refusal(positions).find("the position is given for 26 nodes of 27: give one vector for each node"),
            std::string::npos);
  EXPECT_EQ(solver->positions(), body.levels[0].rest);
}

/// Does what it was given when it is waited for, as a device may.
struct LateExecutor {
  std::function<void()> given;
  void wait() {
    std::exchange(given, [] {})();
  }
};

TEST(PlainNumbers, are_those_that_the_last_steps_of_an_executor_leave) {
  elasticity::NodePositionArray<double> positions(3);
  elasticity::NodeForceArray<double> forces(3);
  elasticity::StressArray<double> stresses(3);
  elasticity::NodeDisplacementArray<double> displacements(3);
  dynamics::NodeVelocityArray<double> velocities(3);
  const auto set = [&](double first, double step) {
    for (index_t n = 0; n < 3; ++n) {
      const double number = first + step * static_cast<double>(n);
      positions[n].x()[1] = forces[n].f()[1] = displacements[n].dx()[1] = velocities[n].v()[1] = number;
      stresses[n].P()[4] = number;
    }
  };
  const auto late = [&] {
    set(-7, 0);
    return LateExecutor{[&] { set(1, 1); }};
  };
  const std::vector<Point> expected{{0, 1, 0}, {0, 2, 0}, {0, 3, 0}};
  LateExecutor on = late();
  EXPECT_EQ(points(on, positions), expected);
  on = late();
  EXPECT_EQ(plain_forces(on, forces), expected);
  on = late();
  EXPECT_EQ(plain_displacements(on, displacements), expected);
  on = late();
  EXPECT_EQ(plain_velocities(on, velocities), expected);
  on = late();
  EXPECT_EQ(plain_stresses(on, stresses)[2][4], 3);

  // What is still to be done when a state is given does not write over it.
  const std::vector<Point> given{{4, 5, 6}, {7, 8, 9}, {10, 11, 12}};
  on = late();
  store_displacements(on, given, displacements);
  on.wait();
  EXPECT_EQ(plain_displacements(on, displacements), given);
  on = late();
  store_velocities(on, given, velocities);
  on.wait();
  EXPECT_EQ(plain_velocities(on, velocities), given);
}

}  // namespace
}  // namespace physgen::fem
