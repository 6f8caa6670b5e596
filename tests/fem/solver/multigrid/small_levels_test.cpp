// Which levels of a V-cycle CUDA runs in one kernel.
#include <fem/solver/hierarchy/background_grid.h>
#include <fem/solver/preconditioners/multigrid/level_views.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "../irregular.h"

namespace physgen::fem {
namespace {

/// The size of a level and the rows that it has on CUDA.
struct LevelWithRows {
  index_t count;
  EdgeRows rows;

  explicit LevelWithRows(const MeshLevel& level)
      : count(level.mesh.nodes),
        rows(count <= EdgeRows::most_nodes ? EdgeRows(level.mesh, SpaceKind::host) : EdgeRows()) {}
  [[nodiscard]] index_t nodes() const { return count; }
};

TEST(SmallLevels, are_those_below_which_all_are_small_since_a_grid_may_have_more_nodes_than_its_mesh) {
  auto levels = make_levels(studs(11, 10, 0.01), 0, false, [](const Point&) -> std::uint8_t { return 0; });
  (void)add_background_grid(levels);
  ASSERT_GE(levels.size(), 3U);
  ASSERT_LE(levels[0].mesh.nodes, EdgeRows::most_nodes);
  ASSERT_GT(levels[1].mesh.nodes, EdgeRows::most_nodes);
  ASSERT_LE(levels[2].mesh.nodes, EdgeRows::most_nodes);
  std::vector<std::unique_ptr<LevelWithRows>> with_rows;
  for (const MeshLevel& level : levels) with_rows.push_back(std::make_unique<LevelWithRows>(level));
  EXPECT_FALSE(are_small(with_rows, 0, EdgeRows::most_nodes));
  EXPECT_FALSE(are_small(with_rows, 1, EdgeRows::most_nodes));
  EXPECT_TRUE(are_small(with_rows, 2, EdgeRows::most_nodes));
  EXPECT_TRUE(are_small(with_rows, 2, levels[2].mesh.nodes));
  EXPECT_FALSE(are_small(with_rows, 2, levels[2].mesh.nodes - 1));
}

}  // namespace
}  // namespace physgen::fem
