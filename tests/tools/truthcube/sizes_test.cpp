// What truthcube says of sizes and bytes before anything is allocated, against what is allocated then.
#include <fem/solver/background_grid.h>
#include <fem/solver/quasistatic.h>
#include <gtest/gtest.h>
#include <truthcube/sizes.h>

#include <limits>
#include <numeric>
#include <string>

namespace physgen::truthcube {
namespace {

TEST(Sizes, of_cubes_are_those_of_their_meshes) {
  for (const bool patches : {false, true}) {
    for (const int cells : {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 18}) {
      EXPECT_EQ(count_cube(cells, patches), count_levels(fem::make_cube_levels(cells, 0.08, patches)))
          << cells << " cells, patches " << patches;
    }
  }
}

struct Case {
  int cells;
  bool patches;
};

class Bytes : public ::testing::TestWithParam<Case> {
 protected:
  // The bottom and the top are held; nothing is solved.
  static std::int64_t allocated(const fem::SolverSettings& settings) {
    std::vector<fem::MeshLevel> levels = fem::make_cube_levels(GetParam().cells, 0.08, GetParam().patches);
    for (fem::MeshLevel& level : levels) {
      for (std::size_t n = 0; n < level.rest.size(); ++n) {
        if (level.rest[n][2] == 0 || level.rest[n][2] == 0.08) level.fixed[n] = 7;
      }
    }
    const fem::Loading loading{std::vector<fem::Point>(levels.front().rest.size(), fem::Point{}), {}};
    return fem::make_solver(levels, loading, settings)->bytes();
  }
  static std::int64_t predicted(const fem::SolverSettings& settings) {
    const RunBytes bytes = bytes_of_run(count_cube(GetParam().cells, GetParam().patches), settings);
    EXPECT_EQ(std::accumulate(bytes.levels.begin(), bytes.levels.end(), std::int64_t{0}), bytes.solver);
    return bytes.solver;
  }
  static void expect_near(const fem::SolverSettings& settings) {
    const auto real = static_cast<double>(allocated(settings));
    EXPECT_NEAR(static_cast<double>(predicted(settings)), real, 0.05 * real);
  }
};

TEST_P(Bytes, of_each_precision_are_those_of_the_solver) {
  for (const auto precision :
       {fem::TangentPrecision::half, fem::TangentPrecision::float32, fem::TangentPrecision::float64}) {
    SCOPED_TRACE(static_cast<int>(precision));
    fem::SolverSettings settings;
    settings.precision = precision;
    expect_near(settings);
  }
}

TEST_P(Bytes, without_coarser_levels_are_those_of_the_solver) {
  fem::SolverSettings settings;
  settings.nested = false;
  settings.newton.preconditioner.kind = fem::Preconditioner::block_jacobi;
  expect_near(settings);
  EXPECT_EQ(bytes_of_run(count_cube(GetParam().cells, GetParam().patches), settings).levels.size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Cubes, Bytes,
                         ::testing::Values(Case{4, false}, Case{4, true}, Case{8, false}, Case{8, true}, Case{9, true},
                                           Case{12, false}, Case{12, true}, Case{16, false}, Case{16, true},
                                           Case{24, false}, Case{24, true}),
                         [](const auto& info) {
                           return std::to_string(info.param.cells) + (info.param.patches ? "_patches" : "_tets");
                         });

TEST(Sizes, of_a_mesh_on_a_background_grid_are_those_of_the_solver) {
  for (const bool patches : {false, true}) {
    for (const int levels_of_meshes : {1, 2}) {
      std::vector<fem::MeshLevel> levels = fem::make_cube_levels(14, 0.08, patches);
      if (levels_of_meshes == 1) {
        levels.resize(1);
        levels[0].parents.clear();
        levels[0].patch_parents.clear();
      }
      for (fem::MeshLevel& level : levels) {
        for (std::size_t n = 0; n < level.rest.size(); ++n) level.fixed[n] = level.rest[n][2] == 0 ? 7 : 0;
      }
      (void)fem::add_background_grid(levels);
      ASSERT_GT(static_cast<int>(levels.size()), levels_of_meshes);
      const fem::Loading loading{std::vector<fem::Point>(levels.front().rest.size(), fem::Point{}), {}};
      for (const auto precision : {fem::TangentPrecision::half, fem::TangentPrecision::float64}) {
        fem::SolverSettings settings;
        settings.precision = precision;
        settings.coarsest_nested = 0;
        EXPECT_EQ(bytes_of_run(count_levels(levels), settings).solver,
                  fem::make_solver(levels, loading, settings)->bytes());
      }
    }
  }
}

TEST(Sizes, of_a_cube_beyond_32_bits_are_still_right) {
  constexpr std::int64_t cells = 50000;
  const LevelCounts finest = count_cube(cells, true).front();
  EXPECT_EQ(finest.nodes, (cells + 1) * (cells + 1) * (cells + 1));
  EXPECT_EQ(finest.tets, 6 * cells * cells * cells);
  // 3 edges along the axes, 6 diagonals of faces and 4 of the cell.
  EXPECT_EQ(finest.edges,
            3 * cells * (cells + 1) * (cells + 1) + 6 * cells * cells * (cells + 1) + 4 * cells * cells * cells);
  EXPECT_GT(longest_list(count_cube(cells, true)), std::int64_t{std::numeric_limits<fem::Index>::max()});
}

TEST(Sizes, reach_the_largest_mesh_that_can_be_numbered) {
  EXPECT_LE(longest_list(count_cube(310, true)), std::int64_t{std::numeric_limits<fem::Index>::max()});
  EXPECT_GT(longest_list(count_cube(311, true)), std::int64_t{std::numeric_limits<fem::Index>::max()});
}

TEST(Sizes, of_lists_contain_the_meshes_of_all_levels_twice) {
  const auto counts = count_cube(8, true);
  std::int64_t meshes = 0;
  for (const LevelCounts& level : counts) meshes += bytes_of_mesh(level);
  EXPECT_GT(bytes_of_run(counts, {}).lists, 2 * meshes);
}

}  // namespace
}  // namespace physgen::truthcube
