// The program of a scene over its generated arrays: the scene's own text, with groups of steps written as one.
#pragma once

#include <string>

#include "scenes/needs.h"
#include "scenes/program.h"

namespace physgen::scenes {

/// A header that declares `fused` in the namespace of the scene's arrays: a struct with the program, or, where no steps
/// are joined, another name of the scene. @pre needs.groups are of this program
[[nodiscard]] std::string program_header(const Scene& scene, const Needs& needs, const ProgramText& program);

/// The text of the program with the steps of these groups joined. All else stays as it is.
[[nodiscard]] std::string joined_text(const Needs& needs, const ProgramText& program);

}  // namespace physgen::scenes
