// A body that is turned and carried away is the same body: its shape, energy and forces turn with it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdio>
#include <numbers>

#include "bodies.h"
#include "irregular.h"

namespace physgen::fem {
namespace {

const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(40 * std::numbers::pi / 180, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
const Eigen::Vector3d translation = side * Eigen::Vector3d(0.5, -0.25, 1);

Point turned(const Point& x) {
  const Eigen::Vector3d y = rotation * Eigen::Vector3d(x[0], x[1], x[2]);
  return {y[0], y[1], y[2]};
}

Point carried(const Point& x) {
  const Point y = turned(x);
  return {y[0] + translation[0], y[1] + translation[1], y[2] + translation[2]};
}

std::vector<MeshLevel> bonded_cube(Volume volume) {
  static const Tets box = irregular_box({4, 4, 4}, {side, side, side}, 0.2, 17);
  return with(volume, make_levels(box, 0, volume == Volume::patches,
                                  [](const Point& x) -> std::uint8_t { return x[2] == 0 || x[2] == side ? 7 : 0; }));
}

SolverSettings own_settings(const std::string& material) {
  SolverSettings settings = exact_settings(material, 0.45);
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  settings.nested = false;
  return settings;
}

/// The top pressed down by a tenth and sheared, then both plates turned and carried, or not.
void expect_turned_equilibrium(const std::string& material, Volume volume) {
  const auto levels = bonded_cube(volume);
  const auto pressed = [](const Point& x) { return x[2] == side ? Point{x[0] + 0.05 * side, x[1], 0.9 * x[2]} : x; };
  Loading still, moved;
  for (const Point& x : levels[0].rest) {
    const Point a = pressed(x), b = carried(pressed(x));
    still.motion.push_back({a[0] - x[0], a[1] - x[1], a[2] - x[2]});
    moved.motion.push_back({b[0] - x[0], b[1] - x[1], b[2] - x[2]});
  }
  const auto first = make_solver(levels, still, own_settings(material));
  const auto second = make_solver(levels, moved, own_settings(material));
  const NewtonResult one = first->solve_to(1, {}), other = second->solve_to(1, {});
  ASSERT_EQ(one.status, NewtonStatus::converged) << material;
  ASSERT_EQ(other.status, NewtonStatus::converged) << material;
  std::printf("%s, %s: %d Newton steps, and turned %d with %d bisections\n", material.c_str(), name_of(volume),
              one.steps, other.steps, other.bisections);
  EXPECT_GT(one.energy, 0);
  EXPECT_NEAR(other.energy, one.energy, 1e-10 * one.energy) << material;
  EXPECT_NEAR(other.reaction, one.reaction, 1e-9 * one.reaction) << material;
  EXPECT_NEAR(other.smallest_J, one.smallest_J, 1e-9) << material;
  EXPECT_LE(largest_distance(second->positions(), at_nodes(first->positions(), carried)), 1e-9 * side) << material;
  EXPECT_LE(largest_distance(second->forces(), at_nodes(first->forces(), turned)), 1e-9 * one.reaction) << material;
}

TEST(RigidMotion, of_both_plates_turns_the_compressed_cube_and_keeps_its_energy) {
  for (const std::string material : {"neo-hookean", "fixed-corotated"}) {
    for (const Volume volume : volumes) expect_turned_equilibrium(material, volume);
  }
}

double largest_force(QuasistaticSolver& solver, const std::vector<Point>& positions) {
  solver.set_positions(positions);
  double largest = 0;
  for (const Point& f : solver.forces()) largest = std::max(largest, std::hypot(f[0], f[1], f[2]));
  return largest;
}

TEST(RigidMotion, gives_no_force_in_any_material) {
  constexpr double eps = 0x1p-52, mu = 1 / (2 * 1.45);
  for (const std::string& material : material_names()) {
    for (const Volume volume : volumes) {
      if (volume != Volume::tets && !can_average_volume(material)) continue;
      auto levels = bonded_cube(volume);
      for (Point& x : levels[0].rest) {
        for (double& number : x) number = std::round(number * 0x1p20) * 0x1p-20;
      }
      const auto& rest = levels[0].rest;
      Loading loading;
      loading.motion.assign(rest.size(), Point{});
      const auto solver = make_solver(levels, loading, own_settings(material));
      // A third of a turn around the diagonal, and a translation, in which no position is rounded.
      const double exact = largest_force(
          *solver, at_nodes(rest, [](const Point& x) { return Point{x[1] + 0.25, x[2] - 0.125, x[0] + 0.5}; }));
      // 40 degrees: positions are rounded by eps / 2 of where they lie, which the stiffness turns into forces.
      const double rounded = largest_force(*solver, at_nodes(rest, carried));
      const double unit = eps * mu * side * side;
      std::printf("%s, %s: forces up to %.2f eps mu area of the cube's face, and %.2f where positions are rounded\n",
                  material.c_str(), name_of(volume), exact / unit, rounded / unit);
      EXPECT_LE(exact, 4 * unit) << material << " " << name_of(volume);
      EXPECT_LE(rounded, 32 * unit) << material << " " << name_of(volume);
      // A stretch that is hardly more than rounding shows, so forces are not just 0.
      const double stretched = largest_force(
          *solver, at_nodes(rest, [](const Point& x) { return carried({x[0], x[1], (1 + 1e-12) * x[2]}); }));
      EXPECT_GE(stretched, 32 * unit) << material << " " << name_of(volume);
    }
  }
}

}  // namespace
}  // namespace physgen::fem
