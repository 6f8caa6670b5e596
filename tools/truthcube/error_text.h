// What an error says to a user.
#pragma once

#include <exception>
#include <string>

namespace physgen::truthcube {

/// Without the library's name before it.
[[nodiscard]] inline std::string text_of(const std::exception& error) {
  const std::string text = error.what(), prefix = "physgen: ";
  return text.starts_with(prefix) ? text.substr(prefix.size()) : text;
}

}  // namespace physgen::truthcube
