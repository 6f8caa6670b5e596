// The program of the scene force_chain over its arrays: scenes::force_chain_scene::fused::program(on, ...). Written by
// physgen from scenes/force_chain.h: change that, not this file.
#pragma once

#include "scenes/force_chain.h"
#include "force_chain.scene.h"

namespace scenes::force_chain_scene {

/// The scene: none of its program's steps are joined.
using fused = ::scenes::force_chain;

}  // namespace scenes::force_chain_scene
