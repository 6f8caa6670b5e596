// The VTKHDF file, read back by HDF5: the mesh, each offset and value of several steps, what is refused, and restarts.
#include <fem/mesh/boundary.h>
#include <sys/file.h>
#include <truthcube/output/vtkhdf.h>

#include <cmath>
#include <limits>

#include "scratch.h"
#include "vtkhdf_scene.h"

namespace physgen::truthcube {
namespace {

using testing::expect_error;
using testing::H5File;
using testing::Scene;

class VtkHdf : public testing::Scratch {
 public:
  Scene scene;
  std::filesystem::path path = in_folder("cube.vtkhdf");
};

TEST_F(VtkHdf, file_without_steps_is_a_static_mesh) {
  const VtkHdfWriter writer = scene.create(path, 0);
  EXPECT_EQ(writer.steps(), 0);
  const H5File file(path);
  EXPECT_EQ(file.integers("/VTKHDF", "Version"), (std::vector{2, 0}));
  EXPECT_EQ(file.text("/VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_FALSE(file.has("/VTKHDF/Steps"));
  const auto nodes = static_cast<std::int64_t>(scene.nodes()), tets = static_cast<std::int64_t>(scene.tets());
  EXPECT_EQ(file.values<std::int64_t>("/VTKHDF/NumberOfPoints"), std::vector{nodes});
  EXPECT_EQ(file.values<std::int64_t>("/VTKHDF/NumberOfCells"), std::vector{tets});
  EXPECT_EQ(file.values<std::int64_t>("/VTKHDF/NumberOfConnectivityIds"), std::vector{4 * tets});
  EXPECT_EQ(file.shape("/VTKHDF/Points"), (std::vector<hsize_t>{scene.nodes(), 3}));
  const std::vector<double> points = file.values<double>("/VTKHDF/Points");
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i], scene.points[i / 3][i % 3]);
  const std::vector<std::int64_t> corners = file.values<std::int64_t>("/VTKHDF/Connectivity");
  ASSERT_EQ(corners.size(), 4 * scene.tets());
  for (std::size_t i = 0; i < corners.size(); ++i) EXPECT_EQ(corners[i], scene.mesh.tets[i / 4][i % 4]);
  const std::vector<std::int64_t> offsets = file.values<std::int64_t>("/VTKHDF/Offsets");
  ASSERT_EQ(offsets.size(), scene.tets() + 1);
  for (std::size_t i = 0; i < offsets.size(); ++i) EXPECT_EQ(offsets[i], static_cast<std::int64_t>(4 * i));
  EXPECT_EQ(file.values<std::uint8_t>("/VTKHDF/Types"), std::vector<std::uint8_t>(scene.tets(), 10));
}

TEST_F(VtkHdf, every_step_has_its_values_at_its_offsets) {
  VtkHdfWriter writer = scene.create(path, 0);
  for (int steps = 1; steps <= 4; ++steps) {
    scene.write_step(writer, steps - 1);
    EXPECT_EQ(writer.steps(), steps);
    scene.expect_only_steps(path, steps);
  }
}

TEST_F(VtkHdf, steps_that_come_by_rows_are_those_that_come_as_a_whole_byte_for_byte) {
  static_cast<void>(scene.create(path, 3));
  const std::string wanted = testing::read_text(path);
  for (const std::size_t rows : {1, 5, 7, 100}) {
    scene.rows_at_once = rows;
    static_cast<void>(scene.create(path, 3));
    EXPECT_TRUE(testing::read_text(path) == wanted) << rows << " rows at once";
    VtkHdfWriter writer = scene.append_to(path, 2);
    scene.write_step(writer, 2);
    EXPECT_TRUE(testing::read_text(path) == wanted) << rows << " rows at once, continued";
  }
}

TEST_F(VtkHdf, rows_that_are_missing_too_many_or_of_other_fields_are_refused) {
  VtkHdfWriter writer = scene.create(path, 1);
  const std::array of_points{FieldKind{"displacement", 3}, FieldKind{"pressure", 1}};
  const std::array of_cells{FieldKind{"stress", 6}, FieldKind{"J", 1}};
  const std::vector<double> values(6 * scene.tets());
  const std::span<const double> all = values;
  const auto points = [&](std::size_t rows) {
    return std::array{Field{"displacement", 3, all.first(3 * rows)}, Field{"pressure", 1, all.first(rows)}};
  };
  const auto cells = [&](std::size_t rows) {
    return std::array{Field{"J", 1, all.first(rows)}, Field{"stress", 6, all.first(6 * rows)}};
  };
  {
    auto step = writer.begin_step(1, of_points, of_cells);
    step.add_points(points(scene.nodes()));
    step.add_cells(cells(scene.tets() - 1));
    expect_error([&] { step.end(); }, path.string(), "a step ends with 11 of 12 rows of its CellData");
  }
  {
    auto step = writer.begin_step(1, of_points, of_cells);
    step.add_points(points(scene.nodes() - 1));
    expect_error([&] { step.add_points(points(2)); }, "2 rows are added to PointData behind 11 of 12");
    expect_error([&] { step.add_cells(points(1)); }, "rows of displacement(3) pressure(1) are added to a step of J(1)");
    expect_error([&] { step.add_cells(std::array{Field{"J", 1, all.first(1)}, Field{"stress", 6, all.first(7)}}); },
                 "\"stress\" has 7 values; there must be 6 for each of 1");
  }
  EXPECT_EQ(writer.steps(), 1);
  scene.expect_steps(path, 1);
  scene.write_step(writer, 1);
  scene.expect_only_steps(path, 2);
}

TEST_F(VtkHdf, file_is_closed_between_steps) {
  VtkHdfWriter writer = scene.create(path, 1);
  EXPECT_EQ(H5Fget_obj_count(H5F_OBJ_ALL, H5F_OBJ_ALL), 0);
  EXPECT_THROW(writer.write_step(1, {}, {}), Error);
  EXPECT_EQ(H5Fget_obj_count(H5F_OBJ_ALL, H5F_OBJ_ALL), 0);
}

TEST_F(VtkHdf, many_steps_are_kept_apart) {
  constexpr int many = 600;  // more than one chunk of offsets, and more than one node of an index, hold
  static_cast<void>(scene.create(path, many));
  scene.expect_only_steps(path, many);
}

TEST_F(VtkHdf, values_beyond_single_precision_are_infinite_and_nan_stays) {
  VtkHdfWriter writer = scene.create(path, 0);
  std::vector<double> values(scene.tets(), 1e-320);
  values[0] = 1e300;
  values[1] = std::numeric_limits<double>::quiet_NaN();
  values[2] = -0.0;
  writer.write_step(0, {}, std::array{Field{"J", 1, values}});
  const std::vector<float> found = H5File(path).values<float>("/VTKHDF/CellData/J");
  EXPECT_EQ(found[0], std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(found[1]));
  EXPECT_TRUE(found[2] == 0 && std::signbit(found[2]));
  EXPECT_EQ(found[3], 0);
}

TEST_F(VtkHdf, fields_of_later_steps_are_those_of_the_first_in_any_order) {
  VtkHdfWriter writer = scene.create(path, 1);
  const auto displacement = Scene::values(1, 0, 3 * scene.nodes()), pressure = Scene::values(1, 1, scene.nodes());
  const auto stress = Scene::values(1, 2, 6 * scene.tets()), volume = Scene::values(1, 3, scene.tets());
  const Field u{"displacement", 3, displacement}, p{"pressure", 1, pressure}, s{"stress", 6, stress}, j{"J", 1, volume};
  const auto step = [&](const std::vector<Field>& points, const std::vector<Field>& cells) {
    return [&writer, points, cells] { writer.write_step(Scene::time(1), points, cells); };
  };
  expect_error(step({u}, {s, j}), "PointData", "displacement(3)", "pressure(1)");
  expect_error(step({u, p}, {s}), "CellData", "J(1)");
  expect_error(step({u, p, {"p2", 1, pressure}}, {s, j}), "p2(1)");
  expect_error(step({u, {"pressure", 3, displacement}}, {s, j}), "pressure(3)");
  expect_error(step({u, {"Pressure", 1, pressure}}, {s, j}), "Pressure(1)");
  scene.expect_only_steps(path, 1);
  step({p, u}, {j, s})();
  scene.expect_only_steps(path, 2);
}

TEST_F(VtkHdf, fields_of_wrong_names_or_sizes_are_refused) {
  VtkHdfWriter writer = scene.create(path, 0);
  const std::vector<double> values(3 * scene.nodes());
  const std::span<const double> all = values;
  const auto step = [&](const std::vector<Field>& fields) {
    return [&writer, fields] { writer.write_step(0, fields, {}); };
  };
  expect_error(step({{"", 3, all}}), path.string(), "name");
  expect_error(step({{"a/b", 3, all}}), "a/b");
  expect_error(step({{"a.b", 3, all}}), "a.b");
  expect_error(step({{"u", 0, all}}), "\"u\" has 0 components");
  expect_error(step({{"u", 2, all}}), "\"u\" has " + std::to_string(all.size()) + " values");
  expect_error(step({{"u", 3, all.first(5)}}), "\"u\" has 5 values");
  expect_error(step({{"u", 3, all}, {"u", 1, all.first(scene.nodes())}}), "two fields", "u");
  EXPECT_EQ(writer.steps(), 0);
  scene.write_step(writer, 0);
  scene.expect_only_steps(path, 1);
}

TEST_F(VtkHdf, triangles_have_groups_that_are_stored_once_and_kept_by_restarts) {
  const std::vector<fem::Face> triangles{{0, 1, 2}, {2, 1, 3}, {5, 4, 3}};
  const std::vector<CellGroup> groups{{"group_a", {1, 0, 1}}, {"group_b", {0, 0, 1}}};
  const ViewedMesh mesh(scene.points, triangles, groups);
  const auto step = [](VtkHdfWriter& writer, int s) {
    const auto volume = Scene::values(s, 3, 3);
    writer.write_step(Scene::time(s), {}, std::array{Field{"J", 1, volume}});
  };
  VtkHdfWriter writer(path, mesh);
  for (int s = 0; s < 4; ++s) step(writer, s);
  for (const int kept : {4, 2}) {
    VtkHdfWriter again = VtkHdfWriter::append_to(path, mesh, kept);
    for (int s = kept; s < 5; ++s) step(again, s);
    const H5File file(path);
    EXPECT_EQ(file.values<std::uint8_t>("/VTKHDF/Types"), std::vector<std::uint8_t>(3, 5));
    EXPECT_EQ(file.values<std::int64_t>("/VTKHDF/Offsets"), (std::vector<std::int64_t>{0, 3, 6, 9}));
    EXPECT_EQ(file.values<std::int64_t>("/VTKHDF/Connectivity"),
              (std::vector<std::int64_t>{0, 1, 2, 2, 1, 3, 5, 4, 3}));
    for (const CellGroup& group : groups) {
      EXPECT_EQ(file.values<std::uint8_t>("/VTKHDF/CellData/" + group.name), group.is_in);
      EXPECT_EQ(file.values<std::int64_t>("/VTKHDF/Steps/CellDataOffsets/" + group.name),
                std::vector<std::int64_t>(5, 0));
    }
    EXPECT_EQ(file.values<std::int64_t>("/VTKHDF/Steps/CellDataOffsets/J"),
              (std::vector<std::int64_t>{0, 3, 6, 9, 12}));
  }
  const std::vector<CellGroup> other{{"group_a", {1, 1, 1}}, {"group_b", {0, 0, 1}}};
  expect_error([&] { static_cast<void>(VtkHdfWriter::append_to(path, {scene.points, triangles, other}, 2)); },
               "another mesh", "3 triangles");
  const std::vector<double> values(3);
  expect_error([&] { VtkHdfWriter(path, mesh).write_step(0, {}, std::array{Field{"group_a", 1, values}}); },
               "has the name of a group");
  for (const CellGroup& wrong : {CellGroup{"a/b", {1, 0, 1}}, CellGroup{"a:b", {1, 0, 1}}, CellGroup{"a", {1, 0}},
                                 CellGroup{"group_a", {1, 0, 1}}}) {
    const std::vector<CellGroup> two{groups[0], wrong};
    expect_error([&] { VtkHdfWriter(path, {scene.points, triangles, two}); }, wrong.name,
                 wrong.name.size() == 3 ? "no usable name"
                 : wrong.name == "a"    ? "of 2 cells"
                                        : "twice");
  }
}

TEST_F(VtkHdf, mesh_without_points_or_tets_is_refused) {
  const std::vector<fem::Point> none;
  const std::vector<fem::Face> no_triangles;
  expect_error([&] { VtkHdfWriter(path, {none, scene.mesh.tets}); }, path.string(), "0 points");
  expect_error([&] { VtkHdfWriter(path, {scene.points, no_triangles}); }, path.string(), "0 triangles");
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(VtkHdf, step_that_was_not_counted_is_overwritten) {
  static_cast<void>(scene.create(path, 3));
  H5File(path, true).set_integer("/VTKHDF/Steps", "NSteps", 2);
  VtkHdfWriter writer = scene.append_to(path, 2);
  EXPECT_EQ(writer.steps(), 2);
  scene.expect_steps(path, 2);
  scene.write_step(writer, 2);
  scene.expect_only_steps(path, 3);
}

TEST_F(VtkHdf, restart_removes_later_steps_and_continues) {
  static_cast<void>(scene.create(path, 4));
  for (const int kept : {4, 2, 1}) {
    VtkHdfWriter writer = scene.append_to(path, kept);
    EXPECT_EQ(writer.steps(), kept);
    scene.expect_only_steps(path, kept);
    expect_error([&] { writer.write_step(1, {}, {}); }, "other PointData");
    for (int s = kept; s < 5; ++s) scene.write_step(writer, s);
    scene.expect_only_steps(path, 5);
  }
}

TEST_F(VtkHdf, restart_after_no_step_begins_anew) {
  static_cast<void>(scene.create(path, 2));
  VtkHdfWriter writer = scene.append_to(path, 0);
  EXPECT_FALSE(H5File(path).has("/VTKHDF/Steps"));
  writer.write_step(0, {}, {});  // other fields than the file had before
}

TEST_F(VtkHdf, restart_refuses_what_it_cannot_continue) {
  expect_error([&] { static_cast<void>(scene.append_to(path, 1)); }, path.string(), "No such file");
  testing::put_text(path, "no HDF5");
  expect_error([&] { static_cast<void>(scene.append_to(path, 1)); }, path.string(), "cannot open it");
  static_cast<void>(scene.create(path, 2));
  expect_error([&] { static_cast<void>(scene.append_to(path, 3)); }, path.string(), "has 2 steps", "after step 3");
  hid_t other = H5Fcreate(in_folder("other.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(other);
  expect_error([&] { static_cast<void>(scene.append_to(in_folder("other.h5"), 1)); },
               "truthcube did not write this file");
  scene.expect_only_steps(path, 2);
}

TEST_F(VtkHdf, restart_refuses_another_mesh) {
  static_cast<void>(scene.create(path, 2));
  Scene larger;
  larger.points.push_back({});
  Scene moved;
  moved.points[3][1] = std::nextafter(moved.points[3][1], 1);
  Scene reordered;
  std::swap(reordered.mesh.tets[0], reordered.mesh.tets[1]);
  for (const Scene* other : {&larger, &moved, &reordered}) {
    expect_error([&] { static_cast<void>(other->append_to(path, 2)); }, path.string(), "another mesh", "12 points");
  }
  scene.expect_only_steps(path, 2);
}

TEST_F(VtkHdf, lock_of_a_viewer_does_not_stop_a_run) {
  VtkHdfWriter writer = scene.create(path, 1);
  const int viewer = ::open(path.c_str(), O_RDONLY);
  ASSERT_EQ(::flock(viewer, LOCK_SH | LOCK_NB), 0);
  scene.write_step(writer, 1);
  ::close(viewer);
  scene.expect_only_steps(path, 2);
}

TEST_F(VtkHdf, folder_that_cannot_be_written_is_named) {
  const testing::ReadOnly read_only(path.parent_path());
  expect_error([&] { static_cast<void>(scene.create(path, 0)); }, path.string(), "cannot create it",
               "Permission denied");
}

}  // namespace
}  // namespace physgen::truthcube
