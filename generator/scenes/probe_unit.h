// The translation unit that instantiates a scene's program over probes: what physgen analyses, and what any compiler
// can be given to find the same sets by registration.
#pragma once

#include <string>

#include "scenes/scene.h"

namespace physgen::scenes {

/// @param space "Host" or "Cuda"
/// @param declaration how the unit includes the scene's file: its path
[[nodiscard]] std::string probe_unit(const Scene& scene, const std::string& space, const std::string& declaration);

}  // namespace physgen::scenes
