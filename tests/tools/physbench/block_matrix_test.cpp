// The block matrix that vendors' libraries are given, against the symmetric blocks that it is made from.
#include "vendor/block_matrix.h"

#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/levels/scattered.h>
#include <fem/solver/quasistatic.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <cmath>

namespace physgen::bench {
namespace {

using fem::Point;

struct Scene {
  fem::AssembledStiffness stiffness;
  std::vector<std::uint8_t> fixed;
};

/// The cube at rest, its base held and its top along z alone.
Scene make_scene() {
  auto levels = fem::make_cube_levels(4, 0.08, true);
  for (fem::MeshLevel& level : levels) {
    for (std::size_t n = 0; n < level.rest.size(); ++n) {
      level.fixed[n] = level.rest[n][2] == 0 ? 7 : (level.rest[n][2] == 0.08 ? 4 : 0);
    }
  }
  const fem::Loading loading{std::vector<Point>(levels.front().rest.size(), Point{}), {}};
  fem::SolverSettings settings;
  return {fem::make_solver(levels, loading, settings)->stiffness(), levels.front().fixed};
}

std::vector<Point> product(const BlockMatrix& matrix, BlockOrder order, const std::vector<Point>& x) {
  std::vector<Point> y(x.size(), Point{});
  for (std::size_t row = 0; row < x.size(); ++row) {
    for (int b = matrix.begin[row]; b < matrix.begin[row + 1]; ++b) {
      const auto at = static_cast<std::size_t>(b);
      const Point& from = x[static_cast<std::size_t>(matrix.columns[at])];
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) {
          const std::size_t scalar = order == BlockOrder::by_rows ? 3 * r + c : 3 * c + r;
          y[row][r] += static_cast<double>(matrix.blocks[9 * at + scalar]) * from[c];
        }
      }
    }
  }
  return y;
}

TEST(BlockMatrix, has_the_free_part_of_the_stiffness_in_both_orders) {
  const Scene scene = make_scene();
  std::vector<Point> x(scene.fixed.size());
  for (std::size_t n = 0; n < x.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_free = (scene.fixed[n] >> k & 1) == 0;
      x[n][k] = is_free ? fem::detail::scattered(static_cast<index_t>(3 * n + k), 5) : 0.0;
    }
  }
  const std::vector<Point> expected = scene.stiffness.product(x);
  double largest = 0;
  for (const Point& y : expected) largest = std::max({largest, std::abs(y[0]), std::abs(y[1]), std::abs(y[2])});
  ASSERT_GT(largest, 0);
  for (const BlockOrder order : {BlockOrder::by_columns, BlockOrder::by_rows}) {
    const BlockMatrix matrix = make_block_matrix(scene.stiffness, scene.fixed, order);
    // Prescribed components of x must not matter, those of y are 0.
    std::vector<Point> noisy = x;
    for (std::size_t n = 0; n < x.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) {
        if ((scene.fixed[n] >> k & 1) != 0) noisy[n][k] = 1e6;
      }
    }
    const std::vector<Point> y = product(matrix, order, noisy);
    for (std::size_t n = 0; n < x.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) {
        const bool is_free = (scene.fixed[n] >> k & 1) == 0;
        EXPECT_NEAR(y[n][k], is_free ? expected[n][k] : 0.0, 1e-6 * largest) << n << " " << k;
      }
    }
  }
}

TEST(BlockMatrix, has_ascending_columns_and_a_block_of_each_node_and_two_of_each_edge) {
  const Scene scene = make_scene();
  const BlockMatrix matrix = make_block_matrix(scene.stiffness, scene.fixed, BlockOrder::by_rows);
  ASSERT_EQ(matrix.begin.size(), scene.fixed.size() + 1);
  EXPECT_EQ(matrix.columns.size(), scene.fixed.size() + 2 * scene.stiffness.edges.size());
  EXPECT_EQ(matrix.begin.front(), 0);
  EXPECT_EQ(matrix.begin.back(), static_cast<int>(matrix.columns.size()));
  for (std::size_t row = 0; row + 1 < matrix.begin.size(); ++row) {
    bool has_diagonal = false;
    for (int b = matrix.begin[row]; b < matrix.begin[row + 1]; ++b) {
      const int column = matrix.columns[static_cast<std::size_t>(b)];
      has_diagonal = has_diagonal || column == static_cast<int>(row);
      if (b > matrix.begin[row]) {
        EXPECT_GT(column, matrix.columns[static_cast<std::size_t>(b) - 1]);
      }
    }
    EXPECT_TRUE(has_diagonal) << row;
  }
}

TEST(BlockMatrix, refuses_prescribed_components_of_another_mesh) {
  const Scene scene = make_scene();
  EXPECT_THROW((void)make_block_matrix(scene.stiffness, {}, BlockOrder::by_rows), Error);
}

}  // namespace
}  // namespace physgen::bench
