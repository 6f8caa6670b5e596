// Loads become forces of nodes on the finest level; supports hold all levels.
#include <fem/mesh/geometry.h>
#include <fem/mesh/nearest_name.h>
#include <fem/solver/load_case.h>
#include <fem/solver/number_text.h>
#include <fem/solver/rigid_motions.h>
#include <fem/solver/support_axes.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

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

/// The loading that each curve moves, by its number; the first is in proportion to the load.
class Parts {
 public:
  Parts(const std::vector<LoadCurve>& curves, std::size_t nodes) : curves_(&curves), loadings_(curves.size() + 1) {
    for (const LoadCurve& curve : curves) {
      require_curve(curve);
      if (std::ranges::count(curves, curve.name, &LoadCurve::name) > 1 || curve.name.empty()) {
        throw Error("there are two curves '" + curve.name + "', or it has no name; give each a name of its own");
      }
    }
    for (Loading& loading : loadings_) {
      loading.motion.assign(nodes, Point{});
      loading.forces.assign(nodes, Force{});
    }
  }

  [[nodiscard]] std::size_t number(const std::string& curve) const {
    if (curve.empty()) return 0;
    const auto found = std::ranges::find(*curves_, curve, &LoadCurve::name);
    if (found != curves_->end()) return static_cast<std::size_t>(found - curves_->begin()) + 1;
    std::vector<std::string> names;
    for (const LoadCurve& known : *curves_) names.push_back(known.name);
    const std::string near = nearest_name(curve, names);
    throw Error("there is no curve '" + curve + "'" + (near.empty() ? "" : "; did you mean '" + near + "'?") +
                (near.empty() ? "; give the load case one of that name" : ""));
  }
  [[nodiscard]] Loading& of(const std::string& curve) { return loadings_[number(curve)]; }
  [[nodiscard]] Loading& at(std::size_t number) { return loadings_[number]; }

  [[nodiscard]] LoadHistory history() && {
    LoadHistory history{std::move(loadings_.front()), {}};
    for (std::size_t c = 0; c < curves_->size(); ++c) {
      history.parts.push_back({(*curves_)[c], std::move(loadings_[c + 1])});
    }
    return history;
  }

 private:
  const std::vector<LoadCurve>* curves_;
  std::vector<Loading> loadings_;
};

/// Prescribes the components of a level; on the finest one, where `parts` are given, with their motion.
void hold(const LoadCase& load_case, MeshLevel& level, std::span<const MeshGroup> groups, Parts* parts) {
  level.fixed.assign(level.rest.size(), 0);
  std::vector<std::array<const Support*, 3>> holders(parts != nullptr ? level.rest.size() : 0);
  for (const Support& support : load_case.supports) {
    const auto prescribed = components_of(support);
    const std::size_t curve = parts != nullptr ? parts->number(support.curve) : 0;
    for (const Index n : nodes_of(groups, support.group, "a support").nodes) {
      const auto at = static_cast<std::size_t>(n);
      for (std::size_t k = 0; k < 3; ++k) {
        if (!prescribed[k]) continue;
        level.fixed[at] = static_cast<std::uint8_t>(level.fixed[at] | 1U << k);
        if (parts == nullptr) continue;
        const double value = *prescribed[k];
        if (const Support* other = holders[at][k]; other != nullptr) {
          const std::size_t other_curve = parts->number(other->curve);
          const double other_value = parts->at(other_curve).motion[at][k];
          if (other_value != value || (value != 0 && other_curve != curve)) {
            const Point& x = level.rest[at];
            throw Error("groups '" + other->group + "' and '" + support.group + "' share the node at (" +
                        number_text(x[0]) + ", " + number_text(x[1]) + ", " + number_text(x[2]) +
                        ") m at rest and prescribe different displacements along " + "xyz"[k] + " there, " +
                        number_text(other_value) + " and " + number_text(value) + " m" +
                        (other_curve == curve ? "" : ", along other curves") +
                        "; leave that component free in one of them");
          }
        }
        holders[at][k] = &support;
        parts->at(curve).motion[at][k] = value;
      }
    }
  }
}

/// The same where some components lie along axes of their own.
void hold_along_axes(const LoadCase& load_case, std::vector<MeshLevel>& levels,
                     std::span<const std::vector<MeshGroup>> groups, Parts& parts) {
  std::vector<SupportComponents> supports;
  for (const Support& support : load_case.supports) {
    const MeshGroup& group = nodes_of(groups.front(), support.group, "a support");
    supports.push_back(components_of(support, levels.front(), group, parts.number(support.curve)));
  }
  for (std::size_t l = 0; l < levels.size(); ++l) {
    MeshLevel& level = levels[l];
    std::vector<std::span<const Index>> held;
    for (const Support& support : load_case.supports) {
      held.emplace_back(nodes_of(groups[l], support.group, "a support").nodes);
    }
    const std::vector<NodeComponents> nodes = components_of_nodes(supports, held, level.rest);
    level.axes = l == 0 ? common_axes(nodes, supports) : levels.front().axes;
    level.fixed.resize(nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      level.fixed[n] = fixed_along(level.axes.value_or(coordinate_axes), nodes[n]);
      if (l > 0) continue;
      const auto all = nodes[n].all();
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Point dual = nodes[n].dual(i);
        Point& motion = parts.at(supports[all[i].support].curve).motion[n];
        for (std::size_t k = 0; k < 3; ++k) motion[k] += all[i].prescribed.displacement * dual[k];
      }
    }
  }
}

