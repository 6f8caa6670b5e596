// Saving: objects are taken in blocks on all threads, and field by field, so that the records of a block stay in the
// cache while all of their fields are written.
#include <physgen/arrays/saved_arrays.h>
#include <physgen/device.h>
#include <physgen/error.h>
#include <physgen/version.h>

#include <algorithm>
#include <set>

#include "../describe.h"
#include "../files/blocks.h"
#include "../files/disk.h"
#include "../files/host_twin.h"
#include "../files/one_field.h"
#include "../host_convert.h"
#include "checksum.h"
#include "raw_rows.h"
#include "stored_fields.h"

namespace physgen {

namespace {

/// One field that is being written.
struct Written {
  std::string dataset;
  std::vector<FieldInfo> fields;
  h5::RawRows rows;

  [[nodiscard]] index_t bytes_of_row() const { return static_cast<index_t>(rows.bytes_of_row()); }
};

void check_names(const std::filesystem::path& file, std::span<const NamedArray> arrays) {
  std::set<std::string> names;
  for (const NamedArray& each : arrays) {
    if (each.name.empty() || each.name == "." || each.name == ".." || each.name.find('/') != std::string::npos ||
        each.name.find('\0') != std::string::npos) {
      throw Error(file.string() + ": '" + each.name + "' cannot be the name of " + detail::describe(each.array) +
                  ": give it one or more letters, and no '/'");
    }
    if (!names.insert(each.name).second)
      throw Error(file.string() + ": two arrays have the name '" + each.name + "'; give each its own");
    if (each.array.size > 0 && each.array.record_bytes > 0 && each.array.base == nullptr)
      throw Error(file.string() + ": '" + each.name + "', " + detail::describe(each.array) + ", has no memory (null)");
  }
}

std::uint64_t bytes_in_file(std::span<const NamedArray> arrays) {
  constexpr std::uint64_t for_names = 1 << 13;  // of a field or an array, with its attributes
  std::uint64_t bytes = for_names;
  for (const NamedArray& each : arrays) {
    bytes += for_names;
    for (const FieldInfo& field : each.array.fields) {
      const FieldInfo form = h5::form_in_file(field);
      bytes += for_names + static_cast<std::uint64_t>(each.array.size * form.count * element_bytes(form.type));
    }
  }
  return bytes;
}

std::vector<Written> begin_fields(h5::File& file, const std::string& group, const UntypedArray& array) {
  std::vector<Written> written;
  for (std::size_t f = 0; f < array.fields.size(); ++f) {
    if (!array.fields[f].is_stored()) continue;
    const FieldInfo form = h5::form_in_file(array.fields[f]);
    const std::string dataset = group + "/" + std::string(form.name);
    const h5::Handle type = h5::type_of(form.type);
    std::vector<hsize_t> shape{static_cast<hsize_t>(array.size)};
    if (form.count > 1) shape.push_back(static_cast<hsize_t>(form.count));
    file.make_fixed(dataset, type.id(), shape);
    h5::write_attributes(file, dataset, form);
    written.push_back({dataset, files::only(array.fields, f, form), h5::RawRows(file, dataset, type.id())});
  }
  return written;
}

void write_array(h5::File& file, const std::string& name, const UntypedArray& array) {
  const std::string group = "/" + name;
  file.make_group(group);
  file.write_attribute(group, "object", std::string(array.object));
  file.write_attribute(group, "count", h5::one(static_cast<std::uint64_t>(array.size)));
  const std::vector<Written> written = begin_fields(file, group, array);
  const index_t rows = files::rows_of_block(array.record_bytes), blocks = files::blocks_of(array.size, rows);
  index_t widest = 0;
  for (const Written& field : written) widest = std::max(widest, field.bytes_of_row());
  std::vector<h5::Checksum> checksums(static_cast<std::size_t>(blocks) * written.size());
  const std::string what = "a block of " + name;
  files::for_blocks(blocks, std::min(rows, array.size) * widest, what, [&](index_t b, std::byte* memory) {
    const index_t begin = b * rows, end = std::min(begin + rows, array.size);
    for (std::size_t f = 0; f < written.size(); ++f) {
      const index_t bytes = written[f].bytes_of_row();
      const UntypedArray part{memory,          end - begin,  end - begin,      1, static_cast<int>(bytes),
                              SpaceKind::host, array.object, written[f].fields};
      detail::convert_on_host(part, begin, array, 0, begin, end);
      checksums[static_cast<std::size_t>(b) * written.size() + f] =
          h5::Checksum({memory, static_cast<std::size_t>((end - begin) * bytes)});
      written[f].rows.write(static_cast<hsize_t>(begin), static_cast<hsize_t>(end - begin), memory);
    }
  });
  for (std::size_t f = 0; f < written.size(); ++f) {
    h5::Checksum whole;
    for (std::size_t at = f; at < checksums.size(); at += written.size()) whole.append(checksums[at]);
    file.write_attribute(written[f].dataset, "checksum", std::span<const std::uint64_t>(whole.value()));
  }
}

}  // namespace

void save(const std::filesystem::path& path, std::span<const NamedArray> arrays) {
  check_names(path, arrays);
  const std::uint64_t bytes = bytes_in_file(arrays);
  disk::replace_file(path, disk::new_name(path), [&](const std::filesystem::path& written) {
    h5::File file = h5::File::create(written, bytes, h5::Growth::whole);
    file.write_attribute("/", "physgen_file", h5::one(h5::file_version));
    file.write_attribute("/", "physgen", std::string(PHYSGEN_VERSION));
    for (const NamedArray& each : arrays) {
      const detail::HostTwin twin(each.array);
      write_array(file, each.name, twin.array());
    }
    file.close();
  });
}

}  // namespace physgen
