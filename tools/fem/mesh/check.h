// Finds the faults of a mesh that somebody else made, in words that say where and what to do. For meshes as they come
// from a file, before make_tet_mesh(), which refuses most of this less kindly.
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

/// The number of times that something was found, and the first places: numbers from 0 of nodes or tets, ascending.
struct Finding {
  static constexpr std::size_t shown = 5;

  std::size_t count = 0;
  std::vector<std::size_t> first;
};

/// Tets that hang together by common nodes.
struct Component {
  std::size_t nodes, tets;
  Index lowest_node, lowest_tet;
  bool operator==(const Component&) const = default;
};

struct MeshReport {
  /// A tet is flat, and its sign of volume means nothing, when |6 V| <= flat_limit times its longest edge cubed.
  static constexpr double flat_limit = 1e-9;

  std::size_t nodes = 0, tets = 0;
  bool too_large = false;              ///< more than 32-bit numbers hold; nothing else was looked at then
  Finding out_of_range;                ///< tets that name a node which does not exist
  Finding not_finite;                  ///< nodes with a coordinate that is NaN or infinite
  Finding flat;                        ///< tets without volume, those that name a node twice among them
  Finding inverted;                    ///< tets of negative volume that are not flat
  Finding duplicates;                  ///< tets with the same four nodes as one before
  std::vector<std::size_t> originals;  ///< per entry of duplicates.first: the first tet with those nodes
  Finding crowded;                     ///< one tet of each face that belongs to more than two tets, duplicates apart
  Finding unreferenced;                ///< nodes of no tet: nothing holds them, so no system with them can be solved
  std::size_t component_count = 0;
  std::vector<Component> components;  ///< the first Finding::shown of them, by their lowest node

  /// The faults that refuse a run, a sentence with places and remedy each: all of the above but several components, and
  /// a mesh without tets. Places are named by the given tags (a file's own numbers) or, without them, by numbers from
  /// 0.
  [[nodiscard]] std::vector<std::string> errors(std::span<const std::size_t> node_tags = {},
                                                std::span<const std::size_t> tet_tags = {}) const;
  /// The findings that a user should know: several components.
  [[nodiscard]] std::vector<std::string> warnings(std::span<const std::size_t> node_tags = {},
                                                  std::span<const std::size_t> tet_tags = {}) const;
  /// A line with the sizes, then a line for each error and warning.
  [[nodiscard]] std::string describe(std::span<const std::size_t> node_tags = {},
                                     std::span<const std::size_t> tet_tags = {}) const;
};

/// Whether make_tet_mesh() can number a mesh of so many nodes and tets, whatever its edges.
[[nodiscard]] bool fits_32_bits(std::size_t nodes, std::size_t tets);

/// Looks at everything that a report has. Connectivity (duplicates, faces, nodes of no tet, components) is found among
/// the tets that are in range. Takes linear time where no node has very many tets.
[[nodiscard]] MeshReport check_mesh(std::span<const Point> rest, std::span<const std::array<Index, 4>> tets);

}  // namespace physgen::fem
