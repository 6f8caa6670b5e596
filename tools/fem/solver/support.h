// What a support prescribes on a group of a mesh: components of displacements.
#pragma once

#include <fem/mesh/mesh.h>

#include <optional>
#include <string>

namespace physgen::fem {

/// Components of a displacement at a load of 1 [m]; nothing where they are free.
struct Displacement {
  std::optional<double> x{}, y{}, z{};
};

/// A direction, and the component of a displacement along it at a load of 1 [m].
struct SupportAxis {
  Point direction{};       ///< of any length
  bool is_normal = false;  ///< the outward normal of the group's faces, which must be flat, in place of the direction
  double displacement = 0;
};

/// Prescribes components of the nodes of a group; all of them, as 0, unless it says others.
struct Support {
  std::string group;
  Displacement displacement{0.0, 0.0, 0.0};
  std::string
      curve{};  ///< a name of LoadCase::curves, in place of growth in proportion to the load; so for all that follow
  std::optional<SupportAxis> axis{};  ///< in place of `displacement`; free across it
};

}  // namespace physgen::fem
