#include "case_state_of.h"

#include <fem/mesh/follow_numbers.h>
#include <fem/mesh/geometry.h>
#include <fem/solver/support_axes.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "output/beads.h"

namespace physgen::truthcube {

namespace {

using fem::Point;

double length(const Point& x) { return std::hypot(x[0], x[1], x[2]); }

GroupState state_of(const std::string& name, std::span<const fem::Index> nodes, const Scene& scene,
                    const std::vector<Point>& external, const std::vector<Point>& moved,
                    const std::vector<Point>& forces) {
  GroupState state{name, fem::reaction_of(nodes, scene.levels.front(), forces), fem::sum_of(nodes, external), 0};
  for (const fem::Index n : nodes) {
    state.largest_displacement = std::max(state.largest_displacement, length(moved[static_cast<std::size_t>(n)]));
  }
  return state;
}

std::string text_of(const Point& x, double factor) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "(%.6g, %.6g, %.6g)", factor * x[0], factor * x[1], factor * x[2]);
  return text.data();
}

}  // namespace

std::vector<fem::Location> locate_probes(const std::vector<Probe>& probes, const fem::MeshLevel& level) {
  std::vector<Point> points;
  for (const Probe& probe : probes) points.push_back(probe.at);
  try {
    return fem::locate(level.rest, level.mesh, points);
  } catch (const fem::OutsideMesh& error) {
    const Probe& probe = probes[error.point()];
    throw Error("the probe '" + probe.name + "' at " + text_of(probe.at, 1) +
                " m lies outside of the body at rest; move it inside");
  }
}

std::vector<Point> external_forces(const fem::Loading& loading, const std::vector<Point>& positions) {
  std::vector<Point> forces = loading.forces;
  for (const fem::FollowingPressure& pressure : loading.pressures) {
    const auto more = fem::pressure_loads(positions, pressure.faces, pressure.pressure);
    for (std::size_t n = 0; n < forces.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) forces[n][k] += more[n][k];
    }
  }
  return forces;
}

std::vector<std::optional<Point>> axes_of(const Scene& scene, const Case& given) {
  std::vector<std::optional<Point>> axes;
  for (const fem::Support& support : given.load_case.supports) {
    axes.emplace_back();
    if (!support.axis) continue;
    axes.back() = fem::axis_of(support, scene.levels.front(), fem::group_named(scene.groups, support.group));
  }
  return axes;
}

CaseState case_state_of(const Scene& scene, const Case& given, const std::vector<fem::Location>& locations,
                        const std::vector<std::optional<Point>>& axes, double load, const std::vector<Point>& positions,
                        const std::vector<Point>& forces) {
  const fem::MeshLevel& level = scene.levels.front();
  std::vector<Point> moved(positions.size());
  for (std::size_t n = 0; n < moved.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) moved[n][k] = positions[n][k] - level.rest[n][k];
  }
  std::vector<fem::Index> nodes(positions.size());
  std::iota(nodes.begin(), nodes.end(), fem::Index{0});
  CaseState state;
  state.load = load;
  const std::vector<Point> external = external_forces(scene.history.at(load), positions);
  state.all = state_of("", nodes, scene, external, moved, forces);
  for (const fem::MeshGroup& group : scene.groups) {
    GroupState& of_group = state.groups.emplace_back(state_of(group.name, group.nodes, scene, external, moved, forces));
    for (std::size_t s = 0; s < axes.size(); ++s) {
      if (!axes[s] || given.load_case.supports[s].group != group.name) continue;
      of_group.axes.push_back({*axes[s], fem::dot(*axes[s], of_group.reaction)});
    }
  }
  const auto add = [&](const char* of, const auto& measure) {
    const auto [low, high] = std::ranges::minmax_element(moved, {}, measure);
    const auto extreme = [&](auto at) {
      return Extreme{measure(*at), level.rest[static_cast<std::size_t>(at - moved.begin())]};
    };
    state.displacement.push_back({of, extreme(low), extreme(high)});
  };
  add("x", [](const Point& u) { return u[0]; });
  add("y", [](const Point& u) { return u[1]; });
  add("z", [](const Point& u) { return u[2]; });
  add("length", length);
  const std::vector<Probe>& probes = given.probes;
  const std::vector<Point> corners =
      fem::in_order(std::span<const Point>(positions), corners_of(locations, level.mesh));
  const auto at_probes = interpolate_displacements(locations, level.mesh, level.rest, corners);
  for (std::size_t p = 0; p < probes.size(); ++p) state.probes.push_back({probes[p].name, probes[p].at, at_probes[p]});
  return state;
}

std::vector<std::string> describe(const CaseState& state, const fem::LoadCase& load_case) {
  const auto& [of, low, high] = state.displacement.back();
  std::array<char, 64> most{};
  std::snprintf(most.data(), most.size(), "%.6g", 1e3 * high.value);
  std::vector<std::string> lines{"largest displacement " + std::string(most.data()) + " mm, of the node at rest at " +
                                 text_of(high.at, 1e3) + " mm"};
  for (const GroupState& group : state.groups) {
    if (std::ranges::find(load_case.supports, group.group, &fem::Support::group) != load_case.supports.end())
      lines.push_back("reaction of " + group.group + ": " + text_of(group.reaction, 1) + " N");
    for (const auto& [axis, force] : group.axes) {
      std::array<char, 32> newtons{};
      std::snprintf(newtons.data(), newtons.size(), "%.6g", force);
      lines.push_back("  along its axis " + text_of(axis, 1) + ": " + newtons.data() + " N");
    }
  }
  for (const ProbeState& probe : state.probes) {
    lines.push_back("displacement of " + probe.probe + ": " + text_of(probe.displacement, 1e3) + " mm");
  }
  return lines;
}

}  // namespace physgen::truthcube
