// The header that a scene's program is compiled with: for each group a struct of arrays that hold the fields which the
// program needs, and no others.
#pragma once

#include <string>

#include "scenes/needs.h"

namespace physgen::scenes {

/// "force_chain.scene.h", with the other ending for what else is written of a scene.
[[nodiscard]] std::string file_of(const Scene& scene, const std::string& ending = ".scene.h");

/// The same text for the same scene and needs.
/// @param suffix of the namespace that the structs stand in: "_scene" gives scenes::force_chain_scene
/// @pre needs.sound(), and they are of this scene
[[nodiscard]] std::string header(const Scene& scene, const Needs& needs, const std::string& suffix = "_scene");

}  // namespace physgen::scenes
