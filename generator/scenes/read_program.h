// Reads the text of a scene's program, with Clang: its statements, in the unit that instantiates it over probes.
#pragma once

#include <string>
#include <vector>

#include "scenes/program.h"
#include "scenes/scene.h"

namespace clang {
class ASTContext;
}

namespace physgen::scenes {

/// @param context of probe_unit(), without errors
/// @param folders in which #include looks: files are named without them
[[nodiscard]] ProgramText read_program(clang::ASTContext& context, const Scene& scene,
                                       const std::vector<std::string>& folders);

}  // namespace physgen::scenes
