// The translation unit that instantiates a scene's program over probes: what physgen analyses, and what any compiler
// can be given to find the same sets by registration. And what physgen goes on with: the same program over the arrays
// that it then has, to be compared.
#pragma once

#include <string>

#include "scenes/scene.h"
#include "usage/usage.h"

namespace physgen::scenes {

/// @param space "Host" or "Cuda"
/// @param declaration how the unit includes the scene's file: its path
[[nodiscard]] std::string probe_unit(const Scene& scene, const std::string& space, const std::string& declaration);

/// The text behind probe_unit()'s: the program over arrays with all fields, and over arrays with those that it needs;
/// both have read-only views and single records where generated ones have them. Code that is not the same over all
/// three depends on how fields are stored.
/// @param usage of the program, over probes
[[nodiscard]] std::string rest_of_unit(const Scene& scene, const usage::Usage& usage);

}  // namespace physgen::scenes
