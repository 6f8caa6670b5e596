// The nodes, elements and names of a file in Gmsh's format as they stand there, under the file's numbers (tags).
#pragma once

#include <fem/mesh/gmsh_input.h>
#include <fem/mesh/gmsh_names.h>
#include <fem/mesh/mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace physgen::fem {

/// In the file's order. Places are offsets in the file [bytes].
struct GmshSections {
  std::vector<std::uint64_t> node_tags, tet_tags;
  HostList<std::uint64_t> node_places, tet_places;
  std::vector<Point> nodes;
  HostList<std::array<std::uint64_t, 4>> tets;  ///< tags of their nodes
  struct Use {
    std::uint64_t element, node;
  };
  std::vector<Use> others;  ///< nodes of points, lines and surfaces
  /// Elements of one type and owner that follow each other: from `first` of tets, or of the others' nodes, on.
  struct Run {
    int dimension;
    std::int64_t owner;  ///< in version 4.1 an entity, before a physical group, or 0
    int type;
    std::size_t first, count;
  };
  std::vector<Run> runs;
  std::vector<GmshName> names;
  std::vector<GmshEntity> entities;  ///< of version 4.1, that belong to groups
  double version = 1;

  /// @param at the number of the first entry of `count` elements among tets, or among the others' nodes
  void add_to_run(int dimension, std::int64_t owner, int type, std::size_t at, std::size_t count) {
    if (runs.empty() || runs.back().dimension != dimension || runs.back().owner != owner || runs.back().type != type) {
      runs.push_back({dimension, owner, type, at, 0});
    }
    runs.back().count += count;
  }
};

/// Reads the sections of nodes, elements, entities and names of physical groups, and passes over all others. Memory is
/// taken for what the file has, not for what it counts.
/// @throw Error with the file's name, the line (in binary files the byte) and a remedy: where a section is cut off, has
/// more or fewer rows than it counts or other things than numbers, the version is another than 1, 2 to 2.2 or 4.1, or
/// the elements with volume are others than linear tets or more than make_tet_mesh() takes
[[nodiscard]] GmshSections read_gmsh_sections(GmshInput& input);

}  // namespace physgen::fem
