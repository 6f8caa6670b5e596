// See files.h.
#include "files.h"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>

namespace physgen::command {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const fs::path& path, std::error_code error) {
  throw FileError("cannot " + what + " '" + path.string() + "': " + error.message());
}

std::error_code last_error() { return {errno == 0 ? EIO : errno, std::generic_category()}; }

std::optional<std::string> text_of(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

/// Files written under temporary names; those that were not committed are removed.
class Staged {
 public:
  Staged() = default;
  Staged(const Staged&) = delete;
  Staged& operator=(const Staged&) = delete;
  ~Staged() {
    std::error_code ignored;
    for (const Move& move : moves_) fs::remove(move.temporary, ignored);
  }

  void write(const File& file) {
    const fs::path path(file.path);
    if (std::error_code error; fs::is_directory(path, error))
      fail("write", path, std::make_error_code(std::errc::is_a_directory));
    std::error_code error;
    const bool device = fs::exists(path, error) && !fs::is_regular_file(path, error);  // no place for a new file
    const fs::path temporary =
        device ? path
               : path.parent_path() / ("." + path.filename().string() + "." + std::to_string(::getpid()) + ".tmp");
    errno = 0;
    std::ofstream out(temporary, std::ios::binary);
    if (!out) fail("write", path, last_error());
    if (!device) moves_.push_back({temporary, path});
    out << file.text;
    out.close();
    if (!out) fail("write", path, last_error());
  }

  void commit() {
    for (const Move& move : moves_) {
      std::error_code error;
      fs::rename(move.temporary, move.path, error);
      if (error) fail("write", move.path, error);
    }
    moves_.clear();
  }

 private:
  struct Move {
    fs::path temporary, path;
  };
  std::vector<Move> moves_;
};

/// Makes an empty file, or empties one, and gives it a time.
void touch(const std::string& path, fs::file_time_type time) {
  make_folder_of(path);
  errno = 0;
  if (!std::ofstream(path, std::ios::binary)) fail("write", path, last_error());
  set_time(path, time);
}

/// Whether two paths name one file, which need not be there yet.
bool are_one_file(const std::string& a, const std::string& b) {
  std::error_code error;
  const fs::path first = fs::weakly_canonical(fs::absolute(a, error), error);
  if (error) return false;  // reading or writing it says why
  const fs::path second = fs::weakly_canonical(fs::absolute(b, error), error);
  if (error) return false;
  if (first != second && !fs::equivalent(first, second, error)) return false;
  return fs::is_regular_file(first, error) || !fs::exists(first, error);
}

}  // namespace

void make_folder_of(const fs::path& path) {
  if (path.parent_path().empty()) return;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) fail("make the folder", path.parent_path(), error);
}

void set_time(const std::string& path, fs::file_time_type time) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return;  // /dev/null
  fs::last_write_time(path, time, error);
  if (error) fail("set the time of", path, error);
}

void require_readable(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) fail("read", path, std::make_error_code(std::errc::is_a_directory));
  errno = 0;
  if (!std::ifstream(path, std::ios::binary)) fail("read", path, last_error());
}

std::string read_file(const std::string& path) {
  require_readable(path);
  auto text = text_of(path);
  if (!text) fail("read", path, std::make_error_code(std::errc::invalid_argument));
  return std::move(*text);
}

void require_apart(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  const auto refuse = [](const std::string& path, const std::string& why) {
    throw FileError("cannot write '" + path + "': " + why + "; name another file");
  };
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const std::string& input : inputs)
      if (are_one_file(outputs[i], input)) refuse(outputs[i], "it is an input, and would be lost");
    for (std::size_t k = 0; k < i; ++k)
      if (are_one_file(outputs[i], outputs[k])) refuse(outputs[i], "another output is written there");
  }
}

std::vector<bool> write_changed(const std::vector<File>& files) {
  std::vector<bool> changed;
  Staged staged;
  for (const File& file : files) {
    changed.push_back(text_of(file.path) != file.text);
    if (!changed.back()) continue;
    make_folder_of(file.path);
    staged.write(file);
  }
  staged.commit();
  return changed;
}

fs::file_time_type now() { return fs::file_time_type::clock::now(); }

std::vector<bool> write_outputs(const std::vector<File>& files, const std::vector<std::string>& inputs,
                                const Stamp& stamp) {
  std::vector<std::string> outputs;
  for (const File& file : files) outputs.push_back(file.path);
  if (!stamp.path.empty()) outputs.push_back(stamp.path);
  require_apart(outputs, inputs);
  auto changed = write_changed(files);
  if (stamp.path.empty()) return changed;
  for (std::size_t i = 0; i < files.size(); ++i)  // Ninja takes the latest time of all that a command has written
    if (changed[i]) set_time(files[i].path, stamp.begun);
  touch(stamp.path, stamp.begun);
  return changed;
}

std::string depfile(const std::string& target, const std::vector<std::string>& dependencies) {
  const auto escaped = [](const std::string& path) {
    std::string result;
    for (const char c : path) {
      if (c == ' ' || c == '#') result += '\\';
      if (c == '$') result += '$';
      result += c;
    }
    return result;
  };
  std::string text = escaped(target) + ":";
  for (const std::string& dependency : dependencies) text += " \\\n  " + escaped(dependency);
  return text + "\n";
}

}  // namespace physgen::command
