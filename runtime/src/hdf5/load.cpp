// Loading: everything that is asked for is read and held against its checksum before an array changes that is in use.
#include <physgen/arrays/array_losses.h>
#include <physgen/arrays/saved_arrays.h>
#include <physgen/error.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "../files/blocks.h"
#include "../files/host_twin.h"
#include "../files/names.h"
#include "../files/one_field.h"
#include "../host_convert.h"
#include "checksum.h"
#include "raw_rows.h"
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
  h5::RawRows rows;
  std::vector<std::uint64_t> checksum;  ///< that was noted

  [[nodiscard]] index_t bytes_of_row() const { return static_cast<index_t>(rows.bytes_of_row()); }
};

/// @throw Error when not all rows of a dataset are there
void require_rows(const h5::File& file, const std::string& place, const std::string& dataset, index_t size) {
  const auto refuse = [&](const std::string& why) { throw Error(place + " " + dataset + " " + why); };
  if (file.shape(dataset)[0] != static_cast<hsize_t>(size))
    refuse("has " + std::to_string(file.shape(dataset)[0]) + " rows for " + std::to_string(size) + " objects");
  if (!file.holds_all(dataset)) refuse("is not in the file as a whole");
}

/// Reads all rows, on all threads, and calls visit(dataset, begin, end, rows) for those of objects begin .. end-1.
/// @param bytes_of_record of the array that gets the objects
/// @return the first dataset whose checksum is not the one that was noted; else null
template <class Visit>
const Dataset* read_all(const std::vector<Dataset>& datasets, index_t size, int bytes_of_record,
                        const std::string& place, const Visit& visit) {
  constexpr index_t blocks_ahead = 64;
  const index_t rows = files::rows_of_block(bytes_of_record), blocks = files::blocks_of(size, rows);
  index_t widest = 0;
  for (const Dataset& dataset : datasets) widest = std::max(widest, dataset.bytes_of_row());
  std::vector<h5::Checksum> checksums(static_cast<std::size_t>(blocks) * datasets.size());
  const auto read_ahead = [&](index_t block) {
    for (const Dataset& dataset : datasets)
      dataset.rows.read_ahead(static_cast<hsize_t>(block * rows), static_cast<hsize_t>(blocks_ahead * rows));
  };
  read_ahead(0);
  files::for_blocks(blocks, std::min(rows, size) * widest, place, [&](index_t b, std::byte* memory) {
    if (b % blocks_ahead == 0) read_ahead(b + blocks_ahead);
    const index_t begin = b * rows, end = std::min(begin + rows, size);
    for (std::size_t d = 0; d < datasets.size(); ++d) {
      const Dataset& dataset = datasets[d];
      dataset.rows.read(static_cast<hsize_t>(begin), static_cast<hsize_t>(end - begin), memory);
      checksums[static_cast<std::size_t>(b) * datasets.size() + d] =
          h5::Checksum({memory, static_cast<std::size_t>((end - begin) * dataset.bytes_of_row())});
      visit(dataset, begin, end, memory);
    }
  });
  for (std::size_t d = 0; d < datasets.size(); ++d) {
    h5::Checksum whole;
    for (std::size_t at = d; at < checksums.size(); at += datasets.size()) whole.append(checksums[at]);
    if (!std::ranges::equal(datasets[d].checksum, whole.value())) return &datasets[d];
  }
  return nullptr;
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
    require_rows(file, place_, dataset, loaded_.objects);
    datasets_->all.push_back({dataset, files::only(form.fields, f, in_file),
                              h5::RawRows(file, dataset, h5::type_of(in_file.type).id()),
                              file.read_values_attribute(dataset, "checksum")});
    loaded_.fields.emplace_back(field.name);
  }
  if (datasets_->all.empty() && !(stored.empty() && taken.empty())) {
    throw Error(place_ + " has no field in common with the array" + files::nearest_first("", stored) +
                "; load it into an array of the schema that it was saved with");
  }
}

void ArrayOfFile::give(const UntypedArray& to, Target target, bool check) const {
  if (to.size != loaded_.objects) {
    throw Error(place_ + " has " + std::to_string(loaded_.objects) + " objects, and the array " +
                std::to_string(to.size) + ": resize it");
  }
  const HostTwin twin(to);
  // What an Error need not leave as it was gets the objects while they are read for the first time.
  const bool at_once = target == Target::spare || twin.is_copy();
  const auto part = [&](const Dataset& dataset, std::byte* rows, index_t size) {
    return UntypedArray{rows,      size,          size, 1, static_cast<int>(dataset.bytes_of_row()), SpaceKind::host,
                        to.object, dataset.fields};
  };
  const auto convert = [&](const Dataset& dataset, index_t begin, index_t end, std::byte* rows) {
    convert_on_host(twin.array(), 0, part(dataset, rows, end - begin), begin, begin, end);
  };
  Losses losses;
  std::mutex adding;
  const Dataset* other = read_all(datasets_->all, to.size, to.record_bytes, place_,
                                  [&](const Dataset& dataset, index_t begin, index_t end, std::byte* rows) {
                                    if (check) {
                                      const Losses of_part =
                                          count_on_host(to, part(dataset, rows, end - begin), 0, end - begin);
                                      const std::lock_guard lock(adding);
                                      losses.add(of_part, begin);
                                    }
                                    if (at_once) convert(dataset, begin, end, rows);
                                  });
  if (other != nullptr) {
    throw Error(place_ + " " + other->name +
                " is damaged: its checksum is another one than was noted when it was saved");
  }
  throw_if_falsified(losses, to);
  if (!at_once) {
    constexpr const char* partly = ", and the array holds a part of it: load it again";
    try {
      other = read_all(datasets_->all, to.size, to.record_bytes, place_, convert);
    } catch (const std::exception& error) {
      throw Error(place_ + " could not be read again" + partly + " (" + error.what() + ")");
    }
    if (other != nullptr) throw Error(place_ + " " + other->name + " was changed while it was loaded" + partly);
  }
  twin.copy_back(to);
}

}  // namespace detail

}  // namespace physgen
