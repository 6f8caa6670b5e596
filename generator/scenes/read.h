// Reads the declaration of a scene with Clang. The only file of this folder that knows it; no Clang type leaves it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace physgen::scenes {

struct Declaration {
  std::optional<Scene> scene;             ///< none: the declaration has errors
  std::string diagnostics;                ///< as Clang prints them, with source line and caret
  std::vector<std::string> dependencies;  ///< files that were read, without those of the system
};

/// Parses the one scene that `path` declares, and reports all that is wrong with its declaration.
/// @param flags as of a compiler; folders of -I tell how generated headers name the file
[[nodiscard]] Declaration read(const std::string& path, const std::vector<std::string>& flags);

}  // namespace physgen::scenes
