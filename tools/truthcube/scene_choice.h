// Scenes by name: each makes choices that other flags make, too, and refuses what does not fit them.
#pragma once

#include <functional>
#include <string>

#include "names.h"
#include "options.h"

namespace physgen::truthcube {

extern const Names<SceneKind> scene_kinds;

/// Makes the choices that options.scene stands for.
/// @param given whether a flag, such as "--product", stands in the command line
/// @throw Error when one does that chooses otherwise, or that the scene has no use for
void apply_scene(Options& options, const std::function<bool(const std::string&)>& given);

/// @throw Error for times, density or damping out of range
void check_motion(const MotionOptions& motion);

}  // namespace physgen::truthcube
