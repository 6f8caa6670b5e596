// A load case: what holds a body and what loads it, on groups of its mesh; and the forces that hold it.
#pragma once

#include <fem/mesh/groups.h>
#include <fem/solver/load_history.h>
#include <fem/solver/quasistatic.h>
#include <fem/solver/support.h>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

/// A force in all [N], shared by the areas of a group's faces at rest; where it has none, by the volumes of its tets;
/// and where it has no tets either, in equal parts by its nodes.
struct GroupForce {
  std::string group;
  Point force{};
  std::string curve{};
};

/// A force per area at rest [Pa] on the faces of a group: its direction and the area stay as the body deforms.
struct GroupTraction {
  std::string group;
  Point traction{};
  std::string curve{};
};

/// A pressure [Pa] on faces of the surface, against their outward normal: over the area and along the normal at rest,
/// or over those that the faces come to have.
struct GroupPressure {
  std::string group;
  double pressure = 0;
  bool follows = false;  ///< the surface as the body deforms
  std::string curve{};
};

/// The density of the tets of a group, in place of the body's [kg/m^3].
struct GroupDensity {
  std::string group;
  double density = 0;
};

struct LoadCase {
  std::vector<Support> supports{};
  std::vector<GroupForce> forces{};
  std::vector<GroupTraction> tractions{};
  std::vector<GroupPressure> pressures{};
  Point gravity{};        ///< [m/s^2]
  double density = 1000;  ///< [kg/m^3]; counts where there is gravity
  std::vector<GroupDensity> densities{};
  std::string gravity_curve{};
  std::vector<LoadCurve> curves{};
};

/// Prescribes the components of all levels (MeshLevel::fixed), before a background grid is added; with axes other than
/// x, y, z those of MeshLevel::axes. Supports of one body have axes that are parallel or perpendicular to each other
/// wherever they leave a node free to move.
/// @param levels finest first @param groups of each level
/// @return what the finest level is loaded with
/// @throw Error when a group is missing, has no nodes or not the faces that a load needs; when two supports prescribe
/// a component of a node differently, or have axes at other angles; when an axis has no direction, or is the normal of
/// faces that are not flat; when there is no such curve, or it is none; when a number is not finite; or when
/// a part of the body is free to move as a rigid body, naming its motions
[[nodiscard]] LoadHistory make_load_history(const LoadCase& load_case, std::vector<MeshLevel>& levels,
                                            std::span<const std::vector<MeshGroup>> groups);

/// The same of a case without curves: at a load of 1.
/// @throw Error as make_load_history(), and when a load names a curve
[[nodiscard]] Loading apply_load_case(const LoadCase& load_case, std::vector<MeshLevel>& levels,
                                      std::span<const std::vector<MeshGroup>> groups);

/// The sum of the forces that hold the prescribed components of these nodes [N]. @param forces of the solver
[[nodiscard]] Point reaction_of(std::span<const Index> nodes, const MeshLevel& level, std::span<const Point> forces);

/// The sum of vectors at these nodes.
[[nodiscard]] Point sum_of(std::span<const Index> nodes, std::span<const Point> vectors);

}  // namespace physgen::fem
