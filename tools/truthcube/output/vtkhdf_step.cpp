// A step counts once Steps/NSteps and Steps/Values have it. Datasets may be longer than that: the next step overwrites
// the rest. Nothing is ever taken out of a file, since HDF5 cuts a file off before it notes the new end. Viewers read
// all of Steps/Values into memory for NSteps times, so Values grows last: it is never longer than that.
#include <files/disk.h>
#include <hdf5/h5.h>
#include <physgen/error.h>
#include <truthcube/output/vtkhdf.h>
#include <truthcube/output/vtkhdf_names.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace physgen::truthcube {

using vtkhdf::data_group, vtkhdf::first_steps_group, vtkhdf::in, vtkhdf::offsets_group, vtkhdf::step_offsets,
    vtkhdf::steps_group;

namespace {

using h5::one;

constexpr hsize_t steps_per_chunk = 512;

// One chunk per step where HDF5 can: a chunk has less than 4 GiB.
hsize_t chunk_rows(std::uint64_t rows, int components) {
  const std::uint64_t most =
      std::numeric_limits<std::uint32_t>::max() / (sizeof(float) * static_cast<unsigned>(components));
  return std::min(rows, most);
}

// A dataset of 1 component has 1 dimension.
hsize_t columns(int components) { return components == 1 ? 0 : static_cast<hsize_t>(components); }

std::vector<FieldKind> kinds_of(std::span<const Field> fields) {
  std::vector<FieldKind> kinds;
  for (const Field& field : fields) kinds.push_back({field.name, field.components});
  return kinds;
}

std::string list(const std::vector<FieldKind>& all) {
  std::string text;
  for (const FieldKind& kind : all) text += " " + kind.name + "(" + std::to_string(kind.components) + ")";
  return text.empty() ? " none" : text;
}

}  // namespace

std::vector<FieldKind> VtkHdfWriter::checked_kinds(const Arrays& arrays, std::span<const FieldKind> given) const {
  for (const FieldKind& kind : given) {
    const auto error = [&](const std::string& what) {
      return Error(path_.string() + ": " + arrays.what + "Data \"" + kind.name + "\" " + what);
    };
    vtkhdf::require_usable_name(kind.name, error);
    if (std::ranges::find(arrays.groups, kind.name) != arrays.groups.end()) {
      throw error("has the name of a group; give it another");
    }
    if (kind.components < 1) throw error("has " + std::to_string(kind.components) + " components");
  }
  std::vector<FieldKind> kinds(given.begin(), given.end());
  std::ranges::sort(kinds);
  for (std::size_t i = 1; i < kinds.size(); ++i) {
    if (kinds[i].name == kinds[i - 1].name) throw Error(path_.string() + ": two fields have the name " + kinds[i].name);
  }
  if (steps() > 0 && kinds != arrays.kinds) {
    throw Error(path_.string() + ": step " + std::to_string(steps() + 1) + " has other " + arrays.what +
                "Data than those before:" + list(kinds) + " instead of" + list(arrays.kinds));
  }
  return kinds;
}

void VtkHdfWriter::require_rows(const Arrays& arrays, std::span<const Field> fields, std::uint64_t rows) const {
  for (const Field& field : fields) {
    if (field.values.size() == rows * static_cast<unsigned>(field.components)) continue;
    throw Error(path_.string() + ": " + arrays.what + "Data \"" + field.name + "\" has " +
                std::to_string(field.values.size()) + " values; there must be " + std::to_string(field.components) +
                " for each of " + std::to_string(rows));
  }
}

std::uint64_t VtkHdfWriter::bytes_of_step() const {
  std::uint64_t bytes = vtkhdf::room_for_groups;
  for (const Arrays* arrays : {&points_, &cells_}) {
    for (const FieldKind& kind : arrays->kinds) {
      bytes += vtkhdf::room_for_array + arrays->rows * static_cast<unsigned>(kind.components) * sizeof(float);
    }
  }
  return bytes;
}

void VtkHdfWriter::write_step(double time, std::span<const Field> point_fields, std::span<const Field> cell_fields) {
  const std::vector<FieldKind> of_points = checked_kinds(points_, kinds_of(point_fields)),
                               of_cells = checked_kinds(cells_, kinds_of(cell_fields));
  require_rows(points_, point_fields, points_.rows);
  require_rows(cells_, cell_fields, cells_.rows);
  Step step = begin_step(time, of_points, of_cells);
  step.add_points(point_fields);
  step.add_cells(cell_fields);
  step.end();
}

