// Meshes whose lists reach the end of 32-bit numbers, or leave them.
#include <fem/solver/quasistatic.h>
#include <gtest/gtest.h>
#include <physgen/error.h>
#include <truthcube/run_bytes.h>

#include <limits>
#include <string>

namespace physgen::truthcube {
namespace {

TEST(Sizes, of_meshes_beyond_numbers_of_32_bits_are_refused_with_the_number) {
  LevelCounts counts;
  counts.nodes = 1000;
  counts.edges = std::int64_t{1} << 30;  // two entries each: one more than numbers reach
  try {
    require_mesh_fits({LevelCounts{}, counts});
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("numbers up to 2147483648, and 32-bit numbers only reach 2147483647"),
              std::string::npos)
        << error.what();
  }
  require_mesh_fits(count_levels(fem::make_cube_levels(4, 0.08, true)));
}

TEST(Sizes, of_a_cube_beyond_32_bits_are_still_right) {
  constexpr std::int64_t cells = 50000;
  const LevelCounts finest = count_cube(cells, VolumeTreatment::patches).front();
  EXPECT_EQ(finest.nodes, (cells + 1) * (cells + 1) * (cells + 1));
  EXPECT_EQ(finest.tets, 6 * cells * cells * cells);
  // 3 edges along the axes, 6 diagonals of faces and 4 of the cell.
  EXPECT_EQ(finest.edges,
            3 * cells * (cells + 1) * (cells + 1) + 6 * cells * cells * (cells + 1) + 4 * cells * cells * cells);
  EXPECT_GT(largest_number(count_cube(cells, VolumeTreatment::patches)),
            std::int64_t{std::numeric_limits<fem::Index>::max()});
}

TEST(Sizes, reach_the_largest_mesh_that_can_be_numbered) {
  EXPECT_LE(largest_number(count_cube(274, VolumeTreatment::patches)),
            std::int64_t{std::numeric_limits<fem::Index>::max()});
  EXPECT_GT(largest_number(count_cube(276, VolumeTreatment::patches)),
            std::int64_t{std::numeric_limits<fem::Index>::max()});
}

}  // namespace
}  // namespace physgen::truthcube
