// Datasets: of fixed shape, in one piece, and growing, in chunks.
#include <algorithm>

#include "h5.h"
#include "h5_types.h"

namespace physgen::h5 {

void File::write_fixed(const std::string& name, hid_t file, hid_t memory, const void* values,
                       const std::vector<hsize_t>& shape) {
  const std::string asked = "write " + name;
  const Handle space = hold(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, asked);
  const Handle properties = without_times(H5P_DATASET_CREATE, asked);
  Handle dataset =
      hold(H5Dcreate2(file_.id(), name.c_str(), file, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Dclose,
           asked);
  require(H5Dwrite(dataset.id(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0, asked);
  finish(dataset, asked);
}

void File::make_fixed(const std::string& name, hid_t type, std::span<const hsize_t> shape) {
  const std::string asked = "create " + name;
  const Handle space = hold(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, asked);
  const Handle properties = without_times(H5P_DATASET_CREATE, asked);
  require(H5Pset_alloc_time(properties.id(), H5D_ALLOC_TIME_EARLY) >= 0, asked);
  require(H5Pset_fill_time(properties.id(), H5D_FILL_TIME_NEVER) >= 0, asked);
  Handle dataset =
      hold(H5Dcreate2(file_.id(), name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Dclose,
           asked);
  finish(dataset, asked);
}

template <class Stored, class T>
void File::write_dataset(const std::string& name, std::span<const T> values, hsize_t columns) {
  std::vector<hsize_t> shape{values.size() / std::max<hsize_t>(columns, 1)};
  if (columns > 0) shape.push_back(columns);
  write_fixed(name, file_type<Stored>(), memory_type<T>(), values.data(), shape);
}

template <class Stored>
void File::make_dataset(const std::string& name, hsize_t rows) {
  const std::string asked = "create " + name;
  const Handle space = hold(H5Screate_simple(1, &rows, nullptr), H5Sclose, asked);
  const Handle properties = without_times(H5P_DATASET_CREATE, asked);
  hold(H5Dcreate2(file_.id(), name.c_str(), file_type<Stored>(), space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
       H5Dclose, asked);
}

template <class T>
std::vector<T> File::read_dataset(const std::string& name) const {
  const Handle dataset = open_dataset(name);
  const hssize_t count = H5Sget_simple_extent_npoints(space_of(dataset, name).id());
  // Counts that damage made up must not be allocated: the values must be in the file.
  require(count >= 0 && static_cast<hsize_t>(count) * sizeof(T) <= H5Dget_storage_size(dataset.id()),
          "find the values of " + name);
  std::vector<T> values(static_cast<std::size_t>(count));
  require(H5Dread(dataset.id(), memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, "read " + name);
  return values;
}

void File::make_chunked(const std::string& name, hid_t type, std::vector<hsize_t> chunk) {
  const std::string asked = "create " + name;
  const int rank = static_cast<int>(chunk.size());
  const Handle properties = without_times(H5P_DATASET_CREATE, asked);
  require(H5Pset_chunk(properties.id(), rank, chunk.data()) >= 0, asked);
  require(H5Pset_fill_time(properties.id(), H5D_FILL_TIME_NEVER) >= 0, asked);  // all rows are written, once
  std::vector<hsize_t> now = chunk, most = chunk;
  now[0] = 0;
  most[0] = H5S_UNLIMITED;
  const Handle space = hold(H5Screate_simple(rank, now.data(), most.data()), H5Sclose, asked);
  hold(H5Dcreate2(file_.id(), name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Dclose,
       asked);
}

template <class Stored>
void File::make_growing(const std::string& name, hsize_t chunk_rows, hsize_t columns) {
  std::vector<hsize_t> chunk{chunk_rows};
  if (columns > 0) chunk.push_back(columns);
  make_chunked(name, file_type<Stored>(), chunk);
}

void File::select(const Handle& space, hsize_t first_row, std::vector<hsize_t> shape, const std::string& asked) const {
  std::vector<hsize_t> start(shape.size(), 0);
  start[0] = first_row;
  require(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, shape.data(), nullptr) >= 0, asked);
}

void File::put_rows(const std::string& name, hid_t memory, const void* values, std::size_t count, hsize_t first_row) {
  const std::string asked = "write rows of " + name;
  std::vector<hsize_t> block = shape(name);
  Handle dataset = open_dataset(name);
  const hsize_t rows = count / (block.size() == 2 ? block[1] : 1);
  if (block[0] < first_row + rows) {
    block[0] = first_row + rows;
    require(H5Dset_extent(dataset.id(), block.data()) >= 0, asked);
  }
  block[0] = rows;
  const Handle in_file = space_of(dataset, name);
  select(in_file, first_row, block, asked);
  const Handle here = hold(H5Screate_simple(static_cast<int>(block.size()), block.data(), nullptr), H5Sclose, asked);
  require(H5Dwrite(dataset.id(), memory, here.id(), in_file.id(), H5P_DEFAULT, values) >= 0, asked);
  finish(dataset, asked);
}

template <class T>
void File::write_rows(const std::string& name, hsize_t first_row, std::span<const T> values) {
  put_rows(name, memory_type<T>(), values.data(), values.size(), first_row);
}

std::vector<double> File::read_rows(const std::string& name, hsize_t first_row, hsize_t rows) const {
  const std::string asked = "read rows of " + name;
  std::vector<hsize_t> block = shape(name);
  const Handle dataset = open_dataset(name);
  require(first_row + rows <= block[0], asked);
  block[0] = rows;
  const Handle in_file = space_of(dataset, name);
  select(in_file, first_row, block, asked);
  const Handle here = hold(H5Screate_simple(static_cast<int>(block.size()), block.data(), nullptr), H5Sclose, asked);
  std::vector<double> values(rows * (block.size() == 2 ? block[1] : 1));
  require(H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, here.id(), in_file.id(), H5P_DEFAULT, values.data()) >= 0, asked);
  return values;
}

std::vector<hsize_t> File::shape(const std::string& name) const {
  const Handle space = space_of(open_dataset(name), name);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  require(rank == 1 || rank == 2, "take " + name + " for a table");
  std::vector<hsize_t> extent(static_cast<std::size_t>(rank));
  require(H5Sget_simple_extent_dims(space.id(), extent.data(), nullptr) >= 0, "read the shape of " + name);
  return extent;
}

bool File::has_type(const std::string& name, hid_t type) const {
  const Handle dataset = open_dataset(name);
  const Handle stored = hold(H5Dget_type(dataset.id()), H5Tclose, "read the type of " + name);
  return H5Tequal(stored.id(), type) > 0;
}

bool File::holds_all(const std::string& name) const {
  const Handle dataset = open_dataset(name);
  const Handle made = hold(H5Dget_create_plist(dataset.id()), H5Pclose, "read how " + name + " is stored");
  if (H5Pget_nfilters(made.id()) > 0) {  // its values take any number of bytes
    const std::vector<hsize_t> rows = shape(name);
    std::vector<hsize_t> chunk(rows.size());
    require(H5Pget_chunk(made.id(), static_cast<int>(chunk.size()), chunk.data()) >= 0, "read the chunks of " + name);
    hsize_t there = 0, needed = 1;
    require(H5Dget_num_chunks(dataset.id(), space_of(dataset, name).id(), &there) >= 0, "count the chunks of " + name);
    for (std::size_t k = 0; k < rows.size(); ++k) needed *= (rows[k] + chunk[k] - 1) / chunk[k];
    return there == needed;
  }
  const Handle stored = hold(H5Dget_type(dataset.id()), H5Tclose, "read the type of " + name);
  const hssize_t count = H5Sget_simple_extent_npoints(space_of(dataset, name).id());
  return count >= 0 && static_cast<hsize_t>(count) <= H5Dget_storage_size(dataset.id()) / H5Tget_size(stored.id());
}

// Instantiations that the writers use.
template void File::write_dataset<double>(const std::string&, std::span<const double>, hsize_t);
template void File::write_dataset<std::int64_t>(const std::string&, std::span<const std::int32_t>, hsize_t);
template void File::write_dataset<std::int64_t>(const std::string&, std::span<const std::int64_t>, hsize_t);
template void File::write_dataset<std::uint8_t>(const std::string&, std::span<const std::uint8_t>, hsize_t);
template void File::make_dataset<double>(const std::string&, hsize_t);
template void File::make_dataset<std::int64_t>(const std::string&, hsize_t);
template void File::make_dataset<std::uint8_t>(const std::string&, hsize_t);
template std::vector<double> File::read_dataset(const std::string&) const;
template std::vector<std::uint8_t> File::read_dataset(const std::string&) const;
template void File::make_growing<float>(const std::string&, hsize_t, hsize_t);
template void File::make_growing<double>(const std::string&, hsize_t, hsize_t);
template void File::make_growing<std::int64_t>(const std::string&, hsize_t, hsize_t);
template void File::write_rows(const std::string&, hsize_t, std::span<const double>);
template void File::write_rows(const std::string&, hsize_t, std::span<const std::int64_t>);
template void File::write_rows(const std::string&, hsize_t, std::span<const std::uint8_t>);

}  // namespace physgen::h5
