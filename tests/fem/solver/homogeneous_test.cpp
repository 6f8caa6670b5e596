// Deformations that linear tets represent exactly, on irregular meshes: what comes out is known to the last digits.
#include <gtest/gtest.h>

#include "bodies.h"

namespace physgen::fem {
namespace {

Point affine(const Point& x) {
  return {0.9 * x[0] + 0.07 * x[1] - 0.02 * x[2], 0.05 * x[0] + 1.08 * x[1] + 0.06 * x[2],
          -0.04 * x[0] + 0.03 * x[1] + 0.94 * x[2]};
}

/// All of the boundary follows an affine map; so must the inside.
double patch_test_error(const std::string& material, Volume volume, TangentPrecision precision, double tolerance) {
  Body body = make_cube(
      4, side, volume == Volume::patches, 0.2,
      [](const Point& x) -> std::uint8_t {
        const bool outside = x[0] == 0 || x[1] == 0 || x[2] == 0 || x[0] == side || x[1] == side || x[2] == side;
        return outside ? 7 : 0;
      },
      [](const Point& x) {
        const Point y = affine(x);
        return Point{y[0] - x[0], y[1] - x[1], y[2] - x[2]};
      });
  body = with(volume, std::move(body));
  SolverSettings settings = exact_settings(material, 0.45);
  settings.precision = precision;
  settings.newton.tolerance = tolerance;
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  const auto solver = make_solver(body.levels, body.loading, settings);
  const NewtonResult result = solver->solve_to(1, {});
  EXPECT_EQ(result.status, NewtonStatus::converged);
  std::vector<Point> expected;
  for (const Point& x : body.levels[0].rest) expected.push_back(affine(x));
  return largest_distance(solver->positions(), expected) / side;
}

TEST(PatchTest, inside_of_an_irregular_mesh_follows_an_affine_boundary_in_every_material) {
  for (const std::string& material : material_names()) {
    EXPECT_LE(patch_test_error(material, Volume::tets, TangentPrecision::float64, 1e-13), 1e-12) << material;
  }
}

TEST(PatchTest, inside_follows_with_volumes_averaged_over_patches) {
  for (const std::string& material : material_names()) {
    if (!can_average_volume(material)) continue;
    EXPECT_LE(patch_test_error(material, Volume::patches, TangentPrecision::float64, 1e-13), 1e-12) << material;
  }
}

TEST(PatchTest, inside_follows_with_volumes_averaged_at_nodes) {
  for (const std::string& material : material_names()) {
    if (!can_average_volume(material)) continue;
    EXPECT_LE(patch_test_error(material, Volume::nodes, TangentPrecision::float64, 1e-13), 1e-12) << material;
  }
}

TEST(PatchTest, tangents_in_float_and_half_lead_to_the_same_state) {
  EXPECT_LE(patch_test_error("neo-hookean", Volume::patches, TangentPrecision::half, 1e-12), 1e-11);
  EXPECT_LE(patch_test_error("neo-hookean", Volume::nodes, TangentPrecision::half, 1e-12), 1e-11);
  EXPECT_LE(patch_test_error("neo-hookean", Volume::tets, TangentPrecision::float32, 1e-12), 1e-11);
}

// Uniaxial stretch with free sides and planes of symmetry on three faces: side stretch y and stress P1 over E, found by
// 40-digit arithmetic.
struct Uniaxial {
  const char* material;
  double poissons_ratio, stretch, side_stretch, stress;
};
const Uniaxial uniaxial_table[] = {
    {"neo-hookean", .45, .95, 1.023295, -.05249848},
    {"st-venant-kirchhoff", .45, .95, 1.021702, -.0463125},
    {"corotated", .45, .95, 1.0225, -.05},
    {"fixed-corotated", .45, .95, 1.023248, -.05175234},
    {"stable-neo-hookean", .45, .95, 1.023275, -.05248327},
    {"neo-hookean", .45, .875, 1.061537, -.1423589},
    {"st-venant-kirchhoff", .45, .875, 1.051413, -.1025391},
    {"corotated", .45, .875, 1.05625, -.125},
    {"fixed-corotated", .45, .875, 1.061189, -.1373853},
    {"stable-neo-hookean", .45, .875, 1.061381, -.1422288},
    {"neo-hookean", .45, .8175, 1.093977, -.2229165},
    {"st-venant-kirchhoff", .45, .8175, 1.072036, -.1355798},
    {"corotated", .45, .8175, 1.082125, -.1825},
    {"fixed-corotated", .45, .8175, 1.093122, -.2117364},
    {"stable-neo-hookean", .45, .8175, 1.093588, -.2225572},
    {"neo-hookean", .49, .8175, 1.103547, -.2255649},
    {"st-venant-kirchhoff", .49, .8175, 1.078207, -.1355798},
    {"corotated", .49, .8175, 1.089425, -.1825},
    {"fixed-corotated", .49, .8175, 1.103412, -.2161604},
    {"stable-neo-hookean", .49, .8175, 1.103531, -.2255501},
};

/// y and P1 / E from the equations of the table, to rounding: P2 = 0 by bisection.
std::array<double, 2> solved(const Uniaxial& row) {
  const double nu = row.poissons_ratio, mu = 1 / (2 * (1 + nu)), lambda = nu / ((1 + nu) * (1 - 2 * nu)),
               l = row.stretch;
  const std::string name = row.material;
  const auto stresses = [&](double y) -> std::array<double, 2> {  // P2, P1
    const double J = l * y * y;
    if (name == "neo-hookean") {
      return {mu * (y * y - 1) + lambda * std::log(J), mu * l - (mu - lambda * std::log(J)) / l};
    }
    if (name == "st-venant-kirchhoff") {
      const double I = l * l + 2 * y * y - 3;
      return {y * (mu * (y * y - 1) + lambda / 2 * I), l * (mu * (l * l - 1) + lambda / 2 * I)};
    }
    if (name == "corotated") {
      const double T = l + 2 * y - 3;
      return {2 * mu * (y - 1) + lambda * T, 2 * mu * (l - 1) + lambda * T};
    }
    if (name == "fixed-corotated") {
      return {2 * mu * (y - 1) + lambda * (J - 1) * l * y, 2 * mu * (l - 1) + lambda * (J - 1) * y * y};
    }
    const double a = 1 + mu / (lambda + mu);
    return {mu * y + (lambda + mu) * (J - a) * l * y, mu * l + (lambda + mu) * (J - a) * y * y};
  };
  double low = 0.9, high = 1.3;
  for (int k = 0; k < 200; ++k) (stresses((low + high) / 2)[0] < 0 ? low : high) = (low + high) / 2;
  return {low, stresses(low)[1]};
}

void expect_uniaxial(const Uniaxial& row, Volume volume) {
  const auto [y, stress] = solved(row);
  EXPECT_NEAR(y, row.side_stretch, 1e-6);  // the equations are those of the table
  EXPECT_NEAR(stress, row.stress, 1e-7);
  Body body = make_cube(
      3, side, volume == Volume::patches, 0.2,
      [](const Point& x) {
        return static_cast<std::uint8_t>((x[0] == 0 ? 1 : 0) | (x[1] == 0 ? 2 : 0) |
                                         (x[2] == 0 || x[2] == side ? 4 : 0));
      },
      [&](const Point& x) { return Point{0, 0, (row.stretch - 1) * x[2]}; });
  body = with(volume, std::move(body));
  SolverSettings settings = exact_settings(row.material, row.poissons_ratio);
  settings.newton.tolerance = 1e-12;
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  const auto solver = make_solver(body.levels, body.loading, settings);
  ASSERT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged) << row.material;
  std::vector<Point> expected;
  for (const Point& x : body.levels[0].rest) expected.push_back({y * x[0], y * x[1], row.stretch * x[2]});
  EXPECT_LE(largest_distance(solver->positions(), expected), 1e-9 * side) << row.material << " " << row.stretch;
  double force = 0;
  const auto forces = solver->forces();
  for (std::size_t n = 0; n < forces.size(); ++n) {
    if (body.levels[0].rest[n][2] == side) force -= forces[n][2];
  }
  EXPECT_NEAR(force / (side * side), stress, 1e-9 * std::abs(stress)) << row.material << " " << row.stretch;
  for (const auto& P : solver->stresses()) EXPECT_NEAR(P[8], stress, 1e-9);
}

TEST(Uniaxial, stretch_and_stress_are_those_of_the_table_on_irregular_meshes) {
  for (const Uniaxial& row : uniaxial_table) expect_uniaxial(row, Volume::tets);
}

TEST(Uniaxial, stretch_and_stress_are_those_of_the_table_with_patches) {
  for (const Uniaxial& row : uniaxial_table) {
    if (can_average_volume(row.material)) expect_uniaxial(row, Volume::patches);
  }
}

TEST(Uniaxial, stretch_and_stress_are_those_of_the_table_with_volumes_averaged_at_nodes) {
  for (const Uniaxial& row : uniaxial_table) {
    if (can_average_volume(row.material)) expect_uniaxial(row, Volume::nodes);
  }
}

TEST(Homogeneous, momentum_is_kept_by_the_forces_of_any_state) {
  const Body body = make_truth_cube_body(4, true);
  SolverSettings settings = exact_settings("neo-hookean", 0.49);
  settings.newton.tolerance = 1e-8;
  const auto solver = make_solver(body.levels, body.loading, settings);
  ASSERT_EQ(solver->solve_to(0.1, {}).status, NewtonStatus::converged);
  Point force{}, torque{};
  double largest = 0;
  const auto forces = solver->forces(), positions = solver->positions();
  for (std::size_t n = 0; n < forces.size(); ++n) {
    const Point &f = forces[n], &x = positions[n];
    const Point t{x[1] * f[2] - x[2] * f[1], x[2] * f[0] - x[0] * f[2], x[0] * f[1] - x[1] * f[0]};
    for (std::size_t k = 0; k < 3; ++k)
      force[k] += f[k], torque[k] += t[k], largest = std::max(largest, std::abs(f[k]));
  }
  ASSERT_GT(largest, 0);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LE(std::abs(force[k]), 1e-12 * largest * double(forces.size()));
    EXPECT_LE(std::abs(torque[k]), 1e-12 * side * largest * double(forces.size()));
  }
}

