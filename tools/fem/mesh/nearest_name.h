// The name of a list that a misspelt one is nearest to, for messages.
#pragma once

#include <string>
#include <vector>

namespace physgen::fem {

/// The word of the list that takes the fewest changes of letters to become `word`; "" when each takes more than half of
/// its letters.
[[nodiscard]] std::string nearest_name(const std::string& word, const std::vector<std::string>& words);

}  // namespace physgen::fem
