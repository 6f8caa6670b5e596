// Physical groups of a file in Gmsh's format, and the groups of a mesh made of them.
#pragma once

#include <fem/mesh/gmsh_sections.h>
#include <fem/mesh/groups.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

/// A group under the file's numbers (tags).
struct GmshGroup {
  std::string name;
  std::vector<std::uint64_t> nodes;  ///< of elements that are not among the next
  std::vector<std::array<std::uint64_t, 2>> lines;
  std::vector<std::array<std::uint64_t, 3>> faces;
  std::vector<std::uint64_t> tets;
};

/// Groups in the order in which the file names them, one for each name. @pre tets are in the file's order
[[nodiscard]] std::vector<GmshGroup> gmsh_groups_of(const GmshSections& file);

/// The same under numbers from 0. What has a node that the mesh leaves out is left out, too.
/// @param node_tags, tet_tags ascending
[[nodiscard]] std::vector<MeshGroup> number_groups(const std::vector<GmshGroup>& groups,
                                                   std::span<const std::size_t> node_tags,
                                                   std::span<const std::size_t> tet_tags,
                                                   std::span<const std::array<Index, 4>> tets);

}  // namespace physgen::fem
