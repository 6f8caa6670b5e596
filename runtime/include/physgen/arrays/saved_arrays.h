// Arrays in files, without their types: what save.h stands on. Compiled in the component hdf5.
#pragma once

#include <physgen/arrays/loaded.h>
#include <physgen/arrays/untyped_array.h>

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace physgen {

/// An array, and the name that it has in a file: {"stress", stress}. Does not own the array.
struct NamedArray {
  std::string name;  ///< without '/'
  UntypedArray array;

  NamedArray(std::string the_name, const UntypedArray& untyped) : name(std::move(the_name)), array(untyped) {}
  template <class Array>
    requires requires(const Array& a) {
      { a.untyped() } -> std::same_as<UntypedArray>;
    }
  NamedArray(std::string the_name, const Array& the_array) : name(std::move(the_name)), array(the_array.untyped()) {}
};

/// Writes arrays to one HDF5 file, in the place of an old one: as `file` either the old or the new one is found,
/// whatever happens. Arrays in Cuda memory are copied to the host first, in the default stream.
/// @throw Error when two names are equal or one cannot be a name, or the file cannot be written, as where its folder
/// may not be written to or its disk is full; an old file is then as it was
void save(const std::filesystem::path& file, std::span<const NamedArray> arrays);
inline void save(const std::filesystem::path& file, std::initializer_list<NamedArray> arrays) {
  save(file, std::span<const NamedArray>(arrays.begin(), arrays.size()));
}

namespace detail {

/// What is left of an array where loading fails: in_use, all that it held; spare, anything.
enum class Target : std::uint8_t { in_use, spare };

/// One array of an open file.
class ArrayOfFile {
 public:
  /// @param form the type of the array that is to get the objects; its memory is not touched
  /// @param fields to load; all that both have where there are none
  ArrayOfFile(const std::filesystem::path& file, const std::string& name, const UntypedArray& form,
              std::span<const std::string> fields);
  ~ArrayOfFile();
  ArrayOfFile(const ArrayOfFile&) = delete;
  ArrayOfFile& operator=(const ArrayOfFile&) = delete;
  [[nodiscard]] const Loaded& loaded() const { return loaded_; }
  /// Loads the objects into an array of as many. One that is in use changes when all that was asked for is found
  /// undamaged, and is read again for it, from the system's cache: that takes less time than memory for all of it.
  /// @param check refuse values that its formats cannot hold
  void give(const UntypedArray& to, Target target, bool check) const;

 private:
  struct Datasets;
  std::string place_;  ///< for messages
  Loaded loaded_;
  std::unique_ptr<Datasets> datasets_;
};

}  // namespace detail

}  // namespace physgen
