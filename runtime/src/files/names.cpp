// See names.h.
#include "names.h"

#include <physgen/error.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace physgen::files {

namespace {

/// How many letters are changed, added or left out between two words.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t before = std::exchange(row[0], i + 1);
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::size_t changed = before + (a[i] == b[k] ? 0 : 1);
      before = row[k + 1];
      row[k + 1] = std::min({changed, row[k] + 1, before + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

std::string nearest_first(const std::string& word, std::vector<std::string> names) {
  constexpr std::size_t most = 12;
  if (names.empty()) return "; it has none";
  std::stable_sort(names.begin(), names.end(),
                   [&](const std::string& a, const std::string& b) { return distance(word, a) < distance(word, b); });
  const bool more = names.size() > most;
  names.resize(std::min(names.size(), most));
  return "; it has " + list(names) + (more ? " and others" : "");
}

bool has(std::span<const std::string> names, std::string_view word) {
  return std::find(names.begin(), names.end(), word) != names.end();
}

std::vector<std::string> stored_fields(const UntypedArray& array, std::span<const std::string> asked,
                                       const std::string& place) {
  std::vector<std::string> stored;
  for (const FieldInfo& field : array.fields)
    if (field.is_stored()) stored.emplace_back(field.name);
  for (const std::string& field : asked)
    if (!has(stored, field))
      throw Error(place + ": the array stores no field '" + field + "'" + nearest_first(field, stored));
  return stored;
}

}  // namespace physgen::files