/// Gravity of all the body, with the densities of groups.
std::vector<Force> weights(const LoadCase& load_case, const MeshLevel& level, std::span<const MeshGroup> groups) {
  std::vector<Force> forces = gravity_loads(level.mesh, level.rest, load_case.density, load_case.gravity);
  for (const GroupDensity& own : load_case.densities) {
    const MeshGroup& group = nodes_of(groups, own.group, "a density");
    require_finite("the density of group '" + own.group + "'", {&own.density, 1});
    if (group.tets.empty()) {
      throw Error("group '" + own.group + "' has no tets, and a density needs them; take a group of a volume");
    }
    for (const Index t : group.tets) {
      const auto& tet = level.mesh.tets[static_cast<std::size_t>(t)];
      const double share = (own.density - load_case.density) * six_volumes(tet, level.rest) / 24;
      for (const Index n : tet) {
        for (std::size_t k = 0; k < 3; ++k) forces[static_cast<std::size_t>(n)][k] += share * load_case.gravity[k];
      }
    }
  }
  return forces;
}

}  // namespace

LoadHistory make_load_history(const LoadCase& load_case, std::vector<MeshLevel>& levels,
                              std::span<const std::vector<MeshGroup>> groups) {
  if (levels.empty() || groups.size() != levels.size()) {
    throw Error("a load case takes the groups of each level: there are " + std::to_string(levels.size()) +
                " levels and groups of " + std::to_string(groups.size()));
  }
  const MeshLevel& finest = levels.front();
  Parts parts(load_case.curves, finest.rest.size());
  for (const Support& support : load_case.supports) {
    for (const auto& value : components_of(support)) {
      if (value) require_finite("a displacement of group '" + support.group + "'", {&*value, 1});
    }
    if (support.axis)
      require_finite("a displacement of group '" + support.group + "'", {&support.axis->displacement, 1});
  }
  if (std::ranges::any_of(load_case.supports, [](const Support& support) { return support.axis.has_value(); })) {
    hold_along_axes(load_case, levels, groups, parts);
  } else {
    for (std::size_t l = 0; l < levels.size(); ++l) hold(load_case, levels[l], groups[l], l == 0 ? &parts : nullptr);
  }
  require_held(finest.mesh, finest.rest, finest.fixed, finest.axes.value_or(coordinate_axes));

  require_finite("the density", {&load_case.density, 1});
  require_finite("gravity", load_case.gravity);
  parts.of(load_case.gravity_curve).forces = weights(load_case, finest, groups.front());
  for (const GroupForce& load : load_case.forces) {
    const MeshGroup& group = nodes_of(groups.front(), load.group, "a force");
    require_finite("the force on group '" + load.group + "'", load.force);
    const auto [shares, sum] = shares_of(finest, group);
    add(parts.of(load.curve).forces, group.nodes, shares,
        {load.force[0] / sum, load.force[1] / sum, load.force[2] / sum});
  }
  for (const GroupTraction& load : load_case.tractions) {
    const MeshGroup& group = faces_of(groups.front(), load.group, "a traction");
    require_finite("the traction on group '" + load.group + "'", load.traction);
    add(parts.of(load.curve).forces, group.nodes, surface_areas(finest.rest, group.faces), load.traction);
  }
  for (const GroupPressure& load : load_case.pressures) {
    const MeshGroup& group = faces_of(groups.front(), load.group, "a pressure");
    require_finite("the pressure on group '" + load.group + "'", {&load.pressure, 1});
    std::vector<Face> faces = outward_faces(finest.mesh, finest.rest, group);
    Loading& part = parts.of(load.curve);
    if (load.follows) {
      part.pressures.push_back({std::move(faces), load.pressure});
      continue;
    }
    const auto forces = pressure_loads(finest.rest, faces, load.pressure);
    for (const Index n : group.nodes) {
      const auto at = static_cast<std::size_t>(n);
      for (std::size_t k = 0; k < 3; ++k) part.forces[at][k] += forces[at][k];
    }
  }
  return std::move(parts).history();
}

Loading apply_load_case(const LoadCase& load_case, std::vector<MeshLevel>& levels,
                        std::span<const std::vector<MeshGroup>> groups) {
  if (!load_case.curves.empty()) {
    throw Error("a load case with curves is a history of loads; take make_load_history(), and follow() it");
  }
  return make_load_history(load_case, levels, groups).proportional;
}

Point reaction_of(std::span<const Index> nodes, const MeshLevel& level, std::span<const Point> forces) {
  Point sum{};
  const auto axes = level.axes.value_or(coordinate_axes);
  for (const Index n : nodes) {
    const auto at = static_cast<std::size_t>(n);
    for (std::size_t k = 0; k < 3; ++k) {
      if ((level.fixed[at] >> k & 1) == 0) continue;
      const double force = dot(forces[at], axes[k]);
      for (std::size_t c = 0; c < 3; ++c) sum[c] -= force * axes[k][c];
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
