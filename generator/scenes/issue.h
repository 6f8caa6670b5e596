// Errors and notes about a scene, and the names by which they call its steps and fields.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scenes/scene.h"
#include "usage/usage.h"

namespace physgen::scenes {

struct Issue {
  enum class Kind { error, note } kind = Kind::error;
  Location place;
  std::string message;  ///< what is wrong and what to write instead, one line without a full stop
  bool operator==(const Issue&) const = default;
};

/// "physgen::fem::ComputeSvd(body.gradients, body.svds)"
[[nodiscard]] std::string name_of(const usage::StepUse& step);

using FieldName = std::pair<std::string, std::string>;  ///< array, field

[[nodiscard]] inline FieldName name_of(const usage::FieldUse& use) { return {use.array, use.field}; }
[[nodiscard]] inline std::string text_of(const FieldName& field) { return field.first + "." + field.second; }
[[nodiscard]] inline bool reads(const usage::FieldUse& use) { return use.read || use.address_taken; }
[[nodiscard]] inline bool writes(const usage::FieldUse& use) { return use.written || use.address_taken; }
[[nodiscard]] inline Location location(const usage::Place& place) { return {place.file, place.line, place.column}; }

/// "a, b and c"; of many, the first few.
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

}  // namespace physgen::scenes
