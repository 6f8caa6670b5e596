#include "names.h"

#include <fem/mesh/nearest_name.h>

#include <array>
#include <charconv>

namespace physgen::truthcube {

std::string unknown(const std::string& kind, const std::string& word, const std::vector<std::string>& words) {
  const std::string near = fem::nearest_name(word, words);
  return "there is no " + kind + " " + word + (near.empty() ? "." : "; did you mean " + near + "?");
}

std::string number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace physgen::truthcube
