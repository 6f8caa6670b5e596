// Reads a schema with Clang and gives its model. The only part of physgen that knows Clang; no Clang type leaves it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "model/validate.h"

namespace physgen::frontend {

struct ParseOptions {
  std::vector<std::string> include_dirs;  ///< where #include looks, beside the including file's own folder
  model::Rules objections = nullptr;  ///< an emitter's rules, beyond those of the model; null: nothing is to be written
};

struct Result {
  std::optional<model::Schema> schema;    ///< none: the schema has errors
  std::string diagnostics;                ///< errors and warnings as Clang prints them, with source line and caret
  std::vector<std::string> dependencies;  ///< files that were read, as they were named; the schema first
};

/// Parses one schema and checks it completely: all its errors are reported, not only the first. The parse is hermetic:
/// <physgen/schema.h> is built in, the system's headers and the host's target are not used.
/// @pre the file at `path` can be read; if not, that is the one error
[[nodiscard]] Result parse(const std::string& path, const ParseOptions& options = {});

}  // namespace physgen::frontend
