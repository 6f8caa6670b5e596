// The Truth Cube between plates that its free sides touch: how far they still fold past, and that nothing else changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "bodies.h"

namespace physgen::fem {
namespace {

SolverSettings silicone() {
  SolverSettings settings;
  settings.poissons_ratio = 0.49;
  return settings;
}

/// How far positions reach past the plates [m].
double reach(const std::vector<Point>& positions, double compression) {
  double most = 0;
  for (const Point& x : positions) most = std::max({most, -x[2], x[2] - side * (1 - compression)});
  return most;
}

TEST(Contact, where_nothing_touches_changes_no_bit) {
  for (const bool nested : {true, false}) {
    for (const bool frictionless : {true, false}) {
      const Body body = make_truth_cube_body(16, true, frictionless);
      SolverSettings settings = silicone();
      settings.nested = nested;
      const Body plates = with_contact(body);
      const auto without = make_solver(body.levels, body.loading, settings);
      const auto with = make_solver(plates.levels, plates.loading, settings);
      ASSERT_EQ(without->solve_to(0.03, {}).status, NewtonStatus::converged);
      ASSERT_EQ(with->solve_to(0.03, {}).status, NewtonStatus::converged);
      EXPECT_EQ(with->positions(), without->positions());
      EXPECT_EQ(with->forces(), without->forces());
      for (const PlaneContact& contact : with->plane_contacts()) {
        EXPECT_EQ(contact.force, 0);
        EXPECT_EQ(contact.depth, 0);
      }
      EXPECT_TRUE(without->plane_contacts().empty());
      EXPECT_GT(with->bytes(), without->bytes());
    }
  }
}

TEST(Contact, of_the_compressed_truth_cube_keeps_its_sides_between_the_plates_and_its_beads_in_place) {
  for (const Index cells : {8, 16}) {
    for (const bool frictionless : {false, true}) {
      const Body body = make_truth_cube_body(cells, true, frictionless), plates = with_contact(body);
      const auto without = make_solver(body.levels, body.loading, silicone());
      const auto with = make_solver(plates.levels, plates.loading, silicone());
      for (const double compression : {0.1825, cells == 8 ? 0.5 : 0.4}) {
        const NewtonResult free = without->solve_to(compression, {}), result = with->solve_to(compression, {});
        ASSERT_EQ(free.status, NewtonStatus::converged);
        ASSERT_EQ(result.status, NewtonStatus::converged);
        EXPECT_EQ(result.bisections, 0);
        EXPECT_LE(result.steps, free.steps + 4);
        EXPECT_LE(result.coarse_steps, free.coarse_steps + 8);
        const auto a = without->positions(), b = with->positions();
        double depth = 0, force = 0;
        for (const PlaneContact& contact : with->plane_contacts()) {
          depth = std::max(depth, contact.depth);
          force = std::max(force, contact.force);
        }
        EXPECT_NEAR(depth, reach(b, compression), 1e-12);
        if (!frictionless && compression > 0.2) {
          EXPECT_GT(depth, 0);
          EXPECT_GT(reach(a, compression), 10 * depth);
        }
        EXPECT_LE(depth, 5e-5);
        double beads = 0, all = 0;
        for (std::size_t n = 0; n < a.size(); ++n) {
          const Point& X = body.levels[0].rest[n];
          const double moved = std::hypot(a[n][0] - b[n][0], a[n][1] - b[n][1], a[n][2] - b[n][2]);
          all = std::max(all, moved);
          const auto inside = [&](double x) { return x > 0.0099 && x < side - 0.0099; };  // beads: 1 to 7 cm
          if (inside(X[0]) && inside(X[1]) && inside(X[2])) beads = std::max(beads, moved);
        }
        EXPECT_LE(beads, compression < 0.2 ? 5e-5 : 0.4 * reach(a, compression));
        std::printf(
            "%d^3 cells, %s, %g: past the plates by %.4f mm without and %.4f mm with contact of up to %.3g of E mm^2; "
            "nodes move by up to %.4f mm, beads by %.4f mm; %d + %d and %d + %d Newton steps, %d and %d PCG "
            "iterations, "
            "%d filtered, smallest J %.3f and %.3f\n",
            cells, frictionless ? "frictionless" : "bonded", compression, 1e3 * reach(a, compression), 1e3 * depth,
            1e6 * force, 1e3 * all, 1e3 * beads, free.steps, free.coarse_steps, result.steps, result.coarse_steps,
            free.iterations, result.iterations, result.filtered, free.smallest_J, result.smallest_J);
      }
    }
  }
}

TEST(Contact, in_load_steps_leads_where_nested_iteration_does) {
  const Body body = with_contact(make_truth_cube_body(16, true));
  std::vector<std::vector<Point>> found;
  for (const bool nested : {true, false}) {
    SolverSettings settings = silicone();
    settings.nested = nested;
    settings.newton.tolerance = 1e-9;
    const auto solver = make_solver(body.levels, body.loading, settings);
    for (const double compression : {0.125, 0.4}) {
      const NewtonResult result = solver->solve_to(compression, {});
      ASSERT_EQ(result.status, NewtonStatus::converged);
      EXPECT_EQ(result.bisections, 0);
      std::printf("nested %d, %g: %d Newton steps, %d shortened\n", int(nested), compression, result.steps,
                  result.halvings);
      EXPECT_LE(result.steps, 12);
    }
    EXPECT_GT(solver->plane_contacts().at(0).force, 0);
    found.push_back(solver->positions());
  }
  EXPECT_LE(largest_distance(found[0], found[1]), 1e-8 * side);
}

/// The mesh is its own mirror image along each axis, and so is what moves it, seen from half-way between the plates.
TEST(Contact, of_bonded_plates_is_symmetric) {
  constexpr Index cells = 16;
  constexpr double compression = 0.4;
  const Body body = with_contact(make_truth_cube_body(cells, true));
  SolverSettings settings = silicone();
  settings.newton.tolerance = 1e-9;
  const auto solver = make_solver(body.levels, body.loading, settings);
  ASSERT_EQ(solver->solve_to(compression, {}).status, NewtonStatus::converged);
  const auto contacts = solver->plane_contacts();
  ASSERT_GT(contacts[0].force, 0);
  EXPECT_NEAR(contacts[1].force / contacts[0].force, 1, 1e-6);
  EXPECT_NEAR(contacts[1].depth / contacts[0].depth, 1, 1e-6);
  const Point ends{side, side, side * (1 - compression)};
  const auto x = solver->positions();
  const auto node = [](const std::array<Index, 3>& at) {
    return static_cast<std::size_t>(at[0] + (cells + 1) * (at[1] + (cells + 1) * at[2]));
  };
  std::array<double, 3> asymmetry{};
  for (Index k = 0; k <= cells; ++k) {
    for (Index j = 0; j <= cells; ++j) {
      for (Index i = 0; i <= cells; ++i) {
        const std::array<Index, 3> at{i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          std::array<Index, 3> opposite = at;
          opposite[axis] = cells - at[axis];
          Point image = x[node(opposite)];
          image[axis] = ends[axis] - image[axis];
          for (std::size_t c = 0; c < 3; ++c) {
            asymmetry[axis] = std::max(asymmetry[axis], std::abs(x[node(at)][c] - image[c]));
          }
        }
      }
    }
  }
  std::printf("asymmetric by %.2e, %.2e and %.2e mm\n", 1e3 * asymmetry[0], 1e3 * asymmetry[1], 1e3 * asymmetry[2]);
  for (const double largest : asymmetry) EXPECT_LE(largest, 1e-7 * side);
}

TEST(Contact, is_restarted_bit_for_bit) {
  const Body body = with_contact(make_truth_cube_body(8, true));
  const auto whole = make_solver(body.levels, body.loading, silicone());
  ASSERT_EQ(whole->solve_to(0.45, {}).status, NewtonStatus::converged);
  ASSERT_GT(whole->plane_contacts().at(0).force, 0);
  const SolverState kept = whole->state();
  ASSERT_EQ(whole->solve_to(0.5, {}).status, NewtonStatus::converged);
  const auto later = make_solver(body.levels, body.loading, silicone());
  later->restore(kept);
  ASSERT_EQ(later->solve_to(0.5, {}).status, NewtonStatus::converged);
  EXPECT_EQ(later->positions(), whole->positions());
  EXPECT_EQ(later->forces(), whole->forces());
  EXPECT_EQ(later->plane_contacts().at(1).force, whole->plane_contacts().at(1).force);
}

}  // namespace
}  // namespace physgen::fem
