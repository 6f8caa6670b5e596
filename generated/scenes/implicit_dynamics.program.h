// The program of the scene implicit_dynamics over its arrays: scenes::implicit_dynamics_scene::fused::program(on, ...).
// Written by physgen from scenes/implicit_dynamics.h: change that, not this file.
#pragma once

#include "scenes/implicit_dynamics.h"
#include "implicit_dynamics.scene.h"

namespace scenes::implicit_dynamics_scene {

/// The scene: none of its program's steps are joined.
using fused = ::scenes::implicit_dynamics;

}  // namespace scenes::implicit_dynamics_scene
