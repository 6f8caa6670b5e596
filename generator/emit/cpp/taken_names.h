// Names that other headers take before generated code is compiled: macros, which no scope keeps out, and names of the C
// library outside all namespaces.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>

namespace physgen::emit::cpp {

[[nodiscard]] inline bool is_one_of(std::string_view name, std::span<const std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}

/// Capitals, digits and an underscore, as in INT_MAX: the form of nearly all macros of system headers, too many to
/// list. J2, EA or K are none.
[[nodiscard]] bool is_written_as_a_macro(std::string_view name);

/// Words of C++20 that schemas are parsed without: and, bitor, char8_t. (Clang reports all others.)
[[nodiscard]] bool is_word_of_the_language(std::string_view name);

/// Known macros of another form: EOF, NAN, M_PIf, offsetof.
[[nodiscard]] bool is_macro(std::string_view name);

/// Functions, types and variables that <cmath>, <ctime>, <unistd.h> and the like declare outside all namespaces, so
/// that nothing else can be called so there: index, time, div, tm.
[[nodiscard]] bool is_name_of_the_c_library(std::string_view name);

}  // namespace physgen::emit::cpp
