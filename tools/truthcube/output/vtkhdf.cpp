// The file with its mesh, and what it goes on from; vtkhdf_step.cpp writes steps.
#include <files/disk.h>
#include <hdf5/h5.h>
#include <physgen/error.h>
#include <truthcube/output/vtkhdf.h>
#include <truthcube/output/vtkhdf_names.h>
#include <truthcube/output/xdmf.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace physgen::truthcube {

using vtkhdf::data_group, vtkhdf::in, vtkhdf::require_usable_name, vtkhdf::room_for_array, vtkhdf::room_for_groups,
    vtkhdf::root, vtkhdf::steps_group;

namespace {

using h5::one;

constexpr std::uint8_t vtk_tetra = 10, vtk_triangle = 5;
constexpr std::size_t rows_at_once = std::size_t{1} << 14U;  // of what the mesh does not have as it is stored

/// Writes a new dataset of such rows, some at a time. @param value value(row)
template <class T, class Value>
void write_rows(h5::File& file, const std::string& name, std::size_t rows, const Value& value) {
  file.make_dataset<T>(name, rows);
  std::vector<T> values;
  for (std::size_t first = 0; first < rows; first += rows_at_once) {
    values.resize(std::min(rows_at_once, rows - first));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(first + i);
    file.write_rows(name, first, std::span<const T>(values));
  }
}

std::filesystem::path xdmf_of(std::filesystem::path file) { return file.replace_extension(".xdmf"); }

int count_steps(const h5::File& file) {
  if (!file.has(steps_group)) return 0;
  const auto times = static_cast<std::int32_t>(file.shape(in(steps_group, "Values"))[0]);
  return std::min(file.read_attribute<std::int32_t>(steps_group, "NSteps"), times);
}

}  // namespace

VtkHdfWriter::VtkHdfWriter(Unopened /*as it is*/, std::filesystem::path path, const ViewedMesh& mesh)
    : path_(std::move(path)), corners_of_cell_(mesh.corners_of_cell) {
  require_none_of_others(xdmf_of(path_), path_);
  if (mesh.points.empty() || mesh.cells() == 0) {
    throw Error(path_.string() + ": a mesh of " + in_words(mesh) + " cannot be written; there must be some");
  }
  points_.rows = mesh.points.size();
  cells_.rows = mesh.cells();
  for (const CellGroup& group : mesh.groups) {
    const auto error = [&](const std::string& what) {
      return Error(path_.string() + ": the group \"" + group.name + "\" " + what);
    };
    require_usable_name(group.name, error);
    if (group.is_in.size() != mesh.cells()) {
      throw error("says it of " + std::to_string(group.is_in.size()) + " cells, and there are " +
                  std::to_string(mesh.cells()));
    }
    if (std::ranges::find(cells_.groups, group.name) != cells_.groups.end()) {
      throw error("stands there twice; give each a name of its own");
    }
    cells_.groups.push_back(group.name);
  }
}

VtkHdfWriter::VtkHdfWriter(std::filesystem::path path, const ViewedMesh& mesh)
    : VtkHdfWriter(Unopened(), std::move(path), mesh) {
  const std::size_t cells = mesh.cells();
  const std::uint64_t bytes = mesh.points.size_bytes() + 2 * mesh.corners.size_bytes() +
                              cells * (sizeof(std::int64_t) + 1 + mesh.groups.size()) +
                              mesh.groups.size() * room_for_array;
  h5::File file = h5::File::create(path_, bytes + room_for_groups);
  file.make_group(root);
  file.write_attribute<std::int32_t>(root, "Version", std::array{2, 0});
  file.write_attribute(root, "Type", "UnstructuredGrid");
  file.write_attribute("/", "mesh_hash", one(hash_of(mesh)));
  file.write_dataset<std::int64_t>(in(root, "NumberOfPoints"), one(static_cast<std::int64_t>(mesh.points.size())));
  file.write_dataset<std::int64_t>(in(root, "NumberOfCells"), one(static_cast<std::int64_t>(cells)));
  file.write_dataset<std::int64_t>(in(root, "NumberOfConnectivityIds"),
                                   one(static_cast<std::int64_t>(mesh.corners.size())));
  // Points are arrays without gaps: flat, they are the same bytes.
  file.write_dataset<double>(in(root, "Points"),
                             std::span<const double>(mesh.points.front().data(), 3 * mesh.points.size()), 3);
  file.write_dataset<std::int64_t>(in(root, "Connectivity"), mesh.corners);
  write_rows<std::int64_t>(file, in(root, "Offsets"), cells + 1,
                           [&](std::size_t c) { return static_cast<std::int64_t>(mesh.corners_of_cell * c); });
  write_rows<std::uint8_t>(file, in(root, "Types"), cells,
                           [&](std::size_t /*cell*/) { return mesh.corners_of_cell == 4 ? vtk_tetra : vtk_triangle; });
  if (!mesh.groups.empty()) file.make_group(data_group("Cell"));
  for (const CellGroup& group : mesh.groups) {
    file.write_dataset<std::uint8_t>(in(data_group("Cell"), group.name), std::span<const std::uint8_t>(group.is_in));
  }
  file.close();
  std::error_code is_none;
  std::filesystem::remove(xdmf_of(path_), is_none);  // of another run: its steps are gone
}

