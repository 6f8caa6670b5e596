// Supports along directions of one's own: what they prescribe at each node, and the perpendicular axes along which all
// of it are components.
#pragma once

#include <fem/mesh/groups.h>
#include <fem/solver/mesh_level.h>
#include <fem/solver/support.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

/// A component that is prescribed [m].
struct PrescribedComponent {
  Point direction;  ///< of length 1
  double displacement;
};

/// What a support prescribes, and by which curve.
struct SupportComponents {
  std::string group;
  std::vector<PrescribedComponent> components;
  std::size_t curve = 0;
};

/// The direction of a support with an axis, of length 1. @param group of the level
/// @throw Error naming the group when the axis has no direction, or is the normal of faces that are not flat
[[nodiscard]] Point axis_of(const Support& support, const MeshLevel& level, const MeshGroup& group);

/// The components of a support, in any direction. @param group of the finest level
/// @throw Error naming the group when its axis has no direction, or is the normal of faces that are not flat
[[nodiscard]] SupportComponents components_of(const Support& support, const MeshLevel& finest, const MeshGroup& group,
                                              std::size_t curve);

/// Up to three components that are prescribed at a node, in directions none of which the others span.
class NodeComponents {
 public:
  struct Component {
    PrescribedComponent prescribed;
    std::size_t support = 0;
  };

  /// Takes a component. @return false, without taking it, where those that are here span its direction
  bool take(const Component& more);
  [[nodiscard]] std::span<const Component> all() const { return {components_.data(), count_}; }
  /// The displacement whose component i is 1 m and whose others are 0, with nothing across all of them.
  [[nodiscard]] Point dual(std::size_t i) const;
  /// The one direction that is prescribed, or the one that is left free. @pre one or two components
  [[nodiscard]] Point line() const;

 private:
  [[nodiscard]] std::array<Point, 3> basis() const;

  std::array<Component, 3> components_{};
  std::size_t count_ = 0;
};

/// @param nodes that each support holds @param rest of the level's nodes
/// @throw Error naming two groups, and the place of a node that they prescribe differently
[[nodiscard]] std::vector<NodeComponents> components_of_nodes(std::span<const SupportComponents> supports,
                                                              std::span<const std::span<const Index>> nodes,
                                                              std::span<const Point> rest);

/// Perpendicular axes such that at each node whole components along them are prescribed; none where x, y, z are such.
/// @throw Error naming two groups whose directions are neither parallel nor perpendicular
[[nodiscard]] std::optional<std::array<Point, 3>> common_axes(std::span<const NodeComponents> nodes,
                                                              std::span<const SupportComponents> supports);

/// MeshLevel::fixed of a node.
[[nodiscard]] std::uint8_t fixed_along(const std::array<Point, 3>& axes, const NodeComponents& node);

}  // namespace physgen::fem
