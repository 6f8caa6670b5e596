// The program of the scene linear_elastic_assembled over its arrays:
// scenes::linear_elastic_assembled_scene::fused::program(on, ...). Written by physgen from
// scenes/linear_elastic_assembled.h: change that, not this file.
#pragma once

#include "scenes/linear_elastic_assembled.h"
#include "linear_elastic_assembled.scene.h"

namespace scenes::linear_elastic_assembled_scene {

/// The scene: none of its program's steps are joined.
using fused = ::scenes::linear_elastic_assembled;

}  // namespace scenes::linear_elastic_assembled_scene
