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
    const fs::path temporary =
        path.parent_path() / ("." + path.filename().string() + "." + std::to_string(::getpid()) + ".tmp");
    errno = 0;
    std::ofstream out(temporary, std::ios::binary);
    if (!out) fail("write", path, last_error());
    moves_.push_back({temporary, path});
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

void make_folder_of(const fs::path& path) {
  if (path.parent_path().empty()) return;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) fail("make the folder", path.parent_path(), error);
}

}  // namespace

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

void touch(const std::string& path) {
  make_folder_of(path);
  errno = 0;
  if (!std::ofstream(path, std::ios::binary)) fail("write", path, last_error());
  std::error_code error;
  fs::last_write_time(path, fs::file_time_type::clock::now(), error);
  if (error) fail("set the time of", path, error);
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
