// Reading and writing files for the command: no half-written file, and no new time for an unchanged one.
#pragma once

#include <filesystem>
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

/// Refuses to write over what is read: an output that is a file of `inputs`, or two outputs that are one file, be it by
/// another path or through a link.
/// @throws FileError
void require_apart(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

/// Writes the files whose text is not there already; makes their folders. Each is written beside its place under
/// another name and renamed, after all of them have been written: a failure leaves no half-written file and no
/// temporary one. If a renaming fails, files before it in the list are new already. What is there and is no file,
/// such as /dev/null, is written to where it is.
/// @return for each file whether it was changed
/// @throws FileError
std::vector<bool> write_changed(const std::vector<File>& files);

/// Makes the folder that a file is written to. @throws FileError
void make_folder_of(const std::filesystem::path& path);

/// Gives a file a time; not what is no file, such as /dev/null. @throws FileError
void set_time(const std::string& path, std::filesystem::file_time_type time);

/// The present time, as files have it.
[[nodiscard]] std::filesystem::file_time_type now();

/// A file that says that everything was written. It and what was written with it have the time at which reading began:
/// what is changed while physgen reads it is newer, and is read again.
struct Stamp {
  std::string path;  ///< empty: none
  std::filesystem::file_time_type begun = now();
};

/// write_changed() of files that are not among `inputs`, and then the stamp.
/// @throws FileError, where an output is an input, too, or two outputs are one file
std::vector<bool> write_outputs(const std::vector<File>& files, const std::vector<std::string>& inputs,
                                const Stamp& stamp);

/// Dependencies of `target` in the syntax of Make, which Ninja and CMake read too.
[[nodiscard]] std::string depfile(const std::string& target, const std::vector<std::string>& dependencies);

}  // namespace physgen::command
