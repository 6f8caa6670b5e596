// Loading .npy files: all headers and sizes are compared with the array before it changes.
#include <physgen/arrays/array_losses.h>
#include <physgen/arrays/npy_files.h>
#include <physgen/error.h>

#include <algorithm>
#include <fstream>
#include <string_view>
#include <utility>
#include <vector>

#include "../host_convert.h"
#include "host_twin.h"
#include "names.h"
#include "npy_header.h"
#include "one_field.h"

namespace physgen {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view ending = ".npy";

/// The names of the files of a folder, without their ending, by letters.
std::vector<std::string> files_in(const fs::path& folder) {
  std::error_code error;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(ending) && name.size() > ending.size())
      names.push_back(name.substr(0, name.size() - ending.size()));
  }
  if (error) throw Error(folder.string() + ": cannot be read as a folder of .npy files: " + error.message());
  std::sort(names.begin(), names.end());
  return names;
}

std::string elements(int count) { return std::to_string(count) + (count == 1 ? " element" : " elements"); }

/// The form of a table for a field. @throw Error where it does not fit
FieldInfo form_of(const files::NpyTable& table, const FieldInfo& field, const std::string& place) {
  const auto refuse = [&](const std::string& there, const std::string& here, const char* remedy) {
    throw Error(place + ": has " + there + " in the file and " + here + " in the array" + remedy);
  };
  if (table.columns != field.visible_count()) refuse(elements(table.columns), elements(field.visible_count()), "");
  if (!files::loads_into(table.type, field.type)) {
    refuse(files::kind_of(table.type), files::kind_of(field.type),
           "; convert the file's by .astype(), if that is meant");
  }
  FieldInfo form = field;
  form.type = table.type;
  form.offset = 0;
  form.count = table.columns;
  form.quaternion = false;
  form.scale = 1;
  form.centre = 0;
  form.own = nullptr;
  return form;
}

/// @throw Error where bytes of the file are no bool, which a program may not read as one
void require_bools(const std::byte* bytes, index_t count, const std::string& place) {
  const auto* const found = std::find_if(bytes, bytes + count, [](std::byte b) { return b > std::byte{1}; });
  if (found != bytes + count)
    throw Error(place + ": holds a byte " + std::to_string(static_cast<int>(*found)) + " where bool is 0 or 1");
}

}  // namespace

namespace detail {

struct NpyFolder::Files {
  struct One {
    std::string place;
    std::ifstream in;
    files::NpyTable table;
    std::vector<FieldInfo> fields;  ///< as many as the array has, of which one is stored
  };
  std::vector<One> all;
};

NpyFolder::~NpyFolder() = default;

NpyFolder::NpyFolder(const fs::path& folder, const UntypedArray& form, std::span<const std::string> asked)
    : files_(std::make_unique<Files>()) {
  const std::vector<std::string> stored = files_in(folder);
  for (const std::string& field : asked) {
    if (!files::has(stored, field))
      throw Error(folder.string() + ": has no file '" + field + ".npy'" + files::nearest_first(field, stored));
  }
  const std::vector<std::string> taken = files::stored_fields(form, asked, folder.string());
  for (const std::string& field : stored)
    if (asked.empty() && !files::has(taken, field)) loaded_.left_out.push_back(field);
  for (std::size_t f = 0; f < form.fields.size(); ++f) {
    const FieldInfo& field = form.fields[f];
    if (!field.is_stored() || (!asked.empty() && !files::has(asked, field.name))) continue;
    if (!files::has(stored, field.name)) {
      loaded_.kept.emplace_back(field.name);
      continue;
    }
    const fs::path path = folder / (std::string(field.name) + std::string(ending));
    Files::One one{path.string(), std::ifstream(path, std::ios::binary), {}, {}};
    if (!one.in) throw Error(one.place + ": cannot be opened");
    one.table = files::read_npy_header(one.in, one.place);
    one.fields = files::only(form.fields, f, form_of(one.table, field, one.place));
    const auto begin = static_cast<std::int64_t>(one.in.tellg());
    one.in.seekg(0, std::ios::end);
    const auto bytes = static_cast<std::int64_t>(one.in.tellg()) - begin;
    one.in.seekg(begin);
    const int of_row = one.table.bytes_of_row();
    if (!one.in || bytes % of_row != 0 || bytes / of_row != one.table.rows) {
      throw Error(one.place + ": has " + std::to_string(bytes) + " bytes of numbers, and its header says " +
                  std::to_string(one.table.rows) + " rows of " + std::to_string(of_row) +
                  "; it is truncated, or not written to its end");
    }
    if (!files_->all.empty() && one.table.rows != files_->all.front().table.rows) {
      const Files::One& first = files_->all.front();
      throw Error(one.place + ": has " + std::to_string(one.table.rows) + " objects, and " + first.place + " " +
                  std::to_string(first.table.rows) + "; all files of an array have a row for each object");
    }
    files_->all.push_back(std::move(one));
    loaded_.fields.emplace_back(field.name);
  }
  if (!files_->all.empty()) {
    loaded_.objects = files_->all.front().table.rows;
  } else if (!taken.empty()) {
    throw Error(folder.string() + ": has no .npy file of a field of the array" + files::nearest_first("", taken));
  }
}

void NpyFolder::read(const UntypedArray& to, bool check) const {
  const HostTwin twin(to);
  for (Files::One& one : files_->all) {
    const int bytes = one.table.bytes_of_row();
    const index_t rows = check ? to.size : std::min(files::rows_at_once(bytes), to.size);  // losses name objects
    const Buffer block(SpaceKind::host, rows * bytes, one.place);
    for (index_t begin = 0; begin < to.size; begin += rows) {
      const index_t end = std::min(begin + rows, to.size);
      one.in.read(reinterpret_cast<char*>(block.data()), static_cast<std::streamsize>((end - begin) * bytes));
      if (!one.in) throw Error(one.place + ": cannot be read to its end");
      if (one.table.type == ElementType::boolean) require_bools(block.data(), (end - begin) * bytes, one.place);
      const UntypedArray part{block.data(), end - begin, end - begin, 1, bytes, SpaceKind::host, to.object, one.fields};
      if (check) throw_if_falsified(count_on_host(to, part, 0, end - begin), to);
      convert_on_host(twin.array(), 0, part, begin, begin, end);
    }
  }
  twin.copy_back(to);
}

}  // namespace detail

}  // namespace physgen
