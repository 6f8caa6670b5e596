// The part of the HDF5 library that saved arrays and truthcube's files need: one file, whose groups, attributes and
// datasets have full names
// ("/VTKHDF/Points"). Every call is checked; an Error names the file, what was asked, and HDF5's reason.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace physgen::h5 {

/// A value as the span that attributes and datasets are written from.
template <class T>
std::span<const T> one(const T& value) {
  return {&value, 1};
}

/// Owns one HDF5 object and closes it.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  [[nodiscard]] hid_t id() const { return id_; }
  [[nodiscard]] hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }

 private:
  hid_t id_;
  Close close_;
};

/// How a file gets its contents. in_place: it is opened again, and survives a kill in between. whole: it is written
/// once and then closed; what describes its contents has checksums then, so that HDF5 finds damage there.
enum class Growth : std::uint8_t { in_place, whole };

/// An open file. Names of objects are full paths. All members throw Error. Types of values: double, and integers of 8
/// bits without sign, 32 and 64 with, and 64 without; those stored may be float.
class File {
 public:
  /// A new file that can grow by so many bytes without a full disk, in the place of an old one.
  [[nodiscard]] static File create(const std::filesystem::path& path, std::uint64_t bytes,
                                   Growth growth = Growth::in_place);
  /// An existing file, for reading, or for writing as well. Takes no lock: a viewer may hold the file open. What a
  /// killed process wrote behind the end that it had noted is never given to new data.
  [[nodiscard]] static File open(const std::filesystem::path& path, bool to_write, Growth growth = Growth::in_place);

  /// Hands all that was written to the operating system.
  void flush();
  /// flush(), and no further use of this object.
  void close();

  [[nodiscard]] bool has(const std::string& name) const;
  [[nodiscard]] bool has_attribute(const std::string& object, const std::string& name) const;
  void make_group(const std::string& name);
  void rename(const std::string& from, const std::string& to);
  /// Names of what is in a group, in ascending order.
  [[nodiscard]] std::vector<std::string> names_in(const std::string& group) const;

  /// An attribute of one value, or of several: a new one, or new values for an old one. One value is read.
  template <class T>
  void write_attribute(const std::string& object, const std::string& name, std::span<const T> values);
  void write_attribute(const std::string& object, const std::string& name, const std::string& text);
  template <class T>
  [[nodiscard]] T read_attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::vector<std::uint64_t> read_values_attribute(const std::string& object,
                                                                 const std::string& name) const;
  [[nodiscard]] std::string read_text_attribute(const std::string& object, const std::string& name) const;

  /// A new dataset of fixed shape: rows of `columns` values, or, with 0 columns, one value per row.
  template <class Stored, class T>
  void write_dataset(const std::string& name, std::span<const T> values, hsize_t columns = 0);
  /// The same, whose rows write_rows() writes, all of them.
  template <class Stored>
  void make_dataset(const std::string& name, hsize_t rows);
  template <class T>
  [[nodiscard]] std::vector<T> read_dataset(const std::string& name) const;

  /// A new dataset of this type and shape, for whose rows the file has room; RawRows writes them, all of them.
  void make_fixed(const std::string& name, hid_t type, std::span<const hsize_t> shape);
  [[nodiscard]] bool has_type(const std::string& name, hid_t type) const;
  /// Whether the file has room for all values of a dataset, whose shape may be damaged.
  [[nodiscard]] bool holds_all(const std::string& name) const;

  /// A new dataset without rows that can grow, by chunks of so many rows.
  template <class Stored>
  void make_growing(const std::string& name, hsize_t chunk_rows, hsize_t columns = 0);
  /// Writes rows of a dataset. A growing one gets longer where it is too short. @pre some rows
  template <class T>
  void write_rows(const std::string& name, hsize_t first_row, std::span<const T> values);
  [[nodiscard]] std::vector<double> read_rows(const std::string& name, hsize_t first_row, hsize_t rows) const;
  /// {rows} or {rows, columns}.
  [[nodiscard]] std::vector<hsize_t> shape(const std::string& name) const;

 private:
  friend class RawRows;
  File(std::filesystem::path path, Handle file) : path_(std::move(path)), file_(std::move(file)) {}
  [[noreturn]] void fail(const std::string& asked) const;
  void require(bool done, const std::string& asked) const {
    if (!done) fail(asked);
  }
  Handle hold(hid_t id, Handle::Close close, const std::string& asked) const {
    require(id >= 0, asked);
    return {id, close};
  }
  // Without the time of day, so that files of equal contents are equal.
  [[nodiscard]] Handle without_times(hid_t kind, const std::string& asked) const;
  [[nodiscard]] Handle open_object(const std::string& name) const;
  [[nodiscard]] Handle open_dataset(const std::string& name) const;
  [[nodiscard]] Handle open_attribute(const Handle& object, const std::string& name) const;
  // Closes a dataset that was written: what HDF5 still held back may not fit the disk.
  void finish(Handle& dataset, const std::string& asked) const { require(H5Dclose(dataset.release()) >= 0, asked); }
  [[nodiscard]] Handle space_of(const Handle& dataset, const std::string& name) const;
  void write_fixed(const std::string& name, hid_t file, hid_t memory, const void* values,
                   const std::vector<hsize_t>& shape);
  void make_chunked(const std::string& name, hid_t type, std::vector<hsize_t> chunk);
  void put_rows(const std::string& name, hid_t memory, const void* values, std::size_t count, hsize_t first_row);
  // Selects rows, of all columns, of a dataset of this shape.
  void select(const Handle& space, hsize_t first_row, std::vector<hsize_t> shape, const std::string& asked) const;
  void set_attribute(const std::string& object, const std::string& name, hid_t file, hid_t memory, const void* values,
                     hsize_t count);

  std::filesystem::path path_;
  Handle file_;
};

}  // namespace physgen::h5