VtkHdfWriter::Step VtkHdfWriter::begin_step(double time, std::span<const FieldKind> of_points,
                                            std::span<const FieldKind> of_cells) {
  std::vector<FieldKind> point_kinds = checked_kinds(points_, of_points);
  cells_.kinds = checked_kinds(cells_, of_cells);
  points_.kinds = std::move(point_kinds);
  disk::reserve_space(path_, bytes_of_step());
  return {*this, time};
}

VtkHdfWriter::Step::Step(VtkHdfWriter& writer, double time)
    : writer_(&writer), time_(time), file_(std::make_unique<h5::File>(h5::File::open(writer.path_, true))) {
  if (writer.steps() == 0) make_datasets(first_steps_group);
}
VtkHdfWriter::Step::Step(Step&&) noexcept = default;
VtkHdfWriter::Step::~Step() = default;

void VtkHdfWriter::Step::make_datasets(const std::string& group) {
  h5::File& file = *file_;
  for (const std::string& name : {group, data_group("Point"), data_group("Cell")}) {
    if (!file.has(name)) file.make_group(name);
  }
  file.make_growing<double>(in(group, "Values"), steps_per_chunk);
  file.make_growing<std::int64_t>(in(group, "NumberOfParts"), steps_per_chunk);
  for (const std::string offsets : step_offsets) {
    const bool per_topology = offsets == "CellOffsets" || offsets == "ConnectivityIdOffsets";
    file.make_growing<std::int64_t>(in(group, offsets), steps_per_chunk, per_topology ? 1 : 0);
  }
  for (const Arrays* arrays : {&writer_->points_, &writer_->cells_}) {
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

void VtkHdfWriter::Step::add_points(std::span<const Field> fields) { add(writer_->points_, points_done_, fields); }
void VtkHdfWriter::Step::add_cells(std::span<const Field> fields) { add(writer_->cells_, cells_done_, fields); }

void VtkHdfWriter::Step::add(const Arrays& arrays, std::uint64_t& done, std::span<const Field> fields) {
  std::vector<FieldKind> kinds = kinds_of(fields);
  std::ranges::sort(kinds);
  if (kinds != arrays.kinds) {
    throw Error(writer_->path_.string() + ": rows of" + list(kinds) + " are added to a step of" + list(arrays.kinds));
  }
  if (fields.empty()) return;
  const std::uint64_t rows = fields.front().values.size() / static_cast<unsigned>(fields.front().components);
  writer_->require_rows(arrays, fields, rows);
  if (rows > arrays.rows - done) {
    throw Error(writer_->path_.string() + ": " + std::to_string(rows) + " rows are added to " + arrays.what +
                "Data behind " + std::to_string(done) + " of " + std::to_string(arrays.rows));
  }
  if (rows == 0) return;
  const std::uint64_t first = static_cast<std::uint64_t>(writer_->steps()) * arrays.rows + done;
  for (const FieldKind& kind : arrays.kinds) {  // in an order that a copy has, too
    const Field& field = *std::ranges::find(fields, kind.name, &Field::name);
    file_->write_rows(in(data_group(arrays.what), field.name), first, field.values);
  }
  done += rows;
}

void VtkHdfWriter::Step::end() {
  end_without_xdmf();
  writer_->write_xdmf();
}

void VtkHdfWriter::Step::end_without_xdmf() {
  h5::File& file = *file_;
  const auto step = static_cast<hsize_t>(writer_->steps());
  const std::string group = step == 0 ? first_steps_group : steps_group;
  for (const auto& [arrays, done] :
       {std::pair{&writer_->points_, points_done_}, std::pair{&writer_->cells_, cells_done_}}) {
    if (done < arrays->rows && !arrays->kinds.empty()) {
      throw Error(writer_->path_.string() + ": a step ends with " + std::to_string(done) + " of " +
                  std::to_string(arrays->rows) + " rows of its " + arrays->what + "Data");
    }
    const auto offset = static_cast<std::int64_t>(step * arrays->rows);
    for (const FieldKind& kind : arrays->kinds) {
      file.write_rows(in(offsets_group(group, arrays->what), kind.name), step, one(offset));
    }
    for (const std::string& name : arrays->groups) {
      file.write_rows(in(offsets_group(group, arrays->what), name), step, one<std::int64_t>(0));
    }
  }
  for (const char* offsets : step_offsets) file.write_rows(in(group, offsets), step, one<std::int64_t>(0));
  file.write_rows(in(group, "NumberOfParts"), step, one<std::int64_t>(1));
  file.flush();

  file.write_attribute(group, "NSteps", one<std::int32_t>(writer_->steps() + 1));
  file.flush();
  file.write_rows(in(group, "Values"), step, one(time_));
  if (step == 0) file.rename(first_steps_group, steps_group);
  file.close();
  writer_->times_.push_back(time_);
}

}  // namespace physgen::truthcube
