// The program of the scene everything over its arrays: scenes::everything_scene::fused::program(on, ...). Written by
// physgen from scenes/everything.h: change that, not this file.
#pragma once

#include "scenes/everything.h"
#include "everything.scene.h"

namespace scenes::everything_scene {

/// The scene: none of its program's steps are joined.
using fused = ::scenes::everything;

}  // namespace scenes::everything_scene
