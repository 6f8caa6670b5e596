// Beads of the Truth Cube in a mesh, and beads.csv.
#include <fem/mesh/follow_numbers.h>
#include <fem/mesh/truth_cube.h>
#include <truthcube/output/beads.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "scratch.h"
#include "writes.h"

namespace physgen::truthcube {
namespace {

using testing::expect_error;
using testing::read_text;

class Beads : public testing::Scratch {
 public:
  std::filesystem::path path = in_folder("beads.csv");
};

std::vector<fem::Point> displacements(int step) {
  std::vector<fem::Point> u(bead_count);
  for (std::size_t b = 0; b < bead_count; ++b) u[b] = {step + 1. / 3, -static_cast<double>(b) / 7, 1e-5 * step};
  return u;
}

double compression(int step) { return 0.05 + step / 30.; }

BeadFile file_of(const std::filesystem::path& path, int steps) {
  BeadFile file(path);
  for (int s = 0; s < steps; ++s) file.write_step(compression(s), displacements(s));
  return file;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST_F(Beads, are_a_grid_of_centimetres_with_x_outermost) {
  const std::vector<fem::Point> beads = bead_positions();
  ASSERT_EQ(beads.size(), 343U);
  EXPECT_EQ(beads.front(), (fem::Point{0.01, 0.01, 0.01}));
  EXPECT_EQ(beads[1], (fem::Point{0.01, 0.01, 0.02}));
  EXPECT_EQ(beads[7], (fem::Point{0.01, 0.02, 0.01}));
  EXPECT_EQ(beads[49], (fem::Point{0.02, 0.01, 0.01}));
  EXPECT_EQ(beads.back(), (fem::Point{7 * 0.01, 7 * 0.01, 7 * 0.01}));
}

TEST_F(Beads, follow_an_affine_deformation) {
  for (const fem::Index cells : {1, 3, 8}) {
    const fem::TruthCube cube = fem::make_truth_cube(cells, 1);
    const auto deform = [](const fem::Point& x) {
      return fem::Point{0.9 * x[0] + 0.2 * x[1] + 0.01, 1.1 * x[1] - 0.3 * x[2], 0.4 * x[0] + 0.8 * x[2] - 0.02};
    };
    std::vector<fem::Point> positions(cube.rest.size());
    std::ranges::transform(cube.rest, positions.begin(), deform);
    const std::vector<fem::Point> beads = bead_positions();
    const std::vector<fem::Location> locations = fem::locate(cube.rest, cube.mesh, beads);
    const auto corners = fem::in_order(std::span<const fem::Point>(positions), corners_of(locations, cube.mesh));
    const std::vector<fem::Point> u = interpolate_displacements(locations, cube.mesh, cube.rest, corners);
    ASSERT_EQ(u.size(), bead_count);
    for (std::size_t b = 0; b < bead_count; ++b) {
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(u[b][k], deform(beads[b])[k] - beads[b][k], 1e-16);
    }
  }
}

TEST_F(Beads, need_a_position_for_each_corner) {
  const fem::TruthCube cube = fem::make_truth_cube(1, 1);
  const std::span<const fem::Point> rest = cube.rest;
  const std::vector<fem::Location> two(2);
  expect_error([&] { static_cast<void>(interpolate_displacements(two, cube.mesh, rest, rest.first(7))); },
               "7 positions", "8 corners");
  expect_error([&] { static_cast<void>(interpolate_displacements(two, cube.mesh, rest.first(7), rest)); },
               "7 rest positions", "8 nodes");
}

TEST_F(Beads, file_has_a_row_for_each_bead_and_step_with_all_digits) {
  static_cast<void>(file_of(path, 3));
  const std::vector<std::string> lines = lines_of(read_text(path));
  ASSERT_EQ(lines.size(), 1 + 3 * bead_count);
  EXPECT_EQ(lines[0], "compression,x,y,z,ux,uy,uz");
  const std::vector<fem::Point> beads = bead_positions();
  for (int s = 0; s < 3; ++s) {
    const std::vector<fem::Point> u = displacements(s);
    for (std::size_t b = 0; b < bead_count; ++b) {
      std::istringstream row(lines[1 + static_cast<std::size_t>(s) * bead_count + b]);
      std::vector<double> numbers;
      for (std::string cell; std::getline(row, cell, ',');) numbers.push_back(std::strtod(cell.c_str(), nullptr));
      EXPECT_EQ(numbers,
                (std::vector{compression(s), beads[b][0], beads[b][1], beads[b][2], u[b][0], u[b][1], u[b][2]}));
    }
  }
}

TEST_F(Beads, file_keeps_awkward_numbers) {
  std::vector<fem::Point> u(bead_count);
  u[0] = {std::numeric_limits<double>::denorm_min(), -0.0, std::numeric_limits<double>::max()};
  BeadFile(path).write_step(0.1, u);
  const std::string row = lines_of(read_text(path))[1];
  EXPECT_TRUE(row.starts_with("0.10000000000000001,")) << row;
  EXPECT_TRUE(row.ends_with(",4.9406564584124654e-324,-0,1.7976931348623157e+308")) << row;
}

TEST_F(Beads, restart_keeps_the_steps_asked_for) {
  const std::string two = (static_cast<void>(file_of(path, 2)), read_text(path));
  const std::string four = (static_cast<void>(file_of(path, 4)), read_text(path));
  BeadFile file = BeadFile::append_to(path, 2);
  EXPECT_EQ(read_text(path), two);
  for (int s = 2; s < 4; ++s) file.write_step(compression(s), displacements(s));
  EXPECT_EQ(read_text(path), four);
  testing::put_text(path, two + "0.1,0.01,0.");  // a kill in the middle of a row
  file = BeadFile::append_to(path, 2);
  EXPECT_EQ(read_text(path), two);
  static_cast<void>(BeadFile::append_to(path, 0));
  EXPECT_EQ(read_text(path), "compression,x,y,z,ux,uy,uz\n");
}

TEST_F(Beads, restart_refuses_what_it_cannot_continue) {
  const auto continue_after = [&](int steps) {
    return [&, steps] { static_cast<void>(BeadFile::append_to(path, steps)); };
  };
  expect_error(continue_after(1), path.string(), "cannot be opened");
  static_cast<void>(file_of(path, 2));
  const std::string complete = read_text(path);
  expect_error(continue_after(3), path.string(), "fewer rows", "3 steps");
  EXPECT_EQ(read_text(path), complete);
  testing::put_text(path, complete.substr(0, complete.size() - 1));  // the last row has no end
  expect_error(continue_after(2), "fewer rows");
  std::string damaged = complete;
  damaged.replace(damaged.find('\n', damaged.size() / 2) + 5, 3, std::string(3, '\0'));
  testing::put_text(path, damaged);
  const auto line = 2 + std::ranges::count(complete.substr(0, complete.size() / 2), '\n');
  expect_error(continue_after(2), path.string() + ":" + std::to_string(line) + ": this is not a row of numbers",
               "without --restart");
  EXPECT_EQ(read_text(path), damaged);
  testing::put_text(path, "x,y,z,ux,uy,uz\n" + complete);
  expect_error(continue_after(2), path.string(), "header");
}

TEST_F(Beads, write_that_fails_leaves_the_rows_before) {
  BeadFile file = file_of(path, 1);
  const std::string one = read_text(path);
  expect_error([&] { file.write_step(0.1, std::span<const fem::Point>(displacements(1)).first(342)); }, "342", "343");
  testing::stop_writes(testing::At::Failure, 0);
  const std::string error = testing::error_of([&] { file.write_step(compression(1), displacements(1)); });
  testing::resume_writes();
  EXPECT_NE(error.find(path.string() + ": cannot append"), std::string::npos) << error;
  EXPECT_EQ(read_text(path), one);
  const testing::ReadOnly read_only(path.parent_path());
  expect_error([&] { static_cast<void>(file_of(in_folder("new.csv"), 0)); }, "new.csv", "Permission denied");
}

}  // namespace
}  // namespace physgen::truthcube
