// The tets of a mesh in the order of their materials, which groups of it name.
#pragma once

#include <fem/mesh/gmsh_file.h>

#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

/// Brings the tets of no named group to the front and those of each group behind them, in the order of the names;
/// within a material they keep their order. Groups and the numbers of elements follow.
/// @return for each material, the first being that of no group, the number behind its last tet
/// @throw Error when there is no such group, it has no tets, or a tet is in two of them
[[nodiscard]] std::vector<Index> sort_by_material(ReadMesh& mesh, std::span<const std::string> groups);

}  // namespace physgen::fem
