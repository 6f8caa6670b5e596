// Meshes from files in Gmsh's format (https://gmsh.info), read without Gmsh.
#pragma once

#include <fem/mesh/groups.h>
#include <fem/mesh/mesh.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <vector>

namespace physgen::fem {

/// Linear tets as they stand in a file, ascending by tag; nothing is checked that check_mesh() checks.
struct ReadMesh {
  std::vector<Point> rest;                  ///< in the file's unit of length
  std::vector<std::array<Index, 4>> tets;   ///< numbers in rest, corners in the file's order
  std::vector<std::size_t> node_tags;       ///< per node: its number in the file
  std::vector<std::size_t> tet_tags;        ///< per tet: its number in the file
  std::vector<std::size_t> left_out_nodes;  ///< tags of nodes that are left out, ascending
  std::vector<MeshGroup> groups;            ///< physical groups with a name, in the order of the file's names
};

/// Reads a .msh file of version 1, 2 to 2.2 or 4.1, as text or as bytes in this machine's order. Elements of points,
/// lines and surfaces are passed over but for groups. Nodes that only those use are left out and listed, and in
/// versions before 4 all nodes of no tet, as Gmsh does; in version 4.1 nodes that no element uses are kept, for
/// check_mesh() to tell of. What stands in the file twice under one tag with the same values is read once. Takes the
/// speed of std::from_chars for texts; of other files that of memory.
/// @throw Error with the file's name, the line or byte, and a remedy: when the file cannot be read, is not in Gmsh's
/// format or one of those versions, is cut off, has more or fewer rows than it counts, two nodes or tets of one tag, no
/// tets, tets of second or higher order, other elements with volume, an element with a node that the file does not
/// have, or more nodes or tets than 32-bit numbers can count (said before memory is taken for them)
[[nodiscard]] ReadMesh read_gmsh(const std::filesystem::path& path);

}  // namespace physgen::fem
