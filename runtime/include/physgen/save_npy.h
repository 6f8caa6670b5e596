// Saving and loading arrays as .npy files, one for each field, which NumPy reads and writes; for programs without HDF5:
//   save_npy(stress, "stress");                          // stress/sigma.npy, stress/pressure.npy
//   const Loaded loaded = load_npy("stress", stress);    // any layout, space and formats
// numpy.load("stress/pressure.npy") has a row for each object, and a column for each element where there are several:
// of a matrix by columns. runtime/saving.md says more.
#pragma once

#include <physgen/arrays/array.h>
#include <physgen/arrays/npy_files.h>
#include <physgen/arrays/resized.h>

#include <initializer_list>

namespace physgen {

/// Writes FIELD.npy for each stored field, into a folder that is made where there is none. Numbers are those that code
/// sees: formats that NumPy does not know are decoded. Each file takes the place of an old one when all are written.
/// Arrays in Cuda memory are copied to the host first, in the default stream.
/// @throw Error when a file cannot be written, as where its disk is full; old files are then as they were
template <class Object, class Real, class Space, class Layout, class Formats>
void save_npy(const Array<Object, Real, Space, Layout, Formats>& array, const std::filesystem::path& folder) {
  detail::save_npy(array.untyped(), folder);
}

/// Loads the objects of an array; it gets as many as the files have, and its views end. Files are matched with fields
/// by name, and converted where formats differ. Fields that have no file keep their values. For the time of the call
/// there are two such arrays.
/// @param fields to load; all that both have where there are none
/// @throw Error when a file is missing, truncated, or no .npy file; when numbers of objects or of elements do not fit,
/// or integers stand in the place of real numbers; in checked builds also when a format cannot hold a value. `array` is
/// then unchanged
template <class Object, class Real, class Space, class Layout, class Formats>
Loaded load_npy(const std::filesystem::path& folder, Array<Object, Real, Space, Layout, Formats>& array,
                std::span<const std::string> fields = {}) {
  const detail::NpyFolder files(folder, array.untyped(), fields);
  auto other = detail::resized(array, files.loaded().objects);
  files.read(other.untyped(), checked_build);
  array.swap(other);
  return files.loaded();
}
template <class Object, class Real, class Space, class Layout, class Formats>
Loaded load_npy(const std::filesystem::path& folder, Array<Object, Real, Space, Layout, Formats>& array,
                std::initializer_list<std::string> fields) {
  return load_npy(folder, array, std::span<const std::string>(fields.begin(), fields.size()));
}

}  // namespace physgen
