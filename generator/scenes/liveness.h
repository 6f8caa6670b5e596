// Which steps of a program are live, and which fields are wanted: the fixpoint of needs.h.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scenes/issue.h"
#include "scenes/scene.h"
#include "usage/usage.h"

namespace physgen::scenes {

using FieldName = std::pair<std::string, std::string>;  ///< array, field

[[nodiscard]] inline FieldName name_of(const usage::FieldUse& use) { return {use.array, use.field}; }
[[nodiscard]] inline std::string text_of(const FieldName& field) { return field.first + "." + field.second; }
[[nodiscard]] inline bool reads(const usage::FieldUse& use) { return use.read || use.address_taken; }
[[nodiscard]] inline bool writes(const usage::FieldUse& use) { return use.written || use.address_taken; }
[[nodiscard]] inline Location location(const usage::Place& place) { return {place.file, place.line, place.column}; }

/// "a, b and c"; of many, the first few.
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

struct Liveness {
  std::set<FieldName> wanted;   ///< outputs, and what live steps and code outside of steps read
  std::set<FieldName> written;  ///< by live steps and code outside of steps
  bool complete = true;         ///< all names are the scene's, and all uses are known
  std::vector<Issue> errors;    ///< of steps and of names that the scene has not
};

[[nodiscard]] Liveness find_liveness(const Scene& scene, const usage::Usage& usage);

}  // namespace physgen::scenes
