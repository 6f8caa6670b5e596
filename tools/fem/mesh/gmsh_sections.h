// The nodes and elements of a file in Gmsh's format as they stand there, under the file's numbers (tags).
#pragma once

#include <fem/mesh/gmsh_input.h>
#include <fem/mesh/mesh.h>

#include <array>
#include <cstdint>
#include <vector>

namespace physgen::fem {

/// In the file's order. Places are offsets in the file [bytes].
struct GmshSections {
  std::vector<std::uint64_t> node_tags, node_places;
  std::vector<Point> nodes;
  std::vector<std::uint64_t> tet_tags, tet_places;
  std::vector<std::array<std::uint64_t, 4>> tets;  ///< tags of their nodes
  struct Use {
    std::uint64_t element, node;
  };
  std::vector<Use> others;  ///< nodes of points, lines and surfaces
  double version = 1;
};

/// Reads the sections of nodes and elements, and passes over all others. Memory is taken for what the file has, not for
/// what it counts.
/// @throw Error with the file's name, the line (in binary files the byte) and a remedy: where a section is cut off, has
/// more or fewer rows than it counts or other things than numbers, the version is another than 1, 2 to 2.2 or 4.1, or
/// the elements with volume are others than linear tets or more than make_tet_mesh() takes
[[nodiscard]] GmshSections read_gmsh_sections(GmshInput& input);

}  // namespace physgen::fem
