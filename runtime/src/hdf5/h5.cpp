// Files that grow in place stay in HDF5's oldest format: its newer ones mark a file that is open for writing, and
// refuse it after a kill. Whole ones have the format of HDF5 1.8, whose descriptions of the contents have checksums.
#include "h5.h"

#include <physgen/error.h>

#include <algorithm>

#include "../files/disk.h"
#include "h5_types.h"

namespace physgen::h5 {

namespace {

// Children of one node of a chunk index: with one chunk per step, so many steps add to an index in place, without
// splitting a node, whose two halves a kill could separate.
constexpr unsigned index_half_width = 256;

extern "C" herr_t take_innermost(unsigned n, const H5E_error2_t* entry, void* text) {
  if (n == 0 && entry->desc != nullptr) *static_cast<std::string*>(text) = entry->desc;
  return 0;
}

extern "C" herr_t add_name(hid_t /*group*/, const char* name, const H5L_info_t* /*info*/, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

void begin() {
  // After a write that failed, the library crashes when it cleans up behind the end of main(). All files are closed
  // then.
  [[maybe_unused]] static const herr_t once = H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are thrown, not printed
}

hid_t access_properties(Growth growth) {
  const hid_t list = H5Pcreate(H5P_FILE_ACCESS);
  if (list >= 0) {
    H5Pset_fclose_degree(list, H5F_CLOSE_STRONG);
    H5Pset_fapl_sec2(list);  // whatever HDF5_DRIVER says: raw_rows.cpp needs a file of the system
    H5Pset_file_locking(list, false, true);
    if (growth == Growth::whole) H5Pset_libver_bounds(list, H5F_LIBVER_V18, H5F_LIBVER_V18);
  }
  return list;
}

}  // namespace

void File::fail(const std::string& asked) const {
  std::string reason = "HDF5 gives no reason";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_innermost, &reason);
  throw Error(path_.string() + ": cannot " + asked + ": " + reason);
}

File File::create(const std::filesystem::path& path, std::uint64_t bytes, Growth growth) {
  begin();
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false);  // of the root
  if (growth == Growth::in_place) H5Pset_istore_k(creation.id(), index_half_width);
  const Handle access(access_properties(growth), H5Pclose);
  File file(path, Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose));
  file.require(file.file_.id() >= 0, "create it");
  file.close();
  disk::reserve_space(path, bytes);
  return open(path, true, growth);
}

File File::open(const std::filesystem::path& path, bool to_write, Growth growth) {
  begin();
  const Handle access(access_properties(growth), H5Pclose);
  File file(path, Handle(H5Fopen(path.c_str(), to_write ? H5F_ACC_RDWR : H5F_ACC_RDONLY, access.id()), H5Fclose));
  file.require(file.file_.id() >= 0, to_write ? "open it for writing" : "open it");
  if (to_write) file.require(H5Fincrement_filesize(file.file_.id(), 0) >= 0, "find its end");
  return file;
}

void File::flush() { require(H5Fflush(file_.id(), H5F_SCOPE_LOCAL) >= 0, "write what is buffered"); }

void File::close() {
  flush();
  require(H5Fclose(file_.release()) >= 0, "close it");
}

bool File::has(const std::string& name) const {
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    const htri_t there = H5Lexists(file_.id(), name.substr(0, end).c_str(), H5P_DEFAULT);
    require(there >= 0, "look for " + name);
    if (there == 0) return false;
    if (end == std::string::npos) return true;
  }
}

bool File::has_attribute(const std::string& object, const std::string& name) const {
  const htri_t there = H5Aexists_by_name(file_.id(), object.c_str(), name.c_str(), H5P_DEFAULT);
  require(there >= 0, "look for " + name + " of " + object);
  return there > 0;
}

Handle File::without_times(hid_t kind, const std::string& asked) const {
  Handle properties = hold(H5Pcreate(kind), H5Pclose, asked);
  require(H5Pset_obj_track_times(properties.id(), false) >= 0, asked);
  return properties;
}

