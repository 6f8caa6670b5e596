// Meshes from files in Gmsh's format, read by the Gmsh library. Part of the library physgen_gmsh, which is built where
// that library is found; PHYSGEN_HAVE_GMSH is then defined for what links it.
#pragma once

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
  std::vector<std::size_t> left_out_nodes;  ///< tags of nodes that only points, lines or surfaces use, ascending
};

/// Reads a .msh file of any version that the Gmsh library reads (1 to 4.1, text and binary). Elements of points, lines
/// and surfaces are passed over. Nodes that only those use are left out and listed; nodes that no element uses are
/// kept, for check_mesh() to tell of (of versions before 4 Gmsh itself drops them). Prints nothing; the process's
/// locale and number of OpenMP threads, which Gmsh changes, are put back. Calls from several threads wait for each
/// other.
/// The Gmsh library itself may crash on a damaged file (4.8.4 did on 2 of 300 with a few bytes changed at random).
/// @throws Error with the file's name, what Gmsh said or the line, and a remedy: when the file cannot be read, is not
/// in Gmsh's format (Gmsh would run it as a script), is cut off, has more or fewer lines than it counts, has no tets,
/// tets of second or higher order, or other elements with volume, or more than 2^31 nodes
[[nodiscard]] ReadMesh read_gmsh(const std::filesystem::path& path);

}  // namespace physgen::fem
