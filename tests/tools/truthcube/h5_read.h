// Reads HDF5 files by HDF5's own functions, not by those that are tested. Objects are named "/group/dataset".
#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

namespace physgen::truthcube::testing {

template <class T>
hid_t h5_type() {
  if constexpr (std::is_same_v<T, float>) return H5T_IEEE_F32LE;
  if constexpr (std::is_same_v<T, double>) return H5T_IEEE_F64LE;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_STD_U8LE;
  if constexpr (std::is_same_v<T, std::int32_t>) return H5T_STD_I32LE;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_STD_I64LE;
}

class H5File {
 public:
  explicit H5File(const std::filesystem::path& path, bool to_write = false)
      : id_(H5Fopen(path.c_str(), to_write ? H5F_ACC_RDWR : H5F_ACC_RDONLY, H5P_DEFAULT)) {
    EXPECT_GE(id_, 0) << path;
  }
  ~H5File() { H5Fclose(id_); }
  H5File(const H5File&) = delete;
  H5File& operator=(const H5File&) = delete;

  [[nodiscard]] hid_t id() const { return id_; }

  /// A path whose last part may be missing.
  [[nodiscard]] bool has(const std::string& name) const { return H5Lexists(id_, name.c_str(), H5P_DEFAULT) > 0; }

  [[nodiscard]] std::vector<hsize_t> shape(const std::string& name) const {
    const hid_t dataset = H5Dopen2(id_, name.c_str(), H5P_DEFAULT);
    const hid_t space = H5Dget_space(dataset);
    std::vector<hsize_t> dims(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
    H5Sget_simple_extent_dims(space, dims.data(), nullptr);
    H5Sclose(space);
    H5Dclose(dataset);
    return dims;
  }

  /// The values of a dataset, which must be stored as Ts: all, or those of its first rows.
  template <class T>
  [[nodiscard]] std::vector<T> values(const std::string& name, hsize_t rows = H5S_UNLIMITED) const {
    const hid_t dataset = H5Dopen2(id_, name.c_str(), H5P_DEFAULT);
    EXPECT_GE(dataset, 0) << name;
    const hid_t type = H5Dget_type(dataset);
    EXPECT_GT(H5Tequal(type, h5_type<T>()), 0) << name << " has another type";
    std::vector<hsize_t> block = shape(name);
    if (block.empty()) return {};
    block[0] = std::min(block[0], rows);
    const hid_t in_file = H5Dget_space(dataset);
    const std::vector<hsize_t> start(block.size(), 0);
    EXPECT_GE(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, block.data(), nullptr), 0) << name;
    const hid_t here = H5Screate_simple(static_cast<int>(block.size()), block.data(), nullptr);
    std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(here)));
    EXPECT_GE(H5Dread(dataset, type, here, in_file, H5P_DEFAULT, values.data()), 0) << name;
    H5Sclose(here);
    H5Sclose(in_file);
    H5Tclose(type);
    H5Dclose(dataset);
    return values;
  }

  [[nodiscard]] std::vector<std::int32_t> integers(const std::string& object, const std::string& attribute) const {
    const hid_t id = H5Aopen_by_name(id_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(id, 0) << attribute;
    const hid_t space = H5Aget_space(id);
    std::vector<std::int32_t> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    EXPECT_GE(H5Aread(id, H5T_NATIVE_INT32, values.data()), 0);
    H5Sclose(space);
    H5Aclose(id);
    return values;
  }

  void set_integer(const std::string& object, const std::string& attribute, std::int32_t value) {
    const hid_t owner = H5Oopen(id_, object.c_str(), H5P_DEFAULT);  // HDF5 1.10 cannot write to what is opened by_name
    const hid_t id = H5Aopen(owner, attribute.c_str(), H5P_DEFAULT);
    EXPECT_GE(H5Awrite(id, H5T_NATIVE_INT32, &value), 0) << attribute;
    H5Aclose(id);
    H5Oclose(owner);
  }

  [[nodiscard]] std::string text(const std::string& object, const std::string& attribute) const {
    const hid_t id = H5Aopen_by_name(id_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(id);
    EXPECT_EQ(H5Tget_class(type), H5T_STRING);
    EXPECT_EQ(H5Tis_variable_str(type), 0);
    std::string value(H5Tget_size(type), '\0');
    EXPECT_GE(H5Aread(id, type, value.data()), 0);
    H5Tclose(type);
    H5Aclose(id);
    return value;
  }

 private:
  hid_t id_;
};

}  // namespace physgen::truthcube::testing
