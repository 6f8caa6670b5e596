// Errors and notes about a scene, and the names by which they call its steps.
#pragma once

#include <string>

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

}  // namespace physgen::scenes
