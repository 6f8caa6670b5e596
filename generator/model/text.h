// Small pieces of the texts that people read: names in quotes, numbers, lists, and names that were misspelt.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace physgen::model {

/// `name` in the quotes of a message.
[[nodiscard]] inline std::string in_quotes(std::string_view name) { return "'" + std::string(name) + "'"; }

/// Shortest text that reads back as `value`: "0.5", "1e-12", "3".
[[nodiscard]] std::string number(double value);

/// "a, b or c" where `last` is " or ".
[[nodiscard]] std::string joined(const std::vector<std::string>& words, std::string_view last = ", ");

/// The name among `names` that `word` is most like; empty: it is like none.
[[nodiscard]] std::string nearest(const std::string& word, const std::vector<std::string>& names);

/// "there is no KIND 'word'; did you mean 'x'?", or, where it is like none, what there is.
[[nodiscard]] std::string unknown(const std::string& kind, const std::string& word,
                                  const std::vector<std::string>& names);

}  // namespace physgen::model
