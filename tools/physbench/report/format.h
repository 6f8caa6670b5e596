// Text in the manner of printf, for the tables.
#pragma once

#include <cstdio>
#include <string>

namespace physgen::bench {

/// @return what printf would print, up to 255 characters
template <class... Argument>
std::string format(const char* pattern, Argument... arguments) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, arguments...);
  return text;
}

}  // namespace physgen::bench