std::vector<FieldKind> VtkHdfWriter::kinds_in(const h5::File& file, const Arrays& arrays) {
  std::vector<FieldKind> kinds;
  for (const std::string& name : file.names_in(data_group(arrays.what))) {
    if (std::ranges::find(arrays.groups, name) != arrays.groups.end()) continue;
    const std::vector<hsize_t> shape = file.shape(in(data_group(arrays.what), name));
    kinds.push_back({name, shape.size() == 2 ? static_cast<int>(shape[1]) : 1});
  }
  std::ranges::sort(kinds);
  return kinds;
}

VtkHdfWriter VtkHdfWriter::append_to(std::filesystem::path path, const ViewedMesh& mesh, int steps) {
  if (steps <= 0) return {std::move(path), mesh};
  VtkHdfWriter writer(Unopened(), std::move(path), mesh);
  const h5::File file = h5::File::open(writer.path_, false);
  const std::string name = writer.path_.string();
  if (!file.has_attribute("/", "mesh_hash"))
    throw Error(name + ": truthcube did not write this file, so it cannot continue it");
  if (file.read_attribute<std::uint64_t>("/", "mesh_hash") != hash_of(mesh)) {
    const auto cells = file.shape(in(root, "Types"))[0], corners = file.shape(in(root, "Connectivity"))[0];
    throw Error(name + " holds another mesh, with " +
                in_words(file.shape(in(root, "Points"))[0], cells, corners / cells) + ", than this one of " +
                in_words(mesh));
  }
  const int found = count_steps(file);
  if (found < steps) {
    throw Error(name + " has " + std::to_string(found) + " steps and cannot be continued after step " +
                std::to_string(steps));
  }
  for (Arrays* arrays : {&writer.points_, &writer.cells_}) arrays->kinds = kinds_in(file, *arrays);
  writer.times_ = file.read_rows(in(steps_group, "Values"), 0, static_cast<hsize_t>(steps));
  writer.write_xdmf();  // names no more steps than the old file has, and the new one
  if (found > steps) {
    disk::replace_file(writer.path_, [&](const std::filesystem::path& written) {
      copy_steps(file, VtkHdfWriter(written, mesh), steps);
    });
  }
  return writer;
}

void VtkHdfWriter::copy_steps(const h5::File& file, VtkHdfWriter to, int steps) {
  for (int s = 0; s < steps; ++s) {
    const auto number = static_cast<std::uint64_t>(s);
    const double time = file.read_rows(in(steps_group, "Values"), number, 1).front();
    Step step = to.begin_step(time, kinds_in(file, to.points_), kinds_in(file, to.cells_));
    const auto copy_rows = [&](const Arrays& arrays, auto add) {
      for (std::uint64_t first = 0; first < arrays.rows && !arrays.kinds.empty(); first += rows_at_once) {
        const std::uint64_t rows = std::min<std::uint64_t>(rows_at_once, arrays.rows - first);
        std::vector<std::vector<double>> values;
        std::vector<Field> fields;
        for (const auto& [name, components] : arrays.kinds) {
          values.push_back(file.read_rows(in(data_group(arrays.what), name), number * arrays.rows + first, rows));
          fields.push_back({name, components, values.back()});
        }
        (step.*add)(fields);
      }
    };
    copy_rows(to.points_, &Step::add_points);
    copy_rows(to.cells_, &Step::add_cells);
    step.end_without_xdmf();
  }
}

void VtkHdfWriter::write_xdmf() const {
  std::vector<XdmfArray> all;
  for (const Arrays* arrays : {&points_, &cells_}) {
    for (const auto& [name, components] : arrays->kinds) all.push_back({arrays->what, name, arrays->rows, components});
  }
  disk::write_text(xdmf_of(path_),
                   xdmf_text(path_, {points_.rows, cells_.rows, corners_of_cell_, cells_.groups}, all, times_));
}

}  // namespace physgen::truthcube
