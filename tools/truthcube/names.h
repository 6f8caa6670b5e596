// Words of a command line: choices by name, the name that a misspelt one is near to, and numbers.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace physgen::truthcube {

/// "there is no flag --cels; did you mean --cells?", or with a full stop where no word is near. @param kind "flag",
/// "material", ...
[[nodiscard]] std::string unknown(const std::string& kind, const std::string& word,
                                  const std::vector<std::string>& words);

/// The shortest text that stands for this number: "0.1", "1e-09"
[[nodiscard]] std::string number(double value);

/// "a, b, c"
[[nodiscard]] std::string joined(const std::vector<std::string>& words);

/// Values by name, in the order in which they are listed.
template <class Value>
using Names = std::vector<std::pair<std::string, Value>>;

template <class Value>
[[nodiscard]] std::vector<std::string> words_of(const Names<Value>& names) {
  std::vector<std::string> words;
  for (const auto& [word, value] : names) words.push_back(word);
  return words;
}

template <class Value>
[[nodiscard]] std::string name_of(const Names<Value>& names, const Value& wanted) {
  for (const auto& [word, value] : names) {
    if (value == wanted) return word;
  }
  return "?";
}

}  // namespace physgen::truthcube
