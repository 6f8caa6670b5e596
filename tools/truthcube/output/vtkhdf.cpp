// A step counts once Steps/NSteps and Steps/Values have it. Datasets may be longer than that: the next step overwrites
// the rest. Nothing is ever taken out of a file, since HDF5 cuts a file off before it notes the new end. Viewers read
// all of Steps/Values into memory for NSteps times, so Values grows last: it is never longer than that.
#include <files/disk.h>
#include <hdf5/h5.h>
#include <physgen/error.h>
#include <truthcube/output/vtkhdf.h>
#include <truthcube/output/xdmf.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string_view>

namespace physgen::truthcube {

namespace {

using h5::one;

constexpr const char* root = "/VTKHDF";
constexpr const char* steps_group = "/VTKHDF/Steps";
constexpr const char* first_steps_group =
    "/Steps of the first step";  // moved to steps_group when the first step is done
constexpr std::array step_offsets{"PartOffsets", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"};
constexpr std::uint8_t vtk_tetra = 10, vtk_triangle = 5;
constexpr hsize_t steps_per_chunk = 512;
constexpr std::uint64_t room_for_groups = std::uint64_t{1} << 19U;  // groups, attributes, indices, values per step
constexpr std::uint64_t room_for_array = std::uint64_t{1} << 16U;   // the same for one field

// The name of something in a group.
std::string in(std::string group, std::string_view name) {
  group += '/';
  group += name;
  return group;
}

std::string data_group(const std::string& what) { return in(root, what + "Data"); }
std::string offsets_group(const std::string& steps, const std::string& what) { return in(steps, what + "DataOffsets"); }

// One chunk per step where HDF5 can: a chunk has less than 4 GiB.
hsize_t chunk_rows(std::uint64_t rows, int components) {
  const std::uint64_t most =
      std::numeric_limits<std::uint32_t>::max() / (sizeof(float) * static_cast<unsigned>(components));
  return std::min(rows, most);
}

// A dataset of 1 component has 1 dimension.
hsize_t columns(int components) { return components == 1 ? 0 : static_cast<hsize_t>(components); }

void require_usable(const std::string& name, const std::function<Error(const std::string&)>& error) {
  if (name.empty() || name.find_first_of("/.|:") != std::string::npos) {  // | and : part what the XDMF file names
    throw error("has no usable name: a name is not empty and has no '/', '.', '|' and ':'");
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
    require_usable(group.name, error);
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
  std::vector<std::int64_t> first_corner(cells + 1);
  for (std::size_t c = 0; c <= cells; ++c) first_corner[c] = static_cast<std::int64_t>(mesh.corners_of_cell * c);
  file.write_dataset<std::int64_t>(in(root, "Offsets"), std::span<const std::int64_t>(first_corner));
  const std::vector<std::uint8_t> types(cells, mesh.corners_of_cell == 4 ? vtk_tetra : vtk_triangle);
  file.write_dataset<std::uint8_t>(in(root, "Types"), std::span<const std::uint8_t>(types));
  if (!mesh.groups.empty()) file.make_group(data_group("Cell"));
  for (const CellGroup& group : mesh.groups) {
    file.write_dataset<std::uint8_t>(in(data_group("Cell"), group.name), std::span<const std::uint8_t>(group.is_in));
  }
  file.close();
  std::error_code is_none;
  std::filesystem::remove(xdmf_of(path_), is_none);  // of another run: its steps are gone
}

std::vector<VtkHdfWriter::Arrays::Kind> VtkHdfWriter::kinds_in(const h5::File& file, const Arrays& arrays) {
  std::vector<Arrays::Kind> kinds;
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
    const auto step = static_cast<hsize_t>(s);
    std::vector<std::vector<double>> values;
    const auto fields_of = [&](const Arrays& arrays) {
      std::vector<Field> fields;
      for (const auto& [name, components] : kinds_in(file, arrays)) {
        values.push_back(file.read_rows(in(data_group(arrays.what), name), step * arrays.rows, arrays.rows));
        fields.push_back({name, components, values.back()});
      }
      return fields;
    };
    const double time = file.read_rows(in(steps_group, "Values"), step, 1).front();
    const std::vector<Field> points = fields_of(to.points_);
    to.append_step(time, points, fields_of(to.cells_));
  }
}

std::vector<VtkHdfWriter::Arrays::Kind> VtkHdfWriter::checked_kinds(const Arrays& arrays,
                                                                    std::span<const Field> fields) const {
  const auto error = [&](const Field& field, const std::string& what) {
    return Error(path_.string() + ": " + arrays.what + "Data \"" + field.name + "\" " + what);
  };
  std::vector<Arrays::Kind> kinds;
  for (const Field& field : fields) {
    require_usable(field.name, [&](const std::string& what) { return error(field, what); });
    if (std::ranges::find(arrays.groups, field.name) != arrays.groups.end()) {
      throw error(field, "has the name of a group; give it another");
    }
    if (field.components < 1) throw error(field, "has " + std::to_string(field.components) + " components");
    const std::uint64_t expected = arrays.rows * static_cast<unsigned>(field.components);
    if (field.values.size() != expected) {
      throw error(field, "has " + std::to_string(field.values.size()) + " values; there must be " +
                             std::to_string(field.components) + " for each of " + std::to_string(arrays.rows));
    }
    kinds.push_back({field.name, field.components});
  }
  std::ranges::sort(kinds);
  for (std::size_t i = 1; i < kinds.size(); ++i) {
    if (kinds[i].name == kinds[i - 1].name) throw Error(path_.string() + ": two fields have the name " + kinds[i].name);
  }
  if (steps() > 0 && kinds != arrays.kinds) {
    const auto list = [](const std::vector<Arrays::Kind>& all) {
      std::string text;
      for (const Arrays::Kind& kind : all) text += " " + kind.name + "(" + std::to_string(kind.components) + ")";
      return text.empty() ? " none" : text;
    };
    throw Error(path_.string() + ": step " + std::to_string(steps() + 1) + " has other " + arrays.what +
                "Data than those before:" + list(kinds) + " instead of" + list(arrays.kinds));
  }
  return kinds;
}

std::uint64_t VtkHdfWriter::bytes_of_step() const {
  std::uint64_t bytes = room_for_groups;
  for (const Arrays* arrays : {&points_, &cells_}) {
    for (const Arrays::Kind& kind : arrays->kinds) {
      bytes += room_for_array + arrays->rows * static_cast<unsigned>(kind.components) * sizeof(float);
    }
  }
  return bytes;
}

void VtkHdfWriter::write_xdmf() const {
  std::vector<XdmfArray> all;
  for (const Arrays* arrays : {&points_, &cells_}) {
    for (const auto& [name, components] : arrays->kinds) all.push_back({arrays->what, name, arrays->rows, components});
  }
  disk::write_text(xdmf_of(path_),
                   xdmf_text(path_, {points_.rows, cells_.rows, corners_of_cell_, cells_.groups}, all, times_));
}

void VtkHdfWriter::write_step(double time, std::span<const Field> point_fields, std::span<const Field> cell_fields) {
  append_step(time, point_fields, cell_fields);
  write_xdmf();
}

void VtkHdfWriter::append_step(double time, std::span<const Field> point_fields, std::span<const Field> cell_fields) {
  std::vector<Arrays::Kind> point_kinds = checked_kinds(points_, point_fields);
  cells_.kinds = checked_kinds(cells_, cell_fields);
  points_.kinds = std::move(point_kinds);
  disk::reserve_space(path_, bytes_of_step());
  h5::File file = h5::File::open(path_, true);

  const bool first = steps() == 0;
  const std::string group = first ? first_steps_group : steps_group;
  if (first) {
    for (const std::string& name : {group, data_group("Point"), data_group("Cell")}) {
      if (!file.has(name)) file.make_group(name);
    }
    file.make_growing<double>(in(group, "Values"), steps_per_chunk);
    file.make_growing<std::int64_t>(in(group, "NumberOfParts"), steps_per_chunk);
    for (const std::string offsets : step_offsets) {
      const bool per_topology = offsets == "CellOffsets" || offsets == "ConnectivityIdOffsets";
      file.make_growing<std::int64_t>(in(group, offsets), steps_per_chunk, per_topology ? 1 : 0);
    }
    for (const Arrays* arrays : {&points_, &cells_}) {
      file.make_group(offsets_group(group, arrays->what));
      for (const auto& [name, components] : arrays->kinds) {
        file.make_growing<float>(in(data_group(arrays->what), name), chunk_rows(arrays->rows, components),
                                 columns(components));
        file.make_growing<std::int64_t>(in(offsets_group(group, arrays->what), name), steps_per_chunk);
      }
      for (const std::string& name : arrays->groups) {
        file.make_growing<std::int64_t>(in(offsets_group(group, arrays->what), name), steps_per_chunk);
      }
    }
  }

  const auto step = static_cast<hsize_t>(steps());
  const auto write_fields = [&](const Arrays& arrays, std::span<const Field> fields) {
    const auto offset = static_cast<std::int64_t>(step * arrays.rows);
    for (const Field& field : fields) {
      file.write_rows(in(data_group(arrays.what), field.name), step * arrays.rows, field.values);
      file.write_rows(in(offsets_group(group, arrays.what), field.name), step, one(offset));
    }
    for (const std::string& name : arrays.groups) {
      file.write_rows(in(offsets_group(group, arrays.what), name), step, one<std::int64_t>(0));
    }
  };
  write_fields(points_, point_fields);
  write_fields(cells_, cell_fields);
  for (const char* offsets : step_offsets) file.write_rows(in(group, offsets), step, one<std::int64_t>(0));
  file.write_rows(in(group, "NumberOfParts"), step, one<std::int64_t>(1));
  file.flush();

  file.write_attribute(group, "NSteps", one<std::int32_t>(steps() + 1));
  file.flush();
  file.write_rows(in(group, "Values"), step, one(time));
  if (first) file.rename(first_steps_group, steps_group);
  file.close();
  times_.push_back(time);
}

}  // namespace physgen::truthcube
