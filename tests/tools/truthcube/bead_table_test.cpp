// Tables of measured beads: what is read, which line is named when it cannot be, and errors in millimetres.
#include <fem/mesh/follow_numbers.h>
#include <fem/mesh/truth_cube.h>
#include <truthcube/output/bead_table.h>
#include <truthcube/output/beads.h>

#include <cmath>

#include "scratch.h"

namespace physgen::truthcube {
namespace {

using testing::expect_error;

class BeadTables : public testing::Scratch {
 public:
  BeadTable read(const std::string& text) {
    testing::put_text(path, text);
    return read_bead_table(path);
  }
  // Expects an error of a line, or, with line 0, of the whole file.
  void expect_refused(const std::string& text, int line, const std::string& part) {
    const std::string place = path.string() + (line > 0 ? ":" + std::to_string(line) + ": " : ": ");
    expect_error([&] { static_cast<void>(read(text)); }, place, part);
  }

  std::filesystem::path path = in_folder("measured.csv");
};

constexpr const char* header = "x,y,z,ux,uy,uz\n";
std::string header_and(const std::string& rows) { return header + rows; }

// Errors that must be there; otherwise, of no bead.
BeadErrors errors_of(const BeadTable& table, double compression, std::span<const fem::Point> computed) {
  return compare_beads(table, compression, computed).value_or(BeadErrors{});
}

TEST_F(BeadTables, rows_are_read_with_their_lines) {
  const BeadTable table = read(header_and("0.01,0.02,0.03,1e-3,-2E-3,+.003\n\n 0.04 , 5e-2,\t0.06,0,-0,1\r\n"));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.file, path);
  EXPECT_EQ(table.rows[0].rest, (fem::Point{0.01, 0.02, 0.03}));
  EXPECT_EQ(table.rows[0].displacement, (fem::Point{1e-3, -2e-3, 3e-3}));
  EXPECT_FALSE(table.rows[0].compression);
  EXPECT_EQ(table.rows[0].line, 2);
  EXPECT_EQ(table.rows[1].rest, (fem::Point{0.04, 0.05, 0.06}));
  EXPECT_EQ(table.rows[1].line, 4);
}

TEST_F(BeadTables, columns_stand_in_any_order) {
  const BeadTable table = read("\xEF\xBB\xBFuz, uy,ux,compression,z,y,x\r\n6,5,4,0.125,3,2,1");
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].rest, (fem::Point{1, 2, 3}));
  EXPECT_EQ(table.rows[0].displacement, (fem::Point{4, 5, 6}));
  EXPECT_EQ(table.rows[0].compression, 0.125);
}

TEST_F(BeadTables, beads_csv_is_such_a_table) {
  std::vector<fem::Point> u(bead_count);
  for (std::size_t b = 0; b < bead_count; ++b) u[b] = {1. / (3 + static_cast<double>(b)), -1e-300, 0};
  BeadFile file(path);
  file.write_step(0.05, u);
  file.write_step(0.1825, u);
  const BeadTable table = read_bead_table(path);
  ASSERT_EQ(table.rows.size(), 2 * bead_count);
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    EXPECT_EQ(table.rows[r].compression, r < bead_count ? 0.05 : 0.1825);
    EXPECT_EQ(table.rows[r].rest, bead_positions()[r % bead_count]);
    EXPECT_EQ(table.rows[r].displacement, u[r % bead_count]);
  }
}

TEST_F(BeadTables, malformed_headers_are_named) {
  expect_refused("x,y,z,ux,uy\n1,2,3,4,5\n", 1, "no column uz");
  expect_refused("x,y,z,ux,uy,uz,force\n", 1, "unknown column \"force\"");
  expect_refused("\n\nx,y,z,ux,uy,uz,x\n", 3, "x is there twice");
  expect_refused("0.01,0.02,0.03,0,0,0\n", 1, "unknown column \"0.01\"");
  expect_refused("x;y;z;ux;uy;uz\n", 1,
                 "unknown column \"x;y;z;ux;uy;uz\"; columns are x,y,z,ux,uy,uz and, if there is one, compression, "
                 "separated by commas");
  expect_refused("\x1b[2J\x07" + std::string(5000, 'x'), 1, "unknown column \"?[2J?" + std::string(35, 'x') + "...\";");
}

TEST_F(BeadTables, malformed_rows_are_named) {
  const std::string good = header_and("1,2,3,4,5,6\n");
  expect_refused(good + "1,2,3,4,5\n", 3, "5 values for 6 columns");
  expect_refused(good + "\n1,2,3,4,5,6,7\n", 4, "7 values for 6 columns");
  expect_refused(good + "1,2,three,4,5,6\n", 3, "\"three\" in column z");
  expect_refused(good + "1,2,3,4,,6\n", 3, "\"\" in column uy");
  expect_refused(good + "1,2,3,4,5,6 mm\n", 3, "\"6 mm\" in column uz");
  expect_refused(good + "1,2,3,nan,5,6\n", 3, "\"nan\" in column ux");
  expect_refused(good + "1,2,3,4,inf,6\n", 3, "\"inf\" in column uy");
  expect_refused(good + "1e999,2,3,4,5,6\n", 3, "\"1e999\" in column x");
  expect_refused(good + "+-1,2,3,4,5,6\n", 3, "\"+-1\" in column x");
}

