// The program of the scene linear_elastic over its arrays: scenes::linear_elastic_scene::fused::program(on, ...).
// Written by physgen from scenes/linear_elastic.h: change that, not this file.
#pragma once

#include "scenes/linear_elastic.h"
#include "linear_elastic.scene.h"

namespace scenes::linear_elastic_scene {

/// The scene: none of its program's steps are joined.
using fused = ::scenes::linear_elastic;

}  // namespace scenes::linear_elastic_scene
