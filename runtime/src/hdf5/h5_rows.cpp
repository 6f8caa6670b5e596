// Rows of datasets in one piece, moved as they are stored, whatever their type.
#include <fcntl.h>
#include <unistd.h>

#include "h5.h"

namespace physgen::h5 {

void File::make_fixed(const std::string& name, hid_t type, std::span<const hsize_t> shape) {
  const std::string asked = "create " + name;
  const Handle space = hold(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, asked);
  const Handle properties = dataset_properties(asked);
  Handle dataset =
      hold(H5Dcreate2(file_.id(), name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Dclose,
           asked);
  finish(dataset, asked);
}

void File::move_rows(const std::string& name, hsize_t first_row, hsize_t rows, const std::string& asked,
                     const std::function<herr_t(hid_t, hid_t, hid_t)>& move) const {
  std::vector<hsize_t> block = shape(name);
  require(first_row + rows <= block[0], asked);
  block[0] = rows;
  Handle dataset = open_dataset(name);
  const Handle in_file = space_of(dataset, name);
  select(in_file, first_row, block, asked);
  const Handle here = hold(H5Screate_simple(static_cast<int>(block.size()), block.data(), nullptr), H5Sclose, asked);
  require(move(dataset.id(), here.id(), in_file.id()) >= 0, asked);
  finish(dataset, asked);
}

void File::write_raw_rows(const std::string& name, hid_t type, hsize_t first_row, hsize_t rows, const void* values) {
  move_rows(name, first_row, rows, "write " + name, [&](hid_t dataset, hid_t here, hid_t in_file) {
    return H5Dwrite(dataset, type, here, in_file, H5P_DEFAULT, values);
  });
}

void File::read_raw_rows(const std::string& name, hid_t type, hsize_t first_row, hsize_t rows, void* values) const {
  move_rows(name, first_row, rows, "read " + name, [&](hid_t dataset, hid_t here, hid_t in_file) {
    return H5Dread(dataset, type, here, in_file, H5P_DEFAULT, values);
  });
}

void File::read_ahead(const std::string& name) const {
  const Handle dataset = open_dataset(name);
  const haddr_t begin = H5Dget_offset(dataset.id());
  const int file = begin == HADDR_UNDEF ? -1 : ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;  // it is a hint
  [[maybe_unused]] const int ignored = ::posix_fadvise(
      file, static_cast<off_t>(begin), static_cast<off_t>(H5Dget_storage_size(dataset.id())), POSIX_FADV_WILLNEED);
  ::close(file);
}

bool File::has_type(const std::string& name, hid_t type) const {
  const Handle dataset = open_dataset(name);
  const Handle stored = hold(H5Dget_type(dataset.id()), H5Tclose, "read the type of " + name);
  return H5Tequal(stored.id(), type) > 0;
}

bool File::holds_all(const std::string& name) const {
  const Handle dataset = open_dataset(name);
  const Handle stored = hold(H5Dget_type(dataset.id()), H5Tclose, "read the type of " + name);
  const hssize_t count = H5Sget_simple_extent_npoints(space_of(dataset, name).id());
  return count >= 0 && static_cast<hsize_t>(count) <= H5Dget_storage_size(dataset.id()) / H5Tget_size(stored.id());
}

}  // namespace physgen::h5
