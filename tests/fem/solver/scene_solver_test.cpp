// The solver on the arrays of the scene quasistatic, which have the fields alone that its program needs, against the
// solver that is shipped, whose arrays have all.
#include <gtest/gtest.h>
#include <physgen/executor.h>
#include <quasistatic.scene.h>
#include <scenes/quasistatic.h>

#include <cstring>

#include "scene_groups.h"

namespace physgen::fem {
namespace {

namespace scene = scenes::quasistatic_scene;

/// With room for stresses, which have no values yet.
struct Groups : SceneGroups<scene::Body<>, scene::Patches<>, scene::Chunk<>, scene::Level<>, scene::Krylov<>> {
  scene::Stresses<> stresses;

  Groups(const Body& given, const SolverSettings& settings) : SceneGroups(given, settings) {
    stresses.allocate({.tet = body.tets.size()});
    start_without_values(stresses.of_tets.untyped(), {"P"});
  }
};

/// A cube that is pressed to four fifths of its height between plates that it is bonded to.
SolverSettings settings_of_the_scene() {
  SolverSettings settings;
  settings.material = "stable-neo-hookean";
  settings.youngs_modulus = 1e4;
  settings.poissons_ratio = 0.49;
  settings.precision = TangentPrecision::float32;
  settings.nested = false;
  return settings;
}
Body pressed_cube() {
  Body body = make_truth_cube_body(8, true);
  for (Point& motion : body.loading.motion) motion[2] *= 0.2;
  return body;
}

TEST(SceneQuasistatic, has_the_bits_of_the_solver_with_all_arrays) {
  const Body body = pressed_cube();
  const SolverSettings settings = settings_of_the_scene();
  const auto full = make_solver(body.levels, body.loading, settings);
  const NewtonResult expected = full->solve_to(1, {});
  ASSERT_EQ(expected.status, NewtonStatus::converged);
  ASSERT_GT(expected.iterations, 4);

  Groups groups(body, settings);
  ASSERT_GE(groups.levels.size(), 2U) << "else there is no V-cycle";
  HostExecutor on;
  scenes::quasistatic::program(
      on, groups.body, groups.patches, groups.chunk, groups.levels, groups.krylov, groups.stresses,
      StableNeoHookean<double>::from(settings.youngs_modulus, settings.poissons_ratio), settings, groups.facts);

  const auto positions = full->positions(), forces = full->forces();
  const auto stresses = full->stresses();
  double moved = 0;
  for (std::size_t n = 0; n < positions.size(); ++n) {
    const auto i = static_cast<index_t>(n);
    for (int k = 0; k < 3; ++k) {
      const double x = groups.body.positions.view()[i].x()[k], f = groups.body.forces.view()[i].f()[k];
      EXPECT_EQ(std::memcmp(&x, &positions[n][std::size_t(k)], sizeof x), 0) << n;
      EXPECT_EQ(std::memcmp(&f, &forces[n][std::size_t(k)], sizeof f), 0) << n;
      moved = std::max(moved, std::abs(x - body.levels.front().rest[n][std::size_t(k)]));
    }
  }
  EXPECT_GT(moved, 0.01);
  ASSERT_EQ(groups.stresses.of_tets.size(), static_cast<index_t>(stresses.size()));
  for (std::size_t t = 0; t < stresses.size(); ++t) {
    const Eigen::Matrix3d P = groups.stresses.of_tets.view()[static_cast<index_t>(t)].P();
    EXPECT_EQ(std::memcmp(P.data(), stresses[t].data(), sizeof stresses[t]), 0) << t;
  }
}

TEST(SceneQuasistatic, holds_no_more_bytes_than_the_solver_with_all_arrays) {
  const Body body = pressed_cube();
  const SolverSettings settings = settings_of_the_scene();
  const Groups groups(body, settings);
  index_t bytes = groups.body.bytes() + groups.patches.bytes() + groups.chunk.bytes() + groups.krylov.bytes();
  for (const auto& level : groups.levels) bytes += level.bytes();
  for (const EdgeSums& sums : groups.facts.sums) bytes += sums.bytes();
  EXPECT_EQ(bytes, make_solver(body.levels, body.loading, settings)->bytes());
}

}  // namespace
}  // namespace physgen::fem
