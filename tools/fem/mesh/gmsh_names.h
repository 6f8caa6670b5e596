// Names of physical groups in a file of Gmsh's format, and the entities of version 4.1 that belong to them.
#pragma once

#include <fem/mesh/gmsh_input.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace physgen::fem {

/// A physical group: its dimension and number are what elements or entities name.
struct GmshName {
  int dimension;
  std::int64_t number;
  std::string name;
};

/// An entity of version 4.1, to which elements belong.
struct GmshEntity {
  int dimension;
  std::int64_t tag;
  std::vector<std::int64_t> groups;  ///< numbers of those that it belongs to
};

/// Reads the rows of $PhysicalNames, which are text in binary files, too. @return how many rows there should be
/// @throw Error with the place, for rows that are no names, or other numbers of them than are counted
std::uint64_t read_gmsh_names(GmshInput& input, std::string_view end, std::vector<GmshName>& to);

/// Reads the rows of $Entities of version 4.1. @return how many rows there should be
/// @throw Error with the place, for rows that are no entities, or other numbers of them than are counted
std::uint64_t read_gmsh_entities(GmshInput& input, std::string_view end, std::vector<GmshEntity>& to);

}  // namespace physgen::fem
