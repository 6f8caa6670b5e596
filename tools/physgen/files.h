// Reading and writing files for the command: no half-written file, and no new time for an unchanged one.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace physgen::command {

/// A file that cannot be read or written; what() names it and the reason.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct File {
  std::string path;
  std::string text;
};

/// @throws FileError if `path` cannot be read
void require_readable(const std::string& path);

/// @throws FileError if `path` cannot be read
[[nodiscard]] std::string read_file(const std::string& path);

/// Writes the files whose text is not there already; makes their folders. Each is written beside its place under
/// another name and renamed, after all of them have been written: a failure leaves no half-written file and no
/// temporary one. If a renaming fails, files before it in the list are new already.
/// @return for each file whether it was changed
/// @throws FileError
std::vector<bool> write_changed(const std::vector<File>& files);

/// Makes an empty file, or gives one the present time.
/// @throws FileError
void touch(const std::string& path);

/// Dependencies of `target` in the syntax of Make, which Ninja and CMake read too.
[[nodiscard]] std::string depfile(const std::string& target, const std::vector<std::string>& dependencies);

}  // namespace physgen::command
