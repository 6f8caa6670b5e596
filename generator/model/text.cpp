// See text.h.
#include "model/text.h"

#include <algorithm>
#include <charconv>

namespace physgen::model {
namespace {

/// How many letters are changed, added, left out or exchanged with their neighbour between two words.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t k = 0; k <= b.size(); ++k) {
      if (i == 0 || k == 0) {
        table[i][k] = i + k;
        continue;
      }
      const std::size_t changed = table[i - 1][k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1);
      table[i][k] = std::min({changed, table[i - 1][k] + 1, table[i][k - 1] + 1});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        table[i][k] = std::min(table[i][k], table[i - 2][k - 2] + 1);
    }
  return table[a.size()][b.size()];
}

}  // namespace

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string joined(const std::vector<std::string>& words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 < words.size() ? ", " : last;
    text += words[i];
  }
  return text;
}

std::string nearest(const std::string& word, const std::vector<std::string>& names) {
  std::string best;
  std::size_t least = word.size() / 2 + 1;
  for (const std::string& name : names)
    if (const std::size_t changes = distance(word, name); changes < least) {
      least = changes;
      best = name;
    }
  return best;
}

std::string unknown(const std::string& kind, const std::string& word, const std::vector<std::string>& names) {
  const std::string near = nearest(word, names);
  std::string other = "did you mean '" + near + "'?";
  if (near.empty()) {
    constexpr std::size_t most = 12;
    other = "there are " +
            (names.size() <= most ? joined(names, " and ") : joined({names.begin(), names.begin() + most}) + ", ...");
  }
  return "there is no " + kind + " '" + word + "'; " + other;
}

}  // namespace physgen::model