void File::make_group(const std::string& name) {
  const std::string asked = "create " + name;
  const Handle properties = without_times(H5P_GROUP_CREATE, asked);
  hold(H5Gcreate2(file_.id(), name.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Gclose, asked);
}

void File::rename(const std::string& from, const std::string& to) {
  require(H5Lmove(file_.id(), from.c_str(), file_.id(), to.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0,
          "rename " + from + " to " + to);
}

std::vector<std::string> File::names_in(const std::string& group) const {
  std::vector<std::string> names;
  require(H5Literate_by_name(file_.id(), group.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add_name, &names,
                             H5P_DEFAULT) >= 0,
          "list " + group);
  return names;
}

Handle File::open_object(const std::string& name) const {
  return hold(H5Oopen(file_.id(), name.c_str(), H5P_DEFAULT), H5Oclose, "find " + name);
}

Handle File::open_dataset(const std::string& name) const {
  return hold(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose, "find " + name);
}

Handle File::open_attribute(const Handle& object, const std::string& name) const {
  return hold(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT), H5Aclose, "find the attribute " + name);
}

Handle File::space_of(const Handle& dataset, const std::string& name) const {
  return hold(H5Dget_space(dataset.id()), H5Sclose, "read the shape of " + name);
}

// ---- Attributes. ------------------------------------------------------------

void File::set_attribute(const std::string& object, const std::string& name, hid_t file, hid_t memory,
                         const void* values, hsize_t count) {
  const std::string asked = "write " + name + " of " + object;
  const Handle owner = open_object(object);
  const auto make = [&] {
    const Handle space =
        hold(count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr), H5Sclose, asked);
    return H5Acreate2(owner.id(), name.c_str(), file, space.id(), H5P_DEFAULT, H5P_DEFAULT);
  };
  const Handle attribute = has_attribute(object, name) ? open_attribute(owner, name) : hold(make(), H5Aclose, asked);
  require(H5Awrite(attribute.id(), memory, values) >= 0, asked);
}

template <class T>
void File::write_attribute(const std::string& object, const std::string& name, std::span<const T> values) {
  set_attribute(object, name, file_type<T>(), memory_type<T>(), values.data(), values.size());
}

void File::write_attribute(const std::string& object, const std::string& name, const std::string& text) {
  const Handle type = hold(H5Tcopy(H5T_C_S1), H5Tclose, "describe a text");
  require(H5Tset_size(type.id(), std::max<std::size_t>(text.size(), 1)) >= 0, "describe a text");
  require(H5Tset_strpad(type.id(), H5T_STR_NULLPAD) >= 0, "describe a text");
  const bool ascii = std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x80; });
  if (!ascii) require(H5Tset_cset(type.id(), H5T_CSET_UTF8) >= 0, "describe a text");
  set_attribute(object, name, type.id(), type.id(), text.c_str(), 1);
}

template <class T>
T File::read_attribute(const std::string& object, const std::string& name) const {
  const Handle attribute = open_attribute(open_object(object), name);
  const Handle space = hold(H5Aget_space(attribute.id()), H5Sclose, "read " + name);
  require(H5Sget_simple_extent_npoints(space.id()) == 1, "read one value of " + name);
  T value{};
  require(H5Aread(attribute.id(), memory_type<T>(), &value) >= 0, "read " + name);
  return value;
}

std::vector<std::uint64_t> File::read_values_attribute(const std::string& object, const std::string& name) const {
  const Handle attribute = open_attribute(open_object(object), name);
  const Handle space = hold(H5Aget_space(attribute.id()), H5Sclose, "read " + name);
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  require(count >= 0 && count < 1024, "read the values of " + name);
  std::vector<std::uint64_t> values(static_cast<std::size_t>(count));
  require(H5Aread(attribute.id(), H5T_NATIVE_UINT64, values.data()) >= 0, "read " + name);
  return values;
}

std::string File::read_text_attribute(const std::string& object, const std::string& name) const {
  const Handle attribute = open_attribute(open_object(object), name);
  const Handle type = hold(H5Aget_type(attribute.id()), H5Tclose, "read " + name);
  require(H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) == 0, "read the text " + name);
  std::string text(H5Tget_size(type.id()), '\0');
  require(H5Aread(attribute.id(), type.id(), text.data()) >= 0, "read " + name);
  text.resize(std::min(text.size(), text.find('\0')));
  return text;
}

template void File::write_attribute(const std::string&, const std::string&, std::span<const double>);
template void File::write_attribute(const std::string&, const std::string&, std::span<const std::int32_t>);
template void File::write_attribute(const std::string&, const std::string&, std::span<const std::uint64_t>);
template double File::read_attribute(const std::string&, const std::string&) const;
template std::int32_t File::read_attribute(const std::string&, const std::string&) const;
template std::uint64_t File::read_attribute(const std::string&, const std::string&) const;

}  // namespace physgen::h5
