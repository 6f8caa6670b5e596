// The head of a file in Gmsh's format. The format is described in Gmsh's reference manual, chapters "MSH file format"
// and its "legacy" versions 1 and 2.
#pragma once

#include <fem/mesh/gmsh_input.h>

namespace physgen::fem {

/// Reads what follows $MeshFormat, and says to the input whether the file is binary.
/// @return the version
/// @throw Error when it is another than 2 to 2.2 or 4.1, or the file has numbers of another size or order of bytes
[[nodiscard]] double read_gmsh_format(GmshInput& input);

}  // namespace physgen::fem
