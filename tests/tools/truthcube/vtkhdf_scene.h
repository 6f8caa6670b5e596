// A small mesh with fields over steps, and what a file that has some of the steps must say.
#pragma once

#include <fem/mesh/mesh.h>
#include <truthcube/output/vtkhdf.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "h5_read.h"

namespace physgen::truthcube::testing {

struct Scene {
  fem::TetMesh mesh = fem::make_box_mesh(2, 1, 1);
  std::vector<fem::Point> points = std::vector<fem::Point>(static_cast<std::size_t>(mesh.nodes));

  Scene() {
    for (std::size_t n = 0; n < points.size(); ++n) {
      const auto x = static_cast<double>(n);
      points[n] = {0.1 * x, -1 / (1 + x), x * x};
    }
  }

  [[nodiscard]] std::size_t nodes() const { return points.size(); }
  [[nodiscard]] std::size_t tets() const { return mesh.tets.size(); }

  /// Different for each step, field and place, and mostly no floats.
  [[nodiscard]] static std::vector<double> values(int step, int field, std::size_t count) {
    std::vector<double> v(count);
    for (std::size_t i = 0; i < count; ++i) v[i] = 1000 * step + 100 * field + 0.1 * static_cast<double>(i) + 0.01;
    return v;
  }
  [[nodiscard]] static double time(int step) { return 0.05 * (step + 1); }

  /// How many rows come at once where the step does not come as a whole.
  std::size_t rows_at_once = 0;

  void write_step(VtkHdfWriter& writer, int step) const {
    const auto displacement = values(step, 0, 3 * nodes()), pressure = values(step, 1, nodes());
    const auto stress = values(step, 2, 6 * tets()), volume = values(step, 3, tets());
    const std::array at_points{Field{"displacement", 3, displacement}, Field{"pressure", 1, pressure}};
    const std::array in_cells{Field{"stress", 6, stress}, Field{"J", 1, volume}};
    if (rows_at_once == 0) return writer.write_step(time(step), at_points, in_cells);
    const auto kind = [](const Field& field) { return FieldKind{field.name, field.components}; };
    const std::array of_points{kind(at_points[0]), kind(at_points[1])}, of_cells{kind(in_cells[0]), kind(in_cells[1])};
    VtkHdfWriter::Step by_rows = writer.begin_step(time(step), of_points, of_cells);
    each_rows(at_points, nodes(), [&](std::span<const Field> rows) { by_rows.add_points(rows); });
    each_rows(in_cells, tets(), [&](std::span<const Field> rows) { by_rows.add_cells(rows); });
    by_rows.end();
  }
  /// Calls add() with some rows at a time, whose memory has other numbers afterwards.
  template <class Add>
  void each_rows(std::span<const Field> fields, std::size_t count, const Add& add) const {
    for (std::size_t first = 0; first < count; first += rows_at_once) {
      std::vector<std::vector<double>> windows;
      std::vector<Field> rows;
      for (const Field& field : fields) {
        const auto columns = static_cast<std::size_t>(field.components);
        const auto part = field.values.subspan(columns * first, columns * std::min(rows_at_once, count - first));
        windows.emplace_back(part.begin(), part.end());
        rows.push_back({field.name, field.components, windows.back()});
      }
      add(std::span<const Field>(rows));
      for (auto& window : windows) std::ranges::fill(window, std::numeric_limits<double>::quiet_NaN());
    }
  }

  [[nodiscard]] VtkHdfWriter create(const std::filesystem::path& path, int steps) const {
    VtkHdfWriter writer(path, {points, mesh.tets});
    for (int s = 0; s < steps; ++s) write_step(writer, s);
    return writer;
  }
  [[nodiscard]] VtkHdfWriter append_to(const std::filesystem::path& path, int steps) const {
    return VtkHdfWriter::append_to(path, {points, mesh.tets}, steps);
  }

