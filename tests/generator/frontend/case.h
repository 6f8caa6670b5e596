// One schema with errors and what the frontend must say about it; parsing schemas that stand in tests.
#pragma once

#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "emit/emitter.h"
#include "frontend/frontend.h"

namespace physgen::test {

struct DiagnosticCase {
  std::string name;                   ///< "reports_" in front of it is the test's name
  std::string schema;                 ///< as schema_of() takes it, which begins it with two lines
  std::vector<std::string> expected;  ///< beginnings of the diagnostics, "line:column: error: ..."
};

/// The words that GoogleTest prints for a case.
inline void PrintTo(const DiagnosticCase& diagnostic, std::ostream* out) { *out << diagnostic.name; }

/// A schema with these declarations in a namespace m; they begin on line 3.
inline std::string schema_of(const std::string& declarations) {
  return "#include <physgen/schema.h>\nnamespace m { using namespace physgen::schema;\n" + declarations + "}\n";
}

/// An object A with these members on its second line.
inline std::string object(const std::string& members) { return "struct PHYSGEN_OBJECT() A {\n  " + members + "\n};\n"; }

/// A new empty folder, removed with all it holds at the end of its life.
class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "physgen_test_XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make a folder " + pattern);
    path_ = pattern;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  /// Writes a file and gives its path.
  std::string write(const std::string& name, const std::string& text) const {
    const auto path = path_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }
  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Parses a schema of which C++ is to be written.
inline frontend::Result parse_file(const std::string& path, const std::vector<std::string>& include_dirs = {}) {
  return frontend::parse(path, {include_dirs, emit::emitters().front().objections});
}

/// Parses `text` as the schema schema.h.
inline frontend::Result parse_text(const std::string& text) {
  const Folder folder;
  return parse_file(folder.write("schema.h", text));
}

/// The diagnostics' first lines without file names: "4:3: error: ...".
inline std::vector<std::string> headlines(const std::string& diagnostics) {
  std::vector<std::string> result;
  const std::string mark = "schema.h:";
  for (std::size_t begin = 0; begin < diagnostics.size();) {
    const std::size_t end = std::min(diagnostics.find('\n', begin), diagnostics.size());
    const std::string line = diagnostics.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t place = line.find(mark);
    const bool built_in = line.starts_with("/physgen.builtin/");  // a note about the vocabulary
    if (place != std::string::npos && !built_in && line.front() == '/')
      result.push_back(line.substr(place + mark.size()));
  }
  return result;
}

}  // namespace physgen::test
