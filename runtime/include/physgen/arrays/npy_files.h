// Arrays in folders of .npy files, without their types: what save_npy.h stands on.
#pragma once

#include <physgen/arrays/loaded.h>
#include <physgen/arrays/untyped_array.h>

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace physgen::detail {

/// Writes a file for each stored field of an array.
void save_npy(const UntypedArray& array, const std::filesystem::path& folder);

/// The files of an array, open; what they hold was compared with the array's fields before any object of it changes.
class NpyFolder {
 public:
  /// @param form the type of the array that is to get the objects; its memory is not touched
  /// @param fields to load; all that both have where there are none
  NpyFolder(const std::filesystem::path& folder, const UntypedArray& form, std::span<const std::string> fields);
  ~NpyFolder();
  NpyFolder(const NpyFolder&) = delete;
  NpyFolder& operator=(const NpyFolder&) = delete;
  [[nodiscard]] const Loaded& loaded() const { return loaded_; }
  /// Reads the files into an array of as many objects. @param check refuse values that its formats cannot hold
  /// @throw Error with a part of the objects read
  void read(const UntypedArray& to, bool check) const;

 private:
  struct Files;
  Loaded loaded_;
  std::unique_ptr<Files> files_;
};

}  // namespace physgen::detail