  void expect_field(const H5File& file, const std::string& kind, const std::string& name, int field, int components,
                    std::size_t rows, int steps) const {
    const std::size_t count = rows * static_cast<std::size_t>(components);
    // No more than these rows: those of a step that was not finished may lie behind the file's end.
    const std::vector<float> found =
        file.values<float>("/VTKHDF/" + kind + "Data/" + name, rows * static_cast<std::size_t>(steps));
    ASSERT_GE(found.size(), count * static_cast<std::size_t>(steps)) << name;
    const std::vector<hsize_t> shape = file.shape("/VTKHDF/" + kind + "Data/" + name);
    EXPECT_EQ(shape.size(), components == 1 ? 1U : 2U) << name;
    EXPECT_EQ(shape.size() == 2 ? shape[1] : 1, static_cast<hsize_t>(components)) << name;
    const std::vector<std::int64_t> offsets =
        file.values<std::int64_t>("/VTKHDF/Steps/" + kind + "DataOffsets/" + name);
    ASSERT_GE(offsets.size(), static_cast<std::size_t>(steps)) << name;
    for (int s = 0; s < steps; ++s) {
      const auto step = static_cast<std::size_t>(s);
      EXPECT_EQ(offsets[step], static_cast<std::int64_t>(rows * step)) << name;
      const std::vector<double> expected = values(s, field, count);
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_EQ(found[count * step + i], static_cast<float>(expected[i]))
            << name << ", step " << s << ", value " << i;
      }
    }
  }

  /// Whether the first `steps` steps are there, complete; the file may have parts of a later one.
  void expect_steps(const std::filesystem::path& path, int steps) const { expect_steps(H5File(path), steps); }
  void expect_steps(const H5File& file, int steps) const {
    ASSERT_TRUE(file.has("/VTKHDF/Steps"));
    const auto count = static_cast<std::size_t>(steps);
    for (const char* name : {"PartOffsets", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets", "NumberOfParts"}) {
      const std::vector<std::int64_t> found = file.values<std::int64_t>(std::string("/VTKHDF/Steps/") + name);
      ASSERT_GE(found.size(), count) << name;
      for (std::size_t s = 0; s < count; ++s) EXPECT_EQ(found[s], std::string(name) == "NumberOfParts" ? 1 : 0) << name;
    }
    const std::vector<double> times = file.values<double>("/VTKHDF/Steps/Values");
    ASSERT_GE(times.size(), count);
    for (int s = 0; s < steps; ++s) EXPECT_EQ(times[static_cast<std::size_t>(s)], time(s));
    expect_field(file, "Point", "displacement", 0, 3, nodes(), steps);
    expect_field(file, "Point", "pressure", 1, 1, nodes(), steps);
    expect_field(file, "Cell", "stress", 2, 6, tets(), steps);
    expect_field(file, "Cell", "J", 3, 1, tets(), steps);
  }

  /// Whether the file has these steps and no more.
  void expect_only_steps(const std::filesystem::path& path, int steps) const {
    const H5File file(path);  // once: most of a test's time is opening files
    expect_steps(file, steps);
    const auto count = static_cast<hsize_t>(steps);
    EXPECT_EQ(file.integers("/VTKHDF/Steps", "NSteps"), std::vector{steps});
    for (const char* name : {"PartOffsets", "PointOffsets", "NumberOfParts", "Values", "PointDataOffsets/displacement",
                             "PointDataOffsets/pressure", "CellDataOffsets/stress", "CellDataOffsets/J"}) {
      EXPECT_EQ(file.shape(std::string("/VTKHDF/Steps/") + name), std::vector{count}) << name;
    }
    for (const char* name : {"CellOffsets", "ConnectivityIdOffsets"}) {
      EXPECT_EQ(file.shape(std::string("/VTKHDF/Steps/") + name), (std::vector<hsize_t>{count, 1})) << name;
    }
    EXPECT_EQ(file.shape("/VTKHDF/PointData/displacement"), (std::vector<hsize_t>{count * nodes(), 3}));
    EXPECT_EQ(file.shape("/VTKHDF/PointData/pressure"), std::vector{count * nodes()});
    EXPECT_EQ(file.shape("/VTKHDF/CellData/stress"), (std::vector<hsize_t>{count * tets(), 6}));
    EXPECT_EQ(file.shape("/VTKHDF/CellData/J"), std::vector{count * tets()});
  }
};

}  // namespace physgen::truthcube::testing
