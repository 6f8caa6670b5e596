// Contact with rigid planes of any direction: energy, forces and tangent of bodies that lie partly behind them, and
// bodies that planes hold, whose depth behind them is known.
#include <fem/mesh/boundary.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <Eigen/Geometry>
#include <cstdio>

#include "../bodies.h"
#include "../irregular.h"

namespace physgen::fem {
namespace {

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point unit(const Point& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

/// Three planes that cut corners, edges and the free side off a cube with a bonded base.
Body cut_cube(bool patches) {
  Body body = make_cube(
      8, side, patches, 0, [](const Point& x) -> std::uint8_t { return x[2] == 0 ? 7 : 0; },
      [](const Point&) { return Point{}; });
  for (const Point& normal : {unit({-1, -2, -3}), unit({1, 0, -1}), unit({0, 1, -4})}) {
    const Point middle{0.04, 0.05, 0.068};
    body.loading.planes.push_back({normal, dot(normal, middle) - 0.01, 0.02});
  }
  return body;
}

/// The solver's message on positions.
struct State {
  double energy = 0;
  std::vector<Point> forces;
  std::vector<PlaneContact> contacts;
};
State evaluate(QuasistaticSolver& solver, SolverState state, const std::vector<Point>& positions) {
  state.positions[0] = positions;
  state.is_equilibrium = true;  // so that none is solved for
  solver.restore(state);
  return {solver.solve_to(state.load, {}).energy, solver.forces(), solver.plane_contacts()};
}

std::vector<Point> random_vectors(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Point> vectors(count);
  for (Point& v : vectors) v = {number(random), number(random), number(random)};
  return vectors;
}

std::vector<Point> moved(const std::vector<Point>& at, const std::vector<Point>& way, double length) {
  std::vector<Point> result = at;
  for (std::size_t n = 0; n < at.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) result[n][k] += length * way[n][k];
  }
  return result;
}

TEST(RigidPlanes, forces_are_minus_the_gradient_of_the_energy) {
  const Body body = cut_cube(true);
  SolverSettings settings = exact_settings("neo-hookean", 0.45);
  settings.nested = false;
  const auto solver = make_solver(body.levels, body.loading, settings);
  SolverState state = solver->state();
  state.load = 0.5;
  const auto at = moved(state.positions[0], random_vectors(body.levels[0].rest.size(), 3), 1e-4);
  const State here = evaluate(*solver, state, at);
  for (const PlaneContact& contact : here.contacts) EXPECT_GT(contact.depth, 0.1 * side);
  for (std::uint64_t seed = 5; seed < 10; ++seed) {
    const auto way = random_vectors(at.size(), seed);
    const double length = 1e-8;
    const double up = evaluate(*solver, state, moved(at, way, length)).energy,
                 down = evaluate(*solver, state, moved(at, way, -length)).energy;
    double power = 0, size = 0;
    for (std::size_t n = 0; n < at.size(); ++n) {
      power += dot(here.forces[n], way[n]);
      size += std::abs(dot(here.forces[n], way[n]));
    }
    EXPECT_NEAR((up - down) / (2 * length), -power, 1e-6 * size);
  }
}

TEST(RigidPlanes, tangent_is_the_derivative_of_the_forces_with_every_preconditioner) {
  const Body body = cut_cube(true);
  for (const Preconditioner kind : {Preconditioner::multigrid, Preconditioner::block_jacobi}) {
    SolverSettings settings = exact_settings("neo-hookean", 0.45);
    settings.nested = false;
    settings.newton.preconditioner.kind = kind;
    const auto solver = make_solver(body.levels, body.loading, settings);
    SolverState state = solver->state();
    state.load = 0.5;
    const auto at = state.positions[0];
    (void)evaluate(*solver, state, at);
    const auto right = random_vectors(at.size(), 17);
    std::vector<Point> step;
    ASSERT_EQ(solver->solve_linear(right, 1e-12, &step).status, LinearStatus::converged);
    double largest = 0;
    for (const Point& x : step) largest = std::max(largest, std::sqrt(dot(x, x)));
    const double length = 1e-8 / largest;
    const auto up = evaluate(*solver, state, moved(at, step, length)).forces,
               down = evaluate(*solver, state, moved(at, step, -length)).forces;
    for (std::size_t n = 0; n < at.size(); ++n) {
      if (body.levels[0].fixed[n] != 0) continue;
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR((up[n][k] - down[n][k]) / (2 * length), -right[n][k], 1e-4);
    }
  }
}

/// Coarser levels have the planes' stiffness exactly: without it, iterations would grow with it.
TEST(RigidPlanes, hardly_cost_multigrid_an_iteration_however_stiff_they_are) {
  Body body = cut_cube(true);
  const auto iterations = [&](double stiffness) {
    Body with = body;
    if (stiffness == 0) with.loading.planes.clear();
    SolverSettings settings;
    settings.nested = false;
    settings.plane_stiffness = stiffness == 0 ? 1 : stiffness;
    const auto solver = make_solver(with.levels, with.loading, settings);
    SolverState state = solver->state();
    state.load = 0.5;
    solver->restore(state);
    const LinearResult result = solver->solve_linear(random_vectors(state.positions[0].size(), 29), 1e-6, nullptr);
    EXPECT_EQ(result.status, LinearStatus::converged);
    return result.iterations;
  };
  const int without = iterations(0);
  for (const double stiffness : {1.0, 10.0, 100.0, 1e3, 1e4}) {
    const int with = iterations(stiffness);
    std::printf("stiffness %g: %d iterations, %d without planes\n", stiffness, with, without);
    EXPECT_LE(with, without + 5) << stiffness;
  }
}

std::vector<Face> faces_where(const MeshLevel& level, const std::function<bool(const Point&)>& on) {
  std::vector<Face> faces = boundary_faces(level.mesh);
  std::erase_if(faces, [&](const Face& face) {
    return !std::ranges::all_of(face, [&](Index n) { return on(level.rest[static_cast<std::size_t>(n)]); });
  });
  return faces;
}

TEST(RigidPlanes, a_block_pressed_into_an_inclined_corner_sinks_by_pressure_over_stiffness_into_each) {
  const Eigen::Matrix3d R = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const std::array<double, 3> pressures{0.03, 0.06, 0.2};
  constexpr double stiffness = 20;
  Tets tets = irregular_box({4, 4, 4}, {side, side, side}, 0.2, 31);
  auto levels = make_levels(tets, 0, true, [](const Point&) -> std::uint8_t { return 0; });
  MeshLevel& level = levels[0];
  Loading loading;
  loading.motion.assign(level.rest.size(), Point{});
  std::vector<std::vector<Face>> faces;
  for (std::size_t k = 0; k < 3; ++k) faces.push_back(faces_where(level, [=](const Point& x) { return x[k] == side; }));
  for (Point& x : level.rest) Eigen::Vector3d::Map(x.data()) = R * Eigen::Vector3d::Map(x.data());
  loading.forces.assign(level.rest.size(), Point{});
  for (int k = 0; k < 3; ++k) {
    const auto pressed = pressure_loads(level.rest, faces[std::size_t(k)], pressures[std::size_t(k)]);
    loading.forces = moved(loading.forces, pressed, 1);
    const Eigen::Vector3d n = R.col(k);
    loading.planes.push_back({{n[0], n[1], n[2]}, 1e-9 * side, 0});
  }
  SolverSettings settings = exact_settings("neo-hookean", 0.45);
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  settings.plane_stiffness = stiffness;
  const auto solver = make_solver(levels, loading, settings);
  const NewtonResult result = solver->solve_to(1, {});
  ASSERT_EQ(result.status, NewtonStatus::converged);
  EXPECT_LE(result.steps, 12);
  const auto contacts = solver->plane_contacts();
  ASSERT_EQ(contacts.size(), 3U);
  // Forces are dead loads and keep their directions: what the pressed faces get is what the planes get.
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(contacts[k].force, pressures[k] * side * side, 1e-9 * side * side);
    const double depth = pressures[k] * (side / 4) / stiffness;  // E is 1, and 4 cells' spacing is that of neighbours
    EXPECT_NEAR(contacts[k].depth, depth, 0.02 * depth) << k;    // nodes of edges have shares of two faces
  }
  std::printf("%d Newton steps\n", result.steps);
}

/// A block that hardly deforms sinks as a whole: by the force over the stiffness of all nodes that touch.
TEST(RigidPlanes, a_stiff_block_sinks_by_the_force_over_the_stiffness_of_what_touches) {
  Body body = make_cube(
      4, side, false, 0.2, [](const Point& x) -> std::uint8_t { return std::uint8_t(x[0] == 0 && x[1] == 0 ? 3 : 0); },
      [](const Point&) { return Point{}; });
  const MeshLevel& level = body.levels[0];
  const auto on_top = faces_where(level, [](const Point& x) { return x[2] == side; });
  constexpr double pressure = 1e-6, stiffness = 1e-4;
  body.loading.forces = pressure_loads(level.rest, on_top, pressure);
  body.loading.planes = {{{0, 0, 1}, 0, 0}};
  SolverSettings settings = exact_settings("neo-hookean", 0.3);
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  settings.newton.tolerance = 1e-9;
  settings.plane_stiffness = stiffness;
  const auto solver = make_solver(body.levels, body.loading, settings);
  ASSERT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
  const auto areas = surface_areas(level.rest, boundary_faces(level.mesh));
  double touching = 0;
  for (std::size_t n = 0; n < areas.size(); ++n) touching += level.rest[n][2] == 0 ? areas[n] : 0.0;
  EXPECT_GT(touching, side * side);
  const double depth = pressure * side * side / (stiffness / (side / 4) * touching);
  const PlaneContact contact = solver->plane_contacts().at(0);
  EXPECT_NEAR(contact.force, pressure * side * side, 1e-8 * pressure * side * side);
  EXPECT_NEAR(contact.depth, depth, 5e-3 * depth);
}

TEST(RigidPlanes, carry_the_weight_of_a_block_that_rests_on_one) {
  constexpr double density = 1000;
  Body body = make_cube(
      8, side, true, 0,
      [](const Point& x) -> std::uint8_t { return std::uint8_t((x[0] == 0 ? 1 : 0) | (x[1] == 0 ? 2 : 0)); },
      [](const Point&) { return Point{}; });
  const MeshLevel& level = body.levels[0];
  body.loading.forces = gravity_loads(level.mesh, level.rest, density, {0, 0, -2e-3});
  body.loading.planes = {{{0, 0, 1}, 0, 0}};
  const auto solver = make_solver(body.levels, body.loading, exact_settings("neo-hookean", 0.45));
  for (const double load : {0.5, 1.0}) {
    ASSERT_EQ(solver->solve_to(load, {}).status, NewtonStatus::converged);
    const PlaneContact contact = solver->plane_contacts().at(0);
    EXPECT_NEAR(contact.force, load * density * 2e-3 * side * side * side, 1e-10);
    EXPECT_GT(contact.depth, 0);
    EXPECT_LT(contact.depth, 0.01 * side / 8);  // a pressure of up to 1/6 of E
  }
}

TEST(RigidPlanes, one_that_moves_presses_as_a_prescribed_face_without_friction_does_and_lets_go) {
  const Body prescribed = make_truth_cube_body(8, true, true);
  Body pressed = prescribed;
  for (MeshLevel& level : pressed.levels) {
    for (std::size_t n = 0; n < level.rest.size(); ++n) level.fixed[n] = level.rest[n][2] == 0 ? 7 : 0;
  }
  pressed.loading.motion.assign(pressed.levels[0].rest.size(), Point{});
  pressed.loading.planes = {{{0, 0, -1}, -side, side}};
  for (const double stiffness : {100.0, 1e4}) {
    for (const bool nested : {true, false}) {
      SCOPED_TRACE(stiffness);
      SolverSettings settings = exact_settings("neo-hookean", 0.45);
      settings.newton.tolerance = 1e-9;
      settings.nested = nested;
      settings.coarsest_nested = 1;
      settings.plane_stiffness = stiffness;
      const auto expected = make_solver(prescribed.levels, prescribed.loading, settings);
      const auto solver = make_solver(pressed.levels, pressed.loading, settings);
      const NewtonResult other = expected->solve_to(0.1, {}), result = solver->solve_to(0.1, {});
      ASSERT_EQ(other.status, NewtonStatus::converged);
      ASSERT_EQ(result.status, NewtonStatus::converged) << nested;
      EXPECT_EQ(result.bisections, 0);
      if (stiffness == 100) {
        EXPECT_LE(result.steps, other.steps + 2) << nested;
        EXPECT_EQ(result.halvings, 0) << nested;
      }
      const PlaneContact contact = solver->plane_contacts().at(0);
      EXPECT_NEAR(contact.depth, 0.1 * side / 8 / stiffness, 0.05 * side / 8 / stiffness);  // about E/10
      EXPECT_LE(largest_distance(expected->positions(), solver->positions()), 3 * contact.depth);
      double reaction = 0;
      const auto forces = expected->forces();
      for (std::size_t n = 0; n < forces.size(); ++n) {
        if (prescribed.levels[0].rest[n][2] == side) reaction += forces[n][2];
      }
      const double error = std::abs(contact.force / reaction - 1);
      EXPECT_LE(error, 0.2 / stiffness);

      ASSERT_EQ(solver->solve_to(-0.05, {}).status, NewtonStatus::converged) << nested;
      EXPECT_EQ(solver->plane_contacts().at(0).depth, 0);
      EXPECT_LE(largest_distance(solver->positions(), pressed.levels[0].rest), 1e-8 * side) << nested;
    }
  }
}

TEST(RigidPlanes, that_are_not_planes_are_refused) {
  const Body body = make_truth_cube_body(2, false);
  const auto message = [&](const RigidPlane& plane, double stiffness) {
    Loading loading = body.loading;
    loading.planes = {{{0, 0, 1}, 0, 0}, plane};
    SolverSettings settings;
    settings.plane_stiffness = stiffness;
    try {
      (void)make_solver(body.levels, loading, settings);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const auto expect = [](const std::string& text, std::initializer_list<const char*> words) {
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
  };
  expect(message({{0, 0, 2}, 0, 0}, 100), {"plane 1", "normal", "2", "must have 1"});
  expect(message({{NAN, 0, 0}, 0, 0}, 100), {"plane 1", "normal"});
  expect(message({{1, 0, 0}, INFINITY, 0}, 100), {"plane 1", "offset", "finite"});
  expect(message({{1, 0, 0}, 0, 0}, 0), {"stiffness of rigid planes", "0", "positive"});
}

}  // namespace
}  // namespace physgen::fem
