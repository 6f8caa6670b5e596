// Saving and loading arrays in one HDF5 file, which h5py, h5dump and viewers read, too:
//   save("state.h5", {{"stress", stress}, {"tets", tets}});
//   const Loaded loaded = load("state.h5", "stress", stress);   // any layout, space and formats
//   if (!loaded.complete()) std::cerr << loaded.text() << '\n';
// Programs link physgen::hdf5 for it (component hdf5). What the file holds is said in runtime/saving.md.
#pragma once

#include <physgen/arrays/array.h>
#include <physgen/arrays/resized.h>
#include <physgen/arrays/saved_arrays.h>

namespace physgen {

/// Loads the objects of an array by name; the array gets as many as the file has, and its views end where that changes
/// the number; for the time of the call there are then two such arrays. Fields are matched by name, and converted where
/// formats differ. Fields that the file lacks keep their values; new objects have initial ones. Arrays in Cuda memory
/// are loaded by way of the host, in the default stream.
/// @param fields to load; all that both have where there are none
/// @throw Error when the file is none of save()'s, newer than this library, truncated or damaged; when it has no such
/// array or field, or they do not fit: another type of object, other numbers of elements, other units, integers in the
/// place of real numbers; in checked builds also when a format cannot hold a value. `array` is then unchanged, but
/// where the file changes during the call, and the Error says so
template <class Object, class Real, class Space, class Layout, class Formats>
Loaded load(const std::filesystem::path& file, const std::string& name,
            Array<Object, Real, Space, Layout, Formats>& array, std::span<const std::string> fields = {}) {
  const detail::ArrayOfFile read(file, name, array.untyped(), fields);
  if (read.loaded().objects == array.size()) {
    read.give(array.untyped(), detail::Target::in_use, checked_build);
  } else {
    auto other = detail::resized(array, read.loaded().objects);
    read.give(other.untyped(), detail::Target::spare, checked_build);
    array.swap(other);
  }
  return read.loaded();
}
template <class Object, class Real, class Space, class Layout, class Formats>
Loaded load(const std::filesystem::path& file, const std::string& name,
            Array<Object, Real, Space, Layout, Formats>& array, std::initializer_list<std::string> fields) {
  return load(file, name, array, std::span<const std::string>(fields.begin(), fields.size()));
}

}  // namespace physgen
