// A load case: what holds a body and what loads it, on groups of its mesh; and the forces that hold it.
#pragma once

#include <fem/mesh/groups.h>
#include <fem/solver/quasistatic.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

/// Components of a displacement at a load of 1 [m]; nothing where they are free.
struct Displacement {
  std::optional<double> x{}, y{}, z{};
};

/// Prescribes components of the nodes of a group; all of them, as 0, unless it says others.
struct Support {
  std::string group;
  Displacement displacement{0.0, 0.0, 0.0};
};

/// A force in all [N], shared by the areas of a group's faces at rest; where it has none, by the volumes of its tets;
/// and where it has no tets either, in equal parts by its nodes.
struct GroupForce {
  std::string group;
  Point force{};
};

/// A force per area at rest [Pa] on the faces of a group: its direction and the area stay as the body deforms.
struct GroupTraction {
  std::string group;
  Point traction{};
};

/// A pressure [Pa] on faces of the surface, against their outward normal at rest, which stays as the body deforms.
struct GroupPressure {
  std::string group;
  double pressure = 0;
};

struct LoadCase {
  std::vector<Support> supports{};
  std::vector<GroupForce> forces{};
  std::vector<GroupTraction> tractions{};
  std::vector<GroupPressure> pressures{};
  Point gravity{};        ///< [m/s^2]
  double density = 1000;  ///< [kg/m^3]; counts where there is gravity
};

/// Prescribes the components of all levels (MeshLevel::fixed), before a background grid is added.
/// @param levels finest first @param groups of each level
/// @return the motion and the forces of the finest level at a load of 1
/// @throw Error when a group is missing, has no nodes or not the faces that a load needs; when two supports prescribe
/// a component of a node differently; when a number is not finite; or when a part of the body is free to move as a
/// rigid body, naming its motions
[[nodiscard]] Loading apply_load_case(const LoadCase& load_case, std::vector<MeshLevel>& levels,
                                      std::span<const std::vector<MeshGroup>> groups);

/// The sum of the forces that hold the prescribed components of these nodes [N]. @param forces of the solver
[[nodiscard]] Point reaction_of(std::span<const Index> nodes, const MeshLevel& level, std::span<const Point> forces);

/// The sum of vectors at these nodes.
[[nodiscard]] Point sum_of(std::span<const Index> nodes, std::span<const Point> vectors);

}  // namespace physgen::fem
