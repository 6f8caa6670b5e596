// The program of the scene quasistatic_matrix_free over its arrays:
// scenes::quasistatic_matrix_free_scene::fused::program(on, ...). Written by physgen from
// scenes/quasistatic_matrix_free.h: change that, not this file.
#pragma once

#include "scenes/quasistatic_matrix_free.h"
#include "quasistatic_matrix_free.scene.h"

namespace scenes::quasistatic_matrix_free_scene {

/// The scene: none of its program's steps are joined.
using fused = ::scenes::quasistatic_matrix_free;

}  // namespace scenes::quasistatic_matrix_free_scene
