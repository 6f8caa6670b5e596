// Names of fields, and in messages.
#pragma once

#include <physgen/arrays/untyped_array.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace physgen::files {

/// "'a', 'b'"
[[nodiscard]] std::string list(const std::vector<std::string>& names);
/// "; it has 'a', 'b'": those most like `word` come first, and a dozen at most.
[[nodiscard]] std::string nearest_first(const std::string& word, std::vector<std::string> names);

[[nodiscard]] bool has(std::span<const std::string> names, std::string_view word);
/// The fields that an array stores. @throw Error, beginning with `place`, where one that is asked for is not among them
[[nodiscard]] std::vector<std::string> stored_fields(const UntypedArray& array, std::span<const std::string> asked,
                                                     const std::string& place);

}  // namespace physgen::files
