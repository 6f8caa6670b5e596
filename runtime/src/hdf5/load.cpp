// Loading: everything that is asked for is read and held against its checksum before the array changes.
#include <physgen/arrays/array_losses.h>
#include <physgen/arrays/saved_arrays.h>
#include <physgen/error.h>

#include <algorithm>
#include <utility>

#include "../files/host_twin.h"
#include "../files/names.h"
#include "../files/one_field.h"
#include "../host_convert.h"
#include "checksum.h"
#include "stored_fields.h"

namespace physgen {

namespace {

h5::File open(const std::filesystem::path& path) {
  h5::File file = h5::File::open(path, false);
  if (!file.has_attribute("/", "physgen_file"))
    throw Error(path.string() +
                ": is an HDF5 file, but none that physgen::save() wrote: it lacks the attribute physgen_file");
  const auto version = file.read_attribute<std::int32_t>("/", "physgen_file");
  if (version < 1 || version > h5::file_version) {
    throw Error(path.string() + ": is a file of version " + std::to_string(version) + ", written by physgen " +
                file.read_text_attribute("/", "physgen") + "; this library reads version " +
                std::to_string(h5::file_version) + ": load it with that physgen or a newer one");
  }
  return file;
}

std::string elements(const FieldInfo& field) {
  return std::to_string(field.visible_count()) + (field.visible_count() == 1 ? " element" : " elements");
}

/// @throw Error when a field of the file does not fit the one of the array
void require_fit(const std::string& place, const FieldInfo& stored, const std::string& unit, const FieldInfo& field) {
  const auto refuse = [&](const std::string& there, const std::string& here) {
    throw Error(
        place + " " + std::string(field.name) + " has " + there + " in the file and " + here +
        " in the array; load it into an array of the schema that it was saved with, or name the other fields in "
        "load()");
  };
  if (stored.visible_count() != field.visible_count()) refuse(elements(stored), elements(field));
  if (!files::loads_into(stored.type, field.type)) refuse(files::kind_of(stored.type), files::kind_of(field.type));
  if (!unit.empty() && !field.unit.empty() && unit != field.unit)
    refuse("the unit " + unit, "the unit " + std::string(field.unit));
}

/// The dataset of a field.
struct Dataset {
  std::string name;
  std::vector<FieldInfo> fields;  ///< as many as the array has, of which one is stored
  int bytes_of_row;
  h5::Handle type;
};

/// Reads rows, and adds them to the checksum.
void read_rows(const h5::File& file, const Dataset& dataset, index_t begin, index_t end, std::byte* to,
               h5::Checksum& checksum) {
  file.read_raw_rows(dataset.name, dataset.type.id(), static_cast<hsize_t>(begin), static_cast<hsize_t>(end - begin),
                     to);
  checksum.add({to, static_cast<std::size_t>((end - begin) * dataset.bytes_of_row)});
}

bool is_noted(const h5::File& file, const Dataset& dataset, const h5::Checksum& checksum) {
  const std::vector<std::uint64_t> noted = file.read_values_attribute(dataset.name, "checksum");
  return std::equal(noted.begin(), noted.end(), checksum.value().begin(), checksum.value().end());
}

/// @throw Error when the rows of a dataset are not all there, or damaged
void require_rows(const h5::File& file, const std::string& place, const Dataset& dataset, index_t size) {
  const auto refuse = [&](const std::string& why) { throw Error(place + " " + dataset.name + " " + why); };
  if (file.shape(dataset.name)[0] != static_cast<hsize_t>(size))
    refuse("has " + std::to_string(file.shape(dataset.name)[0]) + " rows for " + std::to_string(size) + " objects");
  if (!file.holds_all(dataset.name)) refuse("is not in the file as a whole");
  file.read_ahead(dataset.name);
  h5::Checksum checksum;
  const index_t rows = files::rows_at_once(dataset.bytes_of_row);
  const Buffer block(SpaceKind::host, std::min(rows, size) * dataset.bytes_of_row, place);
  for (index_t begin = 0; begin < size; begin += rows)
    read_rows(file, dataset, begin, std::min(begin + rows, size), block.data(), checksum);
  if (!is_noted(file, dataset, checksum))
    refuse("is damaged: its checksum is another one than was noted when it was saved");
}

}  // namespace

namespace detail {

struct ArrayOfFile::Datasets {
  h5::File file;
  std::vector<Dataset> all;
};

ArrayOfFile::~ArrayOfFile() = default;

ArrayOfFile::ArrayOfFile(const std::filesystem::path& path, const std::string& name, const UntypedArray& form,
                         std::span<const std::string> asked)
    : place_(path.string() + ": '" + name + "'") {
  datasets_ = std::make_unique<Datasets>(Datasets{open(path), {}});
  const h5::File& file = datasets_->file;
  const std::vector<std::string> arrays = file.names_in("/");
  if (std::find(arrays.begin(), arrays.end(), name) == arrays.end())
    throw Error(path.string() + ": has no array '" + name + "'" + files::nearest_first(name, arrays));
  const std::string group = "/" + name;
  if (const std::string object = file.read_text_attribute(group, "object"); object != form.object) {
    throw Error(place_ + " holds objects of the type " + object + ", and the array those of " +
                std::string(form.object) + "; load it into an array of " + object);
  }
  loaded_.objects = static_cast<index_t>(file.read_attribute<std::uint64_t>(group, "count"));
  const std::vector<std::string> stored = file.names_in(group);
  for (const std::string& field : asked) {
    if (!files::has(stored, field))
      throw Error(place_ + " has no field '" + field + "'" + files::nearest_first(field, stored));
  }
  const std::vector<std::string> taken = files::stored_fields(form, asked, place_);
  for (const std::string& field : stored)
    if (asked.empty() && !files::has(taken, field)) loaded_.left_out.push_back(field);
  for (std::size_t f = 0; f < form.fields.size(); ++f) {
    const FieldInfo& field = form.fields[f];
    if (!field.is_stored() || (!asked.empty() && !files::has(asked, field.name))) continue;
    if (!files::has(stored, field.name)) {
      loaded_.kept.emplace_back(field.name);
      continue;
    }
    const std::string dataset = group + "/" + std::string(field.name);
    FieldInfo in_file = h5::read_form(file, place_, dataset);
    require_fit(place_, in_file, h5::read_unit(file, dataset), field);
    in_file.name = field.name;
    in_file.in_double = field.in_double;
    Dataset found{dataset, files::only(form.fields, f, in_file), in_file.count * element_bytes(in_file.type),
                  h5::type_of(in_file.type)};
    require_rows(file, place_, found, loaded_.objects);
    datasets_->all.push_back(std::move(found));
    loaded_.fields.emplace_back(field.name);
  }
  if (datasets_->all.empty() && !(stored.empty() && taken.empty())) {
    throw Error(place_ + " has no field in common with the array" + files::nearest_first("", stored) +
                "; load it into an array of the schema that it was saved with");
  }
}

void ArrayOfFile::give(const UntypedArray& to, bool check) const {
  if (to.size != loaded_.objects) {
    throw Error(place_ + " has " + std::to_string(loaded_.objects) + " objects, and the array " +
                std::to_string(to.size) + ": resize it");
  }
  if (to.size == 0) return;
  const h5::File& file = datasets_->file;
  const auto part = [&](const Dataset& dataset, std::byte* rows, index_t size) {
    return UntypedArray{rows, size, size, 1, dataset.bytes_of_row, SpaceKind::host, to.object, dataset.fields};
  };
  int widest = 0;
  for (const Dataset& dataset : datasets_->all) widest = std::max(widest, dataset.bytes_of_row);
  const index_t rows = check ? to.size : std::min(files::rows_at_once(std::max(to.record_bytes, 1)), to.size);
  const Buffer block(SpaceKind::host, rows * widest, place_);
  for (const Dataset& dataset : datasets_->all) {
    if (!check) break;
    h5::Checksum ignored;
    read_rows(file, dataset, 0, to.size, block.data(), ignored);
    throw_if_falsified(count_on_host(to, part(dataset, block.data(), to.size), 0, to.size), to);
  }
  const HostTwin twin(to);
  std::vector<h5::Checksum> checksums(datasets_->all.size());
  for (index_t begin = 0; begin < to.size; begin += rows) {
    const index_t end = std::min(begin + rows, to.size);
    for (std::size_t d = 0; d < checksums.size(); ++d) {
      const Dataset& dataset = datasets_->all[d];
      read_rows(file, dataset, begin, end, block.data(), checksums[d]);
      convert_on_host(twin.array(), 0, part(dataset, block.data(), end - begin), begin, begin, end);
    }
  }
  for (std::size_t d = 0; d < checksums.size(); ++d) {
    if (!is_noted(file, datasets_->all[d], checksums[d])) {
      throw Error(place_ + " " + datasets_->all[d].name +
                  " was changed while it was loaded, and the array holds a part of it: load it again");
    }
  }
  twin.copy_back(to);
}

}  // namespace detail

}  // namespace physgen
