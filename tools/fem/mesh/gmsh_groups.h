// Physical groups of a file in Gmsh's format: their names, what belongs to them, and the groups of a mesh made of that.
#pragma once

#include <fem/mesh/gmsh_input.h>
#include <fem/mesh/gmsh_sections.h>
#include <fem/mesh/groups.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace physgen::fem {

/// Reads the rows of $PhysicalNames, which are text in binary files, too. @return how many rows there should be
/// @throw Error with the place, for rows that are no names, or other numbers of them than are counted
std::uint64_t read_gmsh_names(GmshInput& input, std::string_view end, GmshSections& file);

/// Reads the rows of $Entities of version 4.1. @return how many rows there should be
/// @throw Error with the place, for rows that are no entities, or other numbers of them than are counted
std::uint64_t read_gmsh_entities(GmshInput& input, std::string_view end, GmshSections& file);

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
