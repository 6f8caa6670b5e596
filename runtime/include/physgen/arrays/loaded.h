// What came of loading an array from a file or a folder.
#pragma once

#include <physgen/config.h>

#include <string>
#include <vector>

namespace physgen {

/// What came of load() and load_npy().
struct Loaded {
  index_t objects = 0;
  std::vector<std::string> fields;    ///< that were loaded
  std::vector<std::string> left_out;  ///< fields in the file, or files of the folder, that the array does not store
  std::vector<std::string> kept;      ///< fields of the array that the file lacks; they keep their values
  /// Whether file and array have the same fields, or those that were asked for were loaded.
  [[nodiscard]] bool complete() const { return left_out.empty() && kept.empty(); }
  /// All of this as a sentence.
  [[nodiscard]] std::string text() const;
};

}  // namespace physgen
