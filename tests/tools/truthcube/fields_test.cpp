// The fields that are drawn of a state, on a tet whose stress is known.
#include <gtest/gtest.h>
#include <truthcube/fields.h>

#include <cmath>

namespace physgen::truthcube {
namespace {

using fem::Point;

const std::vector<Point> rest{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<Point> compressed{{0, 0, 0}, {1.25, 0, 0}, {0, 1, 0}, {0, 0, 0.5}};  // F = diag(1.25, 1, 0.5)
const std::vector<std::array<double, 9>> stresses{{1, 2, 3, 2, 4, 5, 3, 5, 6}};        // symmetric

TEST(Fields, of_finite_strain_have_the_cauchy_stress_of_the_first_piola_kirchhoff_stress) {
  const Fields fields = make_fields(fem::make_tet_mesh(4, {{0, 1, 2, 3}}), rest, compressed, stresses, Strain::finite);
  constexpr double J = 0.625;
  EXPECT_EQ(fields.volume_ratio, std::vector{J});
  EXPECT_EQ(fields.stress, (std::vector{1 * 1.25 / J, 4 / J, 6 * 0.5 / J, 2 / J, 5 * 0.5 / J, 3 * 0.5 / J}));
  for (const double pressure : fields.pressure) EXPECT_NEAR(pressure, -(1.25 + 4 + 3) / J / 3, 1e-14);
}

TEST(Fields, of_small_strain_have_the_stress_as_it_is) {
  const Fields fields = make_fields(fem::make_tet_mesh(4, {{0, 1, 2, 3}}), rest, compressed, stresses, Strain::small);
  EXPECT_EQ(fields.volume_ratio, std::vector{0.625});
  EXPECT_EQ(fields.stress, (std::vector<double>{1, 4, 6, 2, 5, 3}));
  for (const double pressure : fields.pressure) EXPECT_NEAR(pressure, -11.0 / 3, 1e-14);
  const double deviator = (1 - 4) * (1 - 4) + (4 - 6) * (4 - 6) + (6 - 1) * (6 - 1) + 6 * (2 * 2 + 5 * 5 + 3 * 3);
  EXPECT_NEAR(fields.von_mises.at(0), std::sqrt(deviator / 2), 1e-13);
}

/// Else equal forces on a body would have averages that depend on how far it has moved.
TEST(Fields, of_small_strain_are_averaged_by_volumes_at_rest) {
  const std::vector<Point> two{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  auto moved = two;
  moved[4][2] = -3;
  const fem::TetMesh mesh = fem::make_tet_mesh(5, {{0, 1, 2, 3}, {0, 2, 1, 4}});
  const std::vector<std::array<double, 9>> pressures{{-3, 0, 0, 0, -3, 0, 0, 0, -3}, {-5, 0, 0, 0, -5, 0, 0, 0, -5}};
  EXPECT_NEAR(make_fields(mesh, two, moved, pressures, Strain::small).pressure[0], 4, 1e-14);
}

}  // namespace
}  // namespace physgen::truthcube
