// The program of the scene explicit_dynamics over its arrays: scenes::explicit_dynamics_scene::fused::program(on, ...).
// Written by physgen from scenes/explicit_dynamics.h: change that, not this file.
#pragma once

#include "scenes/explicit_dynamics.h"
#include "explicit_dynamics.scene.h"

namespace scenes::explicit_dynamics_scene {

/// The scene: none of its program's steps are joined.
using fused = ::scenes::explicit_dynamics;

}  // namespace scenes::explicit_dynamics_scene
