// Finds faults of a text in Gmsh's format that the Gmsh library passes over in silence, such as lines beyond those
// that a section counts, or a file that is cut off in its last number.
#pragma once

#include <istream>
#include <string>

namespace physgen::fem {

/// Reads a .msh file from its beginning: whether each section ends, and those of nodes and elements have as many lines
/// as they say, of numbers alone, and before version 4 a number for each node and element. Of a binary file: whether it
/// ends with the end of a section.
/// @return the first fault, with its line and a remedy; empty where there is none
[[nodiscard]] std::string fault_in_gmsh_text(std::istream& file);

}  // namespace physgen::fem
