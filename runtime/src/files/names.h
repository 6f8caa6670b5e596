// Names in messages.
#pragma once

#include <string>
#include <vector>

namespace physgen::files {

/// "'a', 'b'"
[[nodiscard]] std::string list(const std::vector<std::string>& names);
/// "; it has 'a', 'b'": those most like `word` come first, and a dozen at most.
[[nodiscard]] std::string nearest_first(const std::string& word, std::vector<std::string> names);

}  // namespace physgen::files
