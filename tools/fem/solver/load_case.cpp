// Loads become forces of nodes on the finest level; supports hold all levels.
#include <fem/mesh/geometry.h>
#include <fem/solver/load_case.h>
#include <fem/solver/number_text.h>
#include <fem/solver/rigid_motions.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace physgen::fem {

namespace {

void require_finite(const std::string& what, std::span<const double> values) {
  const auto stray = std::ranges::find_if_not(values, [](double value) { return std::isfinite(value); });
  if (stray != values.end()) throw Error(what + " is " + number_text(*stray) + " and must be a finite number");
}

std::array<std::optional<double>, 3> components_of(const Support& support) {
  return {support.displacement.x, support.displacement.y, support.displacement.z};
}

const MeshGroup& nodes_of(std::span<const MeshGroup> groups, const std::string& name, std::string_view use) {
  const MeshGroup& group = group_named(groups, name);
  if (group.nodes.empty()) {
    throw Error("group '" + name + "' has no node of a tet, so that there is nothing for " + std::string(use) +
                " to act on; take another group, or mesh it together with the volume (a partitioned mesh: save it "
                "without partitions)");
  }
  return group;
}

const MeshGroup& faces_of(std::span<const MeshGroup> groups, const std::string& name, std::string_view use) {
  const MeshGroup& group = nodes_of(groups, name, use);
  if (group.faces.empty()) {
    throw Error("group '" + name + "' has no faces, and " + std::string(use) +
                " needs them; take a group of a surface");
  }
  return group;
}

void add(std::vector<Force>& forces, std::span<const Index> nodes, const std::vector<double>& shares,
         const Point& density) {
  for (const Index n : nodes) {
    const auto at = static_cast<std::size_t>(n);
    for (std::size_t k = 0; k < 3; ++k) forces[at][k] += shares[at] * density[k];
  }
}

/// The parts of a group's nodes in a force. @return and their sum
std::pair<std::vector<double>, double> shares_of(const MeshLevel& level, const MeshGroup& group) {
  std::vector<double> shares;
  if (!group.faces.empty()) {
    shares = surface_areas(level.rest, group.faces);
  } else {
    shares.assign(level.rest.size(), 0.0);
    for (const Index t : group.tets) {
      const auto& tet = level.mesh.tets[static_cast<std::size_t>(t)];
      for (const Index n : tet) shares[static_cast<std::size_t>(n)] += six_volumes(tet, level.rest);
    }
    if (group.tets.empty()) {
      for (const Index n : group.nodes) shares[static_cast<std::size_t>(n)] = 1;
    }
  }
  double sum = 0;
  for (const Index n : group.nodes) sum += shares[static_cast<std::size_t>(n)];
  return {shares, sum};
}

/// Prescribes the components of a level; on the finest one, where `motion` is given, with their motion.
void hold(const LoadCase& load_case, MeshLevel& level, std::span<const MeshGroup> groups, std::vector<Point>* motion) {
  level.fixed.assign(level.rest.size(), 0);
  std::vector<std::array<const Support*, 3>> holders(motion != nullptr ? level.rest.size() : 0);
  for (const Support& support : load_case.supports) {
    const auto prescribed = components_of(support);
    for (const Index n : nodes_of(groups, support.group, "a support").nodes) {
      const auto at = static_cast<std::size_t>(n);
      for (std::size_t k = 0; k < 3; ++k) {
        if (!prescribed[k]) continue;
        level.fixed[at] = static_cast<std::uint8_t>(level.fixed[at] | 1U << k);
        if (motion == nullptr) continue;
        const double value = *prescribed[k];
        if (const Support* other = holders[at][k]; other != nullptr && (*motion)[at][k] != value) {
          throw Error("groups '" + other->group + "' and '" + support.group + "' share node " + std::to_string(n) +
                      " and prescribe other displacements along " + "xyz"[k] + " there, " +
                      number_text((*motion)[at][k]) + " and " + number_text(value) +
                      " m; leave that component free in one of them");
        }
        holders[at][k] = &support;
        (*motion)[at][k] = value;
      }
    }
  }
}

}  // namespace

Loading apply_load_case(const LoadCase& load_case, std::vector<MeshLevel>& levels,
                        std::span<const std::vector<MeshGroup>> groups) {
  if (levels.empty() || groups.size() != levels.size()) {
    throw Error("a load case takes the groups of each level: there are " + std::to_string(levels.size()) +
                " levels and groups of " + std::to_string(groups.size()));
  }
  const MeshLevel& finest = levels.front();
  Loading loading;
  loading.motion.assign(finest.rest.size(), Point{});
  for (const Support& support : load_case.supports) {
    for (const auto& value : components_of(support)) {
      if (value) require_finite("a displacement of group '" + support.group + "'", {&*value, 1});
    }
  }
  for (std::size_t l = 0; l < levels.size(); ++l) {
    hold(load_case, levels[l], groups[l], l == 0 ? &loading.motion : nullptr);
  }
  require_held(finest.mesh, finest.rest, finest.fixed);

  require_finite("the density", {&load_case.density, 1});
  require_finite("gravity", load_case.gravity);
  loading.forces = gravity_loads(finest.mesh, finest.rest, load_case.density, load_case.gravity);
  for (const GroupForce& load : load_case.forces) {
    const MeshGroup& group = nodes_of(groups.front(), load.group, "a force");
    require_finite("the force on group '" + load.group + "'", load.force);
    const auto [shares, sum] = shares_of(finest, group);
    add(loading.forces, group.nodes, shares, {load.force[0] / sum, load.force[1] / sum, load.force[2] / sum});
  }
  for (const GroupTraction& load : load_case.tractions) {
    const MeshGroup& group = faces_of(groups.front(), load.group, "a traction");
    require_finite("the traction on group '" + load.group + "'", load.traction);
    add(loading.forces, group.nodes, surface_areas(finest.rest, group.faces), load.traction);
  }
  for (const GroupPressure& load : load_case.pressures) {
    const MeshGroup& group = faces_of(groups.front(), load.group, "a pressure");
    require_finite("the pressure on group '" + load.group + "'", {&load.pressure, 1});
    const auto forces = pressure_loads(finest.rest, outward_faces(finest.mesh, group), load.pressure);
    for (const Index n : group.nodes) {
      const auto at = static_cast<std::size_t>(n);
      for (std::size_t k = 0; k < 3; ++k) loading.forces[at][k] += forces[at][k];
    }
  }
  return loading;
}

Point reaction_of(std::span<const Index> nodes, const MeshLevel& level, std::span<const Point> forces) {
  Point sum{};
  for (const Index n : nodes) {
    const auto at = static_cast<std::size_t>(n);
    for (std::size_t k = 0; k < 3; ++k) {
      if ((level.fixed[at] >> k & 1) != 0) sum[k] -= forces[at][k];
    }
  }
  return sum;
}

Point sum_of(std::span<const Index> nodes, std::span<const Point> vectors) {
  Point sum{};
  for (const Index n : nodes) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += vectors[static_cast<std::size_t>(n)][k];
  }
  return sum;
}

}  // namespace physgen::fem
