// Which levels are cut, and what cannot be cut. conjugate_gradients.cpp has their bits on several ranks.
#include <fem/solver/levels/distributed_levels.h>
#include <fem/solver/levels/level_halos.h>
#include <gtest/gtest.h>
#include <quasistatic.scene.h>

namespace physgen::fem {
namespace {

using Level = LevelOver<float, Host, StoredAsComputed, AssembledOnMeshes,
                        scenes::quasistatic_scene::Level<Host, float, StoredAsComputed>, NoArrays, NoArrays, NoArrays>;

std::vector<LevelGraph> graphs_of(std::initializer_list<Index> nodes) {
  std::vector<LevelGraph> graphs;
  for (const Index n : nodes) graphs.emplace_back().nodes = n;
  return graphs;
}

TEST(LevelsThatAreCut, are_the_finest_and_those_that_are_large_for_the_ranks) {
  EXPECT_EQ(levels_that_are_cut(graphs_of({8}), 4), 1U) << "the finest one always";
  EXPECT_EQ(levels_that_are_cut(graphs_of({912673, 117649, 15625}), 2), 2U);
  EXPECT_EQ(levels_that_are_cut(graphs_of({912673, 117649, 15625}), 7), 2U);
  EXPECT_EQ(levels_that_are_cut(graphs_of({912673, 117649, 15625}), 8), 1U) << "less than 8 blocks a rank";
  EXPECT_EQ(levels_that_are_cut(graphs_of({357911, 50653, 6859}), 2), 1U) << "36^3 cells stand on every rank";
  EXPECT_EQ(levels_that_are_cut(graphs_of({357911, 50654, 6859}), 2), 2U);
  EXPECT_EQ(levels_that_are_cut(graphs_of({912673, 117649, 40000}), 2, 30000), 3U);
  EXPECT_EQ(levels_that_are_cut(graphs_of({912673, 117649, 15625}), 8, 30000), 2U) << "what is asked for counts alone";
  EXPECT_EQ(levels_that_are_cut(graphs_of({729, 125}), 8, 1), 1U) << "none that is inverted";
  EXPECT_EQ(levels_that_are_cut(graphs_of({2197, 343}), 8, 1), 2U);
  EXPECT_EQ(levels_that_are_cut(graphs_of({912673, 20000, 117649}), 2), 1U) << "none below one that is not";
  std::vector<LevelGraph> on_grid = graphs_of({912673, 117649, 117649});
  on_grid[2].is_grid = true;
  EXPECT_EQ(levels_that_are_cut(on_grid, 2, 30000), 2U) << "none of a background grid";
}

TEST(Levels, of_a_background_grid_are_not_cut) {
  int argc = 0;
  char** argv = nullptr;
  const Ranks ranks(argc, argv);
  DistributedArrays arrays(ranks, {});
  std::vector<LevelGraph> graphs = graphs_of({8, 4});
  graphs[1].is_grid = true;
  std::vector<std::unique_ptr<Level>> levels(2);
  for (auto& level : levels) level = std::make_unique<Level>(Level::Own());
  try {
    add_levels(arrays, levels, std::span<const LevelGraph>(graphs), 2);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "physgen: level 1 is one of a background grid, which all ranks have; cut the levels above it alone");
  }
}

TEST(Levels, of_graphs_that_were_only_counted_are_refused) {
  int argc = 0;
  char** argv = nullptr;
  const Ranks ranks(argc, argv);
  DistributedArrays arrays(ranks, {});
  std::vector<LevelGraph> graphs = graphs_of({8, 4});
  graphs[0].edge_terms.first.resize(2);
  graphs[0].edge_terms.first[0] = 0;
  graphs[0].edge_terms.first[1] = 3;
  std::vector<std::unique_ptr<Level>> levels(2);
  for (auto& level : levels) level = std::make_unique<Level>(Level::Own());
  try {
    add_levels(arrays, levels, std::span<const LevelGraph>(graphs), 1);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "physgen: a level's graph says how many edges its rows have, and not which; give graphs that "
                 "make_level_graphs() made");
  }
}

TEST(HalosOfLevels, replace_the_rows_that_a_scene_has_of_the_same_kernels) {
  constexpr HaloUse scene[] = {{"physgen::fem::RestrictResidual", 3, "scale", {.reads_own = true}},
                               {"physgen::fem::TakeStep", 5, "dx", {.reads_own = true, .writes_own = true}}};
  int of_restriction = 0, of_steps = 0;
  for (const HaloUse& row : with_halos_of_levels(scene)) {
    EXPECT_FALSE(row == scene[0]);
    of_restriction += row.kernel == scene[0].kernel ? 1 : 0;
    of_steps += row == scene[1] ? 1 : 0;
  }
  EXPECT_EQ(of_restriction, 9);
  EXPECT_EQ(of_steps, 1);
}

}  // namespace
}  // namespace physgen::fem
