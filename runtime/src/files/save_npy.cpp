// Saving .npy files: all are written under other names before the first takes its place.
#include <physgen/arrays/npy_files.h>
#include <physgen/error.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "../describe.h"
#include "../host_convert.h"
#include "disk.h"
#include "host_twin.h"
#include "npy_header.h"
#include "one_field.h"

namespace physgen {

namespace {

namespace fs = std::filesystem;

/// The form that a field has in a file: its own where NumPy knows the numbers, else those that code sees.
FieldInfo form_in_file(const FieldInfo& field) {
  FieldInfo form = field;
  const bool plain = files::is_npy_type(field.type) && field.scale == 1 && field.centre == 0 && field.own == nullptr;
  if (!plain || field.quaternion) form.type = field.in_double ? ElementType::float64 : ElementType::float32;
  form.offset = 0;
  form.count = field.visible_count();
  form.quaternion = false;
  form.scale = 1;
  form.centre = 0;
  form.own = nullptr;
  return form;
}

void write_field(const fs::path& path, const UntypedArray& array, std::size_t number) {
  const FieldInfo form = form_in_file(array.fields[number]);
  const std::vector<FieldInfo> fields = files::only(array.fields, number, form);
  const files::NpyTable table{form.type, array.size, form.count, form.count == 1};
  const std::string header = files::npy_header(table);
  const int bytes = table.bytes_of_row();
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  if (!out) throw Error(path.string() + ": cannot be written; its folder does not allow it");
  disk::reserve_space(path, header.size() + static_cast<std::uint64_t>(array.size) * static_cast<unsigned>(bytes));
  out << header;
  const index_t rows = std::min(files::rows_at_once(bytes), array.size);
  const Buffer block(SpaceKind::host, rows * bytes, path.string());
  for (index_t begin = 0; begin < array.size; begin += rows) {
    const index_t end = std::min(begin + rows, array.size);
    const UntypedArray part{block.data(), end - begin, end - begin, 1, bytes, SpaceKind::host, array.object, fields};
    detail::convert_on_host(part, begin, array, 0, begin, end);
    out.write(reinterpret_cast<const char*>(block.data()), static_cast<std::streamsize>((end - begin) * bytes));
  }
  out.close();
  if (!out) throw Error(path.string() + ": cannot be written; the disk may be full");
}

/// Writes the files of the fields from `number` on. The ones behind take their places first, when all are written.
void write_fields(const fs::path& folder, const UntypedArray& array, std::size_t number) {
  if (number == array.fields.size()) return;
  if (!array.fields[number].is_stored()) return write_fields(folder, array, number + 1);
  const fs::path path = folder / (std::string(array.fields[number].name) + ".npy");
  disk::replace_file(path, disk::new_name(path), [&](const fs::path& written) {
    write_field(written, array, number);
    write_fields(folder, array, number + 1);
  });
}

}  // namespace

void detail::save_npy(const UntypedArray& array, const fs::path& folder) {
  if (array.size > 0 && array.record_bytes > 0 && array.base == nullptr)
    throw Error(folder.string() + ": " + describe(array) + " has no memory (null)");
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    throw Error(folder.string() + ": cannot be a folder of .npy files" +
                (error ? ": " + error.message() : ", since it is a file; choose another name"));
  }
  const HostTwin twin(array);
  write_fields(folder, twin.array(), 0);
}

}  // namespace physgen
