// Estimates of what a finer mesh would give, on results whose error is known.
#include <fem/mesh/follow_numbers.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <gtest/gtest.h>
#include <truthcube/estimates.h>
#include <truthcube/plates.h>

#include <cmath>
#include <span>
#include <vector>

namespace physgen::truthcube {
namespace {

using fem::Point;

/// Displacements u(x) + h e(x), and forces on the upper plate 3 + h in all, h being the size of cells.
fem::NodeState results(const fem::MeshLevel& level, double h) {
  fem::NodeState state;
  double on_plate = 0;
  for (const Point& x : level.rest) on_plate += x[2] == 1 ? 1 : 0;
  for (const Point& x : level.rest) {
    state.positions.push_back({x[0] + 0.1 * x[1] * x[2], x[1] + h * 0.3, 0.8 * x[2] - h * 0.4});
    state.forces.push_back({0.0, 0.0, x[2] == 1 ? (3 + h) / on_plate : 7.0});
  }
  return state;
}

/// The nodes that the upper plate holds, of each level.
std::vector<std::vector<fem::Index>> upper_of(std::span<const fem::MeshLevel> levels) {
  return hold_between_plates(levels, default_plate_tolerance).upper.nodes;
}

/// The reaction of forces on a level's nodes.
double reaction_of(const std::vector<fem::Index>& upper, const fem::NodeState& on_level,
                   const std::vector<fem::PlaneContact>& planes = {}) {
  return plate_reaction(fem::in_order(std::span<const Point>(on_level.forces), upper), planes);
}

/// By windows of all nodes, and of one.
Estimates estimates_of(std::span<const fem::MeshLevel> levels, double reaction, const fem::NodeState& fine,
                       const fem::NodeState& coarse, double order = 1) {
  WholeState state({.positions = [&] { return std::vector{fine.positions, coarse.positions}; },
                    .forces = [] { return WholeState::Points(); },
                    .stresses = [] { return std::vector<std::array<double, 9>>(); },
                    .coarser = [&] { return std::optional(coarse); }});
  const std::vector<fem::Index> upper = upper_of(levels)[1];
  const Estimates estimates = make_estimates(levels, upper, reaction, state, order);
  const Estimates again = make_estimates(levels, upper, reaction, state, order, 1);
  EXPECT_EQ(estimates.reaction, again.reaction);
  EXPECT_EQ(estimates.error_rms, again.error_rms);
  EXPECT_EQ(estimates.error_max, again.error_max);
  return estimates;
}

TEST(Estimates, are_exact_where_errors_fall_with_first_order) {
  const auto levels = fem::make_cube_levels(4, 1.0, false);
  const fem::NodeState fine = results(levels[0], 0.25), coarse = results(levels[1], 0.5);
  const double reaction = reaction_of(upper_of(levels)[0], fine);
  EXPECT_NEAR(reaction, -3.25, 1e-14);
  const Estimates estimates = estimates_of(levels, reaction, fine, coarse);
  EXPECT_NEAR(estimates.reaction, -3, 1e-13);
  EXPECT_NEAR(estimates.error_rms, 0.25 * 0.5, 1e-14);
  EXPECT_NEAR(estimates.error_max, 0.25 * 0.5, 1e-14);
}

TEST(Estimates, are_exact_where_errors_fall_with_a_given_order) {
  const auto levels = fem::make_cube_levels(4, 1.0, false);
  for (const double order : {1.0, 1.5, 2.0}) {
    const fem::NodeState fine = results(levels[0], std::pow(0.25, order)),
                         coarse = results(levels[1], std::pow(0.5, order));
    const double reaction = reaction_of(upper_of(levels)[0], fine);
    const Estimates estimates = estimates_of(levels, reaction, fine, coarse, order);
    EXPECT_NEAR(estimates.reaction, -3, 1e-13) << order;
    EXPECT_NEAR(estimates.error_rms, std::pow(0.25, order) * 0.5, 1e-14) << order;
    EXPECT_NEAR(estimates.error_max, std::pow(0.25, order) * 0.5, 1e-14) << order;
  }
}

TEST(Estimates, of_the_reaction_contain_what_plates_push_sides_back_with) {
  const auto levels = fem::make_cube_levels(4, 1.0, false);
  const fem::NodeState fine = results(levels[0], 0.25);
  fem::NodeState coarse = results(levels[1], 0.5);
  const std::vector<fem::PlaneContact> planes{{7, 0}, {0.125, 0}};
  coarse.planes = {{7, 0}, {0.25, 0}};
  const double reaction = reaction_of(upper_of(levels)[0], fine, planes);
  EXPECT_NEAR(reaction, -3.375, 1e-14);
  EXPECT_NEAR(estimates_of(levels, reaction, fine, coarse).reaction, -3, 1e-13);
}

TEST(Estimates, of_the_largest_error_are_not_of_the_mean) {
  const auto levels = fem::make_cube_levels(4, 1.0, false);
  const fem::NodeState fine = results(levels[0], 0.25);
  fem::NodeState coarse = results(levels[1], 0.25);
  coarse.positions[13][1] += 0.2;  // one of 27 nodes
  const Estimates estimates = estimates_of(levels, 0, fine, coarse);
  EXPECT_NEAR(estimates.error_max, 0.2, 1e-14);
  EXPECT_NEAR(estimates.error_rms, 0.2 / std::sqrt(27.0), 1e-14);
}

}  // namespace
}  // namespace physgen::truthcube
