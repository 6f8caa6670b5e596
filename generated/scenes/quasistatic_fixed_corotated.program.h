// The program of the scene quasistatic_fixed_corotated over its arrays:
// scenes::quasistatic_fixed_corotated_scene::fused::program(on, ...). Written by physgen from
// scenes/quasistatic_fixed_corotated.h: change that, not this file.
#pragma once

#include "scenes/quasistatic_fixed_corotated.h"
#include "quasistatic_fixed_corotated.scene.h"

namespace scenes::quasistatic_fixed_corotated_scene {

/// The scene: none of its program's steps are joined.
using fused = ::scenes::quasistatic_fixed_corotated;

}  // namespace scenes::quasistatic_fixed_corotated_scene
