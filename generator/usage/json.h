// The usage of programs as JSON, which is written to files and read back to be compared.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "usage/usage.h"

namespace physgen::usage {

/// A text that is no JSON of to_json(); what() says where.
struct JsonError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The same bytes for the same programs.
[[nodiscard]] std::string to_json(const std::vector<Program>& programs);

/// @throws JsonError
[[nodiscard]] std::vector<Program> from_json(const std::string& text);

}  // namespace physgen::usage
