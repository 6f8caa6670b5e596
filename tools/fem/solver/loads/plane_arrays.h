// The arrays that a level keeps of the rigid planes that its body may touch; made only where there are planes.
#pragma once

#include <contact.physgen.h>
#include <fem/mesh/boundary.h>
#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/arrays/solver_arrays.h>
#include <fem/solver/loads/rigid_planes.h>
#include <fem/solver/quasistatic.h>
#include <physgen/launch/reduce.h>

#include <utility>
#include <vector>

namespace physgen::fem {

/// @tparam Group with the arrays of Planes in solver_groups.h
template <class Group>
struct PlanesOver : Group {
  double per_area = 0;  ///< stiffness [Pa/m]

  explicit PlanesOver(Group&& arrays) : Group(std::move(arrays)) {}
  /// Makes those of a level on which equilibrium is solved.
  /// @param stiffness_per_area [Pa/m]
  PlanesOver(const MeshLevel& level, const std::vector<RigidPlane>& given, double stiffness_per_area)
      : per_area(stiffness_per_area) {
    this->allocate(counts(level.mesh.nodes, index_t(given.size()), true));
    put(this->planes, host_planes(given));
    put(this->areas, host_areas(level));
  }
  /// Makes those of a level of the preconditioner alone.
  explicit PlanesOver(index_t nodes) { this->allocate(counts(nodes, 0, false)); }

  /// @param solved whether equilibrium is solved on the level
  [[nodiscard]] static auto counts(index_t nodes, index_t planes, bool solved) {
    if (!solved) return typename Group::Counts{.node = nodes};
    return typename Group::Counts{.plane = planes, .surface_node = nodes, .node = nodes, .contact = 1};
  }

  /// For kernels. @pre equilibrium is solved on the level
  [[nodiscard]] auto at(const AtLoad& load) const {
    return RigidPlanes{per_area, load.load, load.touching, this->planes.const_view(), this->areas.const_view()};
  }

 private:
  static auto host_planes(const std::vector<RigidPlane>& given) {
    contact::RigidPlaneArray<double> array(index_t(given.size()));
    for (index_t p = 0; p < array.size(); ++p) {
      const RigidPlane& plane = given[std::size_t(p)];
      for (int k = 0; k < 3; ++k) array.view()[p].normal()[k] = plane.normal[std::size_t(k)];
      array.view()[p].offset() = plane.offset;
      array.view()[p].travel() = plane.travel;
    }
    return array;
  }
  static auto host_areas(const MeshLevel& level) {
    const std::vector<double> shares = surface_areas(level.rest, boundary_faces(level.mesh));
    contact::NodeAreaArray<double> array(index_t(shares.size()));
    for (index_t n = 0; n < array.size(); ++n) array.view()[n].area() = shares[std::size_t(n)];
    return array;
  }
};

/// Force and depth of each plane with a level's nodes. @pre equilibrium is solved on it, and it has planes
template <class On, class Level, class PositionView>
[[nodiscard]] std::vector<PlaneContact> measure_planes(On& on, Level& level, const PositionView& positions,
                                                       double load) {
  const auto planes = level.planes->at(load);
  const auto constraints = level.constraints.const_view();
  auto& contact = level.planes->contact;
  std::vector<PlaneContact> contacts;
  for (index_t p = 0; p < planes.planes.size(); ++p) {
    on.reduce(level.nodes(), PlaneForce{p, planes, positions, constraints}, Sum{}, StorePlaneForce{contact.view()});
    on.reduce(level.nodes(), PlaneDepth{p, planes, positions, constraints}, Max{}, StorePlaneDepth{contact.view()});
    const auto found = on.value(contact);
    contacts.push_back({found.force, found.depth});
  }
  return contacts;
}

}  // namespace physgen::fem
