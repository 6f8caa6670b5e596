// Finds the fields that a scene's program reads and writes, on one side or on both: analyses the units that
// probe_unit.h writes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenes/scene.h"
#include "usage/analyse.h"

namespace physgen::scenes {

struct Analysis {
  std::optional<usage::Usage> usage;            ///< of all sides, united; none: a unit has errors
  std::vector<usage::Diagnostics> diagnostics;  ///< of each side
};

/// @param declaration path of the scene's file
/// @param sides one at least. Arrays that programs are compared over have what is needed on any of them
/// @param reader of the first side's unit
[[nodiscard]] Analysis analyse(const Scene& scene, const std::string& declaration,
                               const std::vector<std::string>& flags, const std::vector<usage::Side>& sides,
                               const usage::Reader& reader = {});

}  // namespace physgen::scenes
