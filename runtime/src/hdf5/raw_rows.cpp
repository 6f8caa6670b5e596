// See raw_rows.h.
#include "raw_rows.h"

#include <fcntl.h>
#include <physgen/error.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <system_error>

namespace physgen::h5 {

namespace {

std::string reason(int error) { return std::generic_category().message(error); }

constexpr int ended = -1;

// Calls move(at, bytes) until all bytes have moved. @return 0, the system's error, or `ended`
template <class Move>
int move_all(std::size_t bytes, const Move& move) {
  for (std::size_t at = 0; at < bytes;) {
    const ssize_t count = move(at, bytes - at);
    if (count == 0) return ended;
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) at += static_cast<std::size_t>(count);
  }
  return 0;
}

}  // namespace

RawRows::RawRows(const File& file, const std::string& dataset, hid_t type)
    : file_(file.path_.string()),
      name_(dataset),
      dataset_(file.open_dataset(dataset)),
      type_(H5Tcopy(type), H5Tclose),
      shape_(file.shape(dataset)),
      bytes_of_row_(H5Tget_size(type) * (shape_.size() == 2 ? shape_[1] : 1)),
      descriptor_(descriptor()),
      begin_(H5Dget_offset(dataset_.id())) {
  if (!file.has_type(dataset, type)) fail("move rows of", "it holds numbers of another type");
}

int RawRows::descriptor() const {
  const Handle file(H5Iget_file_id(dataset_.id()), H5Fclose);
  void* handle = nullptr;
  if (H5Fget_vfd_handle(file.id(), H5P_DEFAULT, &handle) < 0) fail("move rows of", "it lies in no file of the system");
  return *static_cast<const int*>(handle);
}

void RawRows::fail(const char* asked, const std::string& why) const {
  throw Error(file_ + ": cannot " + asked + " " + name_ + ": " + why);
}

void RawRows::read(hsize_t first_row, hsize_t rows, void* values) const {
  if (rows == 0) return;
  if (first_row + rows > shape_[0]) fail("read", "it has " + std::to_string(shape_[0]) + " rows");
  if (begin_ == HADDR_UNDEF) return read_pieces(first_row, rows, values);
  const int error = move_all(rows * bytes_of_row_, [&](std::size_t at, std::size_t bytes) {
    return ::pread(descriptor_, static_cast<std::byte*>(values) + at, bytes,
                   place_of(first_row) + static_cast<off_t>(at));
  });
  if (error != 0) fail("read", error == ended ? "the file ends before it" : reason(error));
}

void RawRows::write(hsize_t first_row, hsize_t rows, const void* values) const {
  if (rows == 0) return;
  if (first_row + rows > shape_[0] || begin_ == HADDR_UNDEF) fail("write", "there is no place for these rows");
  const int error = move_all(rows * bytes_of_row_, [&](std::size_t at, std::size_t bytes) {
    return ::pwrite(descriptor_, static_cast<const std::byte*>(values) + at, bytes,
                    place_of(first_row) + static_cast<off_t>(at));
  });
  if (error != 0) fail("write", error == ended ? "the system writes nothing" : reason(error));
}

void RawRows::read_ahead(hsize_t first_row, hsize_t rows) const {
  if (begin_ == HADDR_UNDEF || first_row >= shape_[0]) return;
  const hsize_t there = std::min(rows, shape_[0] - first_row);
  [[maybe_unused]] const int ignored =
      ::posix_fadvise(descriptor_, place_of(first_row), static_cast<off_t>(there * bytes_of_row_), POSIX_FADV_WILLNEED);
}

void RawRows::read_pieces(hsize_t first_row, hsize_t rows, void* values) const {
  static std::mutex library;
  const std::lock_guard lock(library);
  std::vector<hsize_t> start(shape_.size(), 0), block = shape_;
  start[0] = first_row;
  block[0] = rows;
  herr_t done = -1;
  H5E_BEGIN_TRY {  // errors are thrown, not printed, on this thread as well
    const Handle in_file(H5Dget_space(dataset_.id()), H5Sclose);
    const Handle here(H5Screate_simple(static_cast<int>(block.size()), block.data(), nullptr), H5Sclose);
    if (H5Sselect_hyperslab(in_file.id(), H5S_SELECT_SET, start.data(), nullptr, block.data(), nullptr) >= 0)
      done = H5Dread(dataset_.id(), type_.id(), here.id(), in_file.id(), H5P_DEFAULT, values);
  }
  H5E_END_TRY
  if (done < 0) fail("read", "HDF5 cannot read the pieces that it is stored in");
}

}  // namespace physgen::h5
