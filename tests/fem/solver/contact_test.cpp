// The Truth Cube between plates that its free sides touch: how far they still fold past, and that nothing else changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "bodies.h"

namespace physgen::fem {
namespace {

constexpr double side = 0.08;

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
      for (const double compression : {0.1825, cells == 8 ? 0.4 : 0.3}) {
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
        EXPECT_LE(beads, compression < 0.2 ? 5e-5 : 0.3 * reach(a, compression));
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
    for (const double compression : {0.125, 0.3}) {
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

/// The mesh is the same after a reflection in its middle; after one in its mid-plane it is not, but at the beads
/// almost.
TEST(Contact, of_bonded_plates_is_symmetric) {
  constexpr Index cells = 16;
  constexpr double compression = 0.3;
  const Body body = make_truth_cube_body(cells, true), plates = with_contact(body);
  SolverSettings settings = silicone();
  settings.newton.tolerance = 1e-9;
  const auto solver = make_solver(plates.levels, plates.loading, settings);
  const auto without = make_solver(body.levels, body.loading, settings);
  ASSERT_EQ(solver->solve_to(compression, {}).status, NewtonStatus::converged);
  ASSERT_EQ(without->solve_to(compression, {}).status, NewtonStatus::converged);
  const auto contacts = solver->plane_contacts();
  ASSERT_GT(contacts[0].force, 0);
  EXPECT_NEAR(contacts[1].force / contacts[0].force, 1, 1e-6);
  EXPECT_NEAR(contacts[1].depth / contacts[0].depth, 1, 1e-6);
  const Point ends{side, side, side * (1 - compression)};
  const auto x = solver->positions();
  double in_middle = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      in_middle = std::max(in_middle, std::abs(x[n][k] + x[x.size() - 1 - n][k] - ends[k]));
    }
  }
  const auto at_beads = [&](const std::vector<Point>& positions) {
    double largest = 0;
    const auto node = [](int i, int j, int k) {
      return std::size_t(2 * i + (cells + 1) * (2 * j + (cells + 1) * 2 * k));
    };
    for (int i = 1; i < 8; ++i) {
      for (int j = 1; j < 8; ++j) {
        for (int k = 1; k < 8; ++k) {
          const Point &a = positions[node(i, j, k)], &b = positions[node(i, j, 8 - k)];
          largest = std::max(largest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] + b[2] - ends[2]));
        }
      }
    }
    return largest;
  };
  const double with = at_beads(x), none = at_beads(without->positions());
  std::printf(
      "asymmetric by %.2e mm in the middle; in the mid-plane, at beads, by %.3f mm, without contact by %.3f mm\n",
      1e3 * in_middle, 1e3 * with, 1e3 * none);
  EXPECT_LE(in_middle, 1e-7 * side);
  EXPECT_LE(with, 1.1 * none);
}

TEST(Contact, is_restarted_bit_for_bit) {
  const Body body = with_contact(make_truth_cube_body(8, true));
  const auto whole = make_solver(body.levels, body.loading, silicone());
  ASSERT_EQ(whole->solve_to(0.4, {}).status, NewtonStatus::converged);
  ASSERT_GT(whole->plane_contacts().at(0).force, 0);
  const SolverState kept = whole->state();
  ASSERT_EQ(whole->solve_to(0.45, {}).status, NewtonStatus::converged);
  const auto later = make_solver(body.levels, body.loading, silicone());
  later->restore(kept);
  ASSERT_EQ(later->solve_to(0.45, {}).status, NewtonStatus::converged);
  EXPECT_EQ(later->positions(), whole->positions());
  EXPECT_EQ(later->forces(), whole->forces());
  EXPECT_EQ(later->plane_contacts().at(1).force, whole->plane_contacts().at(1).force);
}

}  // namespace
}  // namespace physgen::fem