TEST_F(BeadTables, beads_with_two_displacements_are_named_with_both_lines) {
  expect_refused(header_and("0.01,0.02,0.03,0,0,0\n0.02,0.02,0.03,0,0,0\n0.01,0.02,0.03,1,0,0\n"), 4,
                 "has a displacement in line 2, too: remove one of them, or say in a column compression");
  const std::string with_compression = "compression,x,y,z,ux,uy,uz\n0.1,1,2,3,0,0,0\n0.2,1,2,3,0,0,0\n";
  EXPECT_EQ(read(with_compression).rows.size(), 2U);
  expect_refused(with_compression + "0.1,1,2,3,0,0,0\n", 4,
                 "at the same compression in line 2, too: remove one of them");
}

TEST_F(BeadTables, files_without_rows_are_named) {
  expect_refused("", 0, "has no rows");
  expect_refused(header_and("\n\n"), 0, "has no rows");
  expect_error([&] { static_cast<void>(read_bead_table(in_folder("absent.csv"))); }, "absent.csv", "cannot be read");
  expect_error([&] { static_cast<void>(read_bead_table(path.parent_path())); }, "cannot be read");
}

TEST_F(BeadTables, bead_outside_the_mesh_is_named_by_its_line) {
  const fem::TruthCube cube = fem::make_truth_cube(2, 1);
  const BeadTable table = read(header_and("0.01,0.02,0.03,0,0,0\n\n0.01,0.02,30,0,0,0\n"));
  expect_error([&] { static_cast<void>(locate_beads(table, cube.rest, cube.mesh)); },
               path.string() + ":4: ", "outside the mesh", "(0.01, 0.02, 30) m");
}

TEST_F(BeadTables, errors_are_mean_rms_p95_and_max_in_millimetres) {
  std::string text = header;
  std::vector<fem::Point> computed;
  for (int i = 20; i >= 1; --i) {  // errors of 1 .. 20 mm, in turns along x, y and z
    text += std::to_string(i) + ",0.01,0.01,0.5,0.25,-0.125\n";
    fem::Point u{0.5, 0.25, -0.125};
    u[static_cast<std::size_t>(i % 3)] += (i % 2 == 0 ? 1e-3 : -1e-3) * i;
    computed.push_back(u);
  }
  const BeadTable table = read(text);
  const BeadErrors errors = errors_of(table, 0.05, computed);
  EXPECT_EQ(errors.beads, 20U);
  EXPECT_NEAR(errors.mean, 10.5, 1e-12);
  EXPECT_NEAR(errors.rms, std::sqrt(143.5), 1e-12);
  EXPECT_NEAR(errors.p95, 19, 1e-12);
  EXPECT_NEAR(errors.max, 20, 1e-12);
  expect_error([&] { static_cast<void>(compare_beads(table, 0.05, std::span(computed).first(3))); }, "3 displacements",
               "20 rows");
}

TEST_F(BeadTables, one_bead_is_its_own_mean_and_maximum) {
  const BeadTable table = read(header_and("0,0,0,0.003,0,0.004\n"));
  const std::vector<fem::Point> computed(1);
  const BeadErrors errors = errors_of(table, 0, computed);
  for (const double e : {errors.mean, errors.rms, errors.p95, errors.max}) EXPECT_NEAR(e, 5, 1e-14);
}

TEST_F(BeadTables, rows_of_other_compressions_are_left_out) {
  const BeadTable table = read("compression," + header_and("0.05,0,0,0,0.001,0,0\n0.1250000001,0,0,0,0.002,0,0\n"));
  const std::vector<fem::Point> computed(2);
  EXPECT_NEAR(errors_of(table, 0.05, computed).max, 1, 1e-14);
  EXPECT_EQ(errors_of(table, 0.125, computed).beads, 1U);
  EXPECT_NEAR(errors_of(table, 0.125, computed).mean, 2, 1e-14);
  EXPECT_FALSE(compare_beads(table, 0.1825, computed));
}

TEST_F(BeadTables, table_is_compared_at_its_own_rest_positions) {
  const fem::TruthCube cube = fem::make_truth_cube(4, 1);
  std::vector<fem::Point> positions = cube.rest;
  for (fem::Point& x : positions) x[2] *= 0.875;  // u = (0, 0, -z / 8)
  const BeadTable table = read(header_and("0.0123,0.0456,0.04,0,0,-0.005\n0.0791,0.001,0.08,0,0,-0.012\n"));
  const std::vector<fem::Location> locations = locate_beads(table, cube.rest, cube.mesh);
  const auto corners = fem::in_order(std::span<const fem::Point>(positions), corners_of(locations, cube.mesh));
  const auto computed = interpolate_displacements(locations, cube.mesh, cube.rest, corners);
  const BeadErrors errors = errors_of(table, 0.125, computed);
  EXPECT_NEAR(errors.mean, 1, 1e-12);
  EXPECT_NEAR(errors.max, 2, 1e-12);
}

}  // namespace
}  // namespace physgen::truthcube
