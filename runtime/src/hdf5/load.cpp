// Loading: everything that is asked for is read and held against its checksum before the array changes.
#include <physgen/arrays/array_losses.h>
#include <physgen/arrays/saved_arrays.h>
#include <physgen/error.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>

#include "../host_convert.h"
#include "checksum.h"
#include "host_twin.h"
#include "names.h"
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
  if ((stored.type == ElementType::int32) != (field.type == ElementType::int32)) {
    const auto kind = [](const FieldInfo& f) { return f.type == ElementType::int32 ? "integers" : "real numbers"; };
    refuse(kind(stored), kind(field));
  }
  if (!unit.empty() && !field.unit.empty() && unit != field.unit)
    refuse("the unit " + unit, "the unit " + std::string(field.unit));
}

using Rows = std::unique_ptr<std::byte, void (*)(void*)>;

/// Memory that nothing is written to before the file is: a Buffer's would be cleared. In huge pages where there are.
Rows memory_for(index_t bytes, const std::string& what) {
  constexpr index_t page = index_t{1} << 21;
  const auto whole =
      static_cast<std::size_t>(align_up(std::max<index_t>(bytes, 1), bytes < page ? index_t{256} : page));
  Rows memory(static_cast<std::byte*>(std::aligned_alloc(bytes < page ? 256 : page, whole)), std::free);
  if (memory == nullptr) throw Error(what + ": there is no memory for its " + std::to_string(bytes) + " bytes");
  if (bytes >= page) ::madvise(memory.get(), whole, MADV_HUGEPAGE);
  return memory;
}

/// All rows of a dataset. @throw Error when they are damaged
Rows read_values(const h5::File& file, const std::string& place, const std::string& dataset, const FieldInfo& form,
                 index_t size) {
  const auto refuse = [&](const std::string& why) { throw Error(place + " " + dataset + " " + why); };
  if (file.shape(dataset)[0] != static_cast<hsize_t>(size))
    refuse("has " + std::to_string(file.shape(dataset)[0]) + " rows for " + std::to_string(size) + " objects");
  if (!file.holds_all(dataset)) refuse("is not in the file as a whole");
  const int bytes = form.count * element_bytes(form.type);
  Rows memory = memory_for(size * bytes, place + " " + dataset);
  file.read_ahead(dataset);
  h5::Checksum checksum;
  const h5::Handle type = h5::type_of(form.type);
  const index_t rows = h5::rows_at_once(bytes);
  for (index_t begin = 0; begin < size; begin += rows) {
    const index_t end = std::min(begin + rows, size);
    std::byte* const to = memory.get() + begin * bytes;
    file.read_raw_rows(dataset, type.id(), static_cast<hsize_t>(begin), static_cast<hsize_t>(end - begin), to);
    checksum.add({to, static_cast<std::size_t>((end - begin) * bytes)});
  }
  const std::vector<std::uint64_t> noted = file.read_values_attribute(dataset, "checksum");
  if (!std::equal(noted.begin(), noted.end(), checksum.value().begin(), checksum.value().end()))
    refuse("is damaged: its checksum is another one than was noted when it was saved");
  return memory;
}

}  // namespace

namespace detail {

ArrayOfFile::ArrayOfFile(const std::filesystem::path& path, const std::string& name, const UntypedArray& form,
                         std::span<const std::string> asked)
    : place_(path.string() + ": '" + name + "'") {
  const h5::File file = open(path);
  const std::vector<std::string> arrays = file.names_in("/");
  if (std::find(arrays.begin(), arrays.end(), name) == arrays.end())
    throw Error(path.string() + ": has no array '" + name + "'" + h5::nearest_first(name, arrays));
  const std::string group = "/" + name;
  if (const std::string object = file.read_text_attribute(group, "object"); object != form.object) {
    throw Error(place_ + " holds objects of the type " + object + ", and the array those of " +
                std::string(form.object) + "; load it into an array of " + object);
  }
  loaded_.objects = static_cast<index_t>(file.read_attribute<std::uint64_t>(group, "count"));
  const std::vector<std::string> stored = file.names_in(group);
  const auto has = [](const auto& names, std::string_view word) {
    return std::find(names.begin(), names.end(), word) != names.end();
  };
  std::vector<std::string> taken;
  for (const FieldInfo& field : form.fields)
    if (field.is_stored()) taken.emplace_back(field.name);
  for (const std::string& field : asked) {
    if (!has(stored, field)) throw Error(place_ + " has no field '" + field + "'" + h5::nearest_first(field, stored));
    if (!has(taken, field))
      throw Error(place_ + ": the array stores no field '" + field + "'" + h5::nearest_first(field, taken));
  }
  for (const std::string& field : stored)
    if (asked.empty() && !has(taken, field)) loaded_.left_out.push_back(field);
  for (std::size_t f = 0; f < form.fields.size(); ++f) {
    const FieldInfo& field = form.fields[f];
    if (!field.is_stored() || (!asked.empty() && !has(asked, field.name))) continue;
    if (!has(stored, field.name)) {
      loaded_.kept.emplace_back(field.name);
      continue;
    }
    const std::string dataset = group + "/" + std::string(field.name);
    FieldInfo in_file = h5::read_form(file, place_, dataset);
    require_fit(place_, in_file, h5::read_unit(file, dataset), field);
    in_file.name = field.name;
    in_file.in_double = field.in_double;
    fields_.push_back(
        {h5::only(form.fields, f, in_file), read_values(file, place_, dataset, in_file, loaded_.objects)});
    loaded_.fields.emplace_back(field.name);
  }
  if (fields_.empty() && !(stored.empty() && taken.empty())) {
    throw Error(place_ + " has no field in common with the array" + h5::nearest_first("", stored) +
                "; load it into an array of the schema that it was saved with");
  }
}

UntypedArray ArrayOfFile::Field::array(const UntypedArray& form, index_t size) const {
  int bytes = 0;
  for (const FieldInfo& field : fields) bytes += field.count * element_bytes(field.type);
  return {memory.get(), size, size, 1, bytes, SpaceKind::host, form.object, fields};
}

void ArrayOfFile::give(const UntypedArray& to, bool check) const {
  if (to.size != loaded_.objects) {
    throw Error(place_ + " has " + std::to_string(loaded_.objects) + " objects, and the array " +
                std::to_string(to.size) + ": resize it");
  }
  if (to.size == 0) return;
  if (check) {
    for (const Field& field : fields_) throw_if_falsified(count_on_host(to, field.array(to, to.size), 0, to.size), to);
  }
  const HostTwin twin(to);
  const index_t rows = h5::rows_at_once(std::max(to.record_bytes, 1));
  for (index_t begin = 0; begin < to.size; begin += rows) {
    for (const Field& field : fields_)
      convert_on_host(twin.array(), 0, field.array(to, to.size), 0, begin, std::min(begin + rows, to.size));
  }
  twin.copy_back(to);
}

}  // namespace detail

std::string Loaded::text() const {
  std::string text = std::to_string(objects) + " objects were loaded with " + h5::list(fields);
  if (!left_out.empty()) text += "; left out, since the array does not store it: " + h5::list(left_out);
  if (!kept.empty()) text += "; not in the file, so that it keeps its values: " + h5::list(kept);
  return text;
}

}  // namespace physgen