TEST(Homogeneous, scale_by_a_power_of_two_changes_no_bit) {
  std::vector<std::vector<Point>> found;
  for (const double scale : {1.0, 1024.0, 1.0 / 4096}) {
    const double own = 0.0625 * scale;
    const Body body = make_cube(
        4, own, true, 0, [=](const Point& x) -> std::uint8_t { return x[2] == 0 || x[2] == own ? 7 : 0; },
        [=](const Point& x) { return x[2] == own ? Point{0, 0, -own} : Point{}; });
    SolverSettings settings = exact_settings("neo-hookean", 0.45);
    settings.precision = TangentPrecision::half;
    settings.newton.tolerance = 1e-6;
    const auto solver = make_solver(body.levels, body.loading, settings);
    ASSERT_EQ(solver->solve_to(0.125, {}).status, NewtonStatus::converged);
    auto positions = solver->positions();
    for (Point& x : positions) {
      for (double& number : x) number /= scale;
    }
    found.push_back(std::move(positions));
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
}

TEST(Homogeneous, millimetres_and_kilometres_give_what_metres_give) {
  std::vector<std::vector<Point>> found;
  for (const double scale : {1.0, 1e3, 1e-3}) {
    const double own = side * scale;
    const Body body = make_cube(
        4, own, true, 0, [=](const Point& x) -> std::uint8_t { return x[2] == 0 || x[2] == own ? 7 : 0; },
        [=](const Point& x) { return x[2] == own ? Point{0, 0, -own} : Point{}; });
    SolverSettings settings = exact_settings("neo-hookean", 0.45);
    settings.newton.tolerance = 1e-10;
    const auto solver = make_solver(body.levels, body.loading, settings);
    ASSERT_EQ(solver->solve_to(0.125, {}).status, NewtonStatus::converged);
    auto positions = solver->positions();
    for (Point& x : positions) {
      for (double& number : x) number /= scale;
    }
    found.push_back(std::move(positions));
  }
  EXPECT_LE(largest_distance(found[0], found[1]), 1e-9 * side);
  EXPECT_LE(largest_distance(found[0], found[2]), 1e-9 * side);
}

}  // namespace
}  // namespace physgen::fem
