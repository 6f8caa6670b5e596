// The program of the scene quasistatic over its arrays: scenes::quasistatic_scene::fused::program(on, ...). Written by
// physgen from scenes/quasistatic.h: change that, not this file.
#pragma once

#include "scenes/quasistatic.h"
#include "quasistatic.scene.h"

namespace scenes::quasistatic_scene {

/// The scene: none of its program's steps are joined.
using fused = ::scenes::quasistatic;

}  // namespace scenes::quasistatic_scene
