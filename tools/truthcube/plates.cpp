#include "plates.h"

#include <fem/mesh/boundary.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace physgen::truthcube {

namespace {

using fem::Index;
using fem::MeshLevel;
using fem::Point;

constexpr double nearby = 10;  // how many times the tolerance is just beyond it

/// In mean edge lengths.
double end_of_nearby(double tolerance) {
  return std::min(nearby * std::max(tolerance, default_plate_tolerance), largest_plate_tolerance);
}

/// Of a box of cells with right angles, each with a diagonal of its own and one on each of its faces, without lists.
double mean_edge_of_box(const MeshLevel& level) {
  const auto& cells = level.mesh.box->cells;
  const std::array<Index, 3> step{1, cells[0] + 1, (cells[0] + 1) * (cells[1] + 1)};
  double sum = 0;
  std::int64_t edges = 0;
  for (Index node = 0; node < level.mesh.nodes; ++node) {
    for (unsigned to = 1; to < 8; ++to) {  // neighbours that lie no lower along any axis
      Index other = node;
      bool is_there = true;
      for (unsigned k = 0; k < 3; ++k) {
        if ((to >> k & 1U) == 0) continue;
        is_there &= node / step[k] % (cells[k] + 1) < cells[k];
        other += step[k];
      }
      if (!is_there) continue;
      const Point &a = level.rest[static_cast<std::size_t>(node)], &b = level.rest[static_cast<std::size_t>(other)];
      sum += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
      ++edges;
    }
  }
  return sum / static_cast<double>(edges);
}

double mean_edge_of(const MeshLevel& level) {
  if (level.mesh.edges.empty() && level.mesh.box) return mean_edge_of_box(level);
  double sum = 0;
  for (const auto& [m, n] : level.mesh.edges) {
    const Point &a = level.rest[static_cast<std::size_t>(m)], &b = level.rest[static_cast<std::size_t>(n)];
    sum += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }
  return sum / static_cast<double>(level.mesh.edges.size());
}

/// Whether a level's nodes are held, of those that are.
std::vector<bool> marked(const MeshLevel& level, const std::vector<Index>& nodes) {
  std::vector<bool> held(level.rest.size(), false);
  for (const Index n : nodes) held[static_cast<std::size_t>(n)] = true;
  return held;
}

template <class Corners>
bool are_all_held(const Corners& corners, const std::vector<bool>& held) {
  return std::ranges::all_of(corners, [&](Index n) { return held[static_cast<std::size_t>(n)]; });
}

Plate hold(std::span<const MeshLevel> levels, std::span<const fem::Face> surface, double plane,
           const PlatesOfBody& plates, double end) {
  Plate plate;
  const std::vector<Point>& given = levels.back().rest;
  plate.nodes.resize(levels.size());
  plate.nodes.back() = fem::nodes_on_plane(given, 2, plane, plates.tolerance);
  for (const Point& x : given) {
    const double distance = std::abs(x[2] - plane);
    if (distance <= plates.tolerance || distance > end) continue;
    ++plate.just_beyond;
    plate.farthest_beyond = std::max(plate.farthest_beyond, distance);
  }
  for (std::size_t l = levels.size() - 1; l-- > 0;) {
    const std::vector<bool> parents_held = marked(levels[l + 1], plate.nodes[l + 1]);
    for (std::size_t n = 0; n < levels[l].parents.size(); ++n) {
      if (are_all_held(levels[l].parents[n], parents_held)) plate.nodes[l].push_back(static_cast<Index>(n));
    }
  }
  const std::vector<bool> held = marked(levels.front(), plate.nodes.front());
  std::vector<fem::Face> faces;
  std::ranges::copy_if(surface, std::back_inserter(faces), [&](const fem::Face& f) { return are_all_held(f, held); });
  const std::vector<double> areas = fem::surface_areas(levels.front().rest, faces);
  plate.area = std::accumulate(areas.begin(), areas.end(), 0.0);
  plate.whole_tets =
      std::ranges::count_if(levels.front().mesh.tets, [&](const auto& corners) { return are_all_held(corners, held); });
  return plate;
}

template <class... Numbers>
std::string text(const char* format, Numbers... numbers) {
  std::array<char, 400> line{};
  std::snprintf(line.data(), line.size(), format, numbers...);
  return line.data();
}

/// The least tolerance of two digits that is no smaller, in mean edge lengths.
double rounded_up(double tolerance) {
  const double unit = std::pow(10, std::floor(std::log10(tolerance)) - 1);
  return std::min(std::ceil(tolerance / unit * (1 + 1e-12)) * unit, largest_plate_tolerance);
}

void warn(std::vector<std::string>& warnings, const char* name, const Plate& plate, const PlatesOfBody& plates) {
  constexpr double mm = 1e3;
  if (plate.just_beyond > 0) {
    warnings.push_back(text(
        "the %s plate holds the %zu nodes within %.3g mm of its plane; %lld more nodes lie just beyond, up to %.3g "
        "mm from it. If they belong to that face, hold them by --plate-tolerance %.2g",
        name, plate.nodes.back().size(), mm * plates.tolerance, static_cast<long long>(plate.just_beyond),
        mm * plate.farthest_beyond, rounded_up(plate.farthest_beyond / plates.mean_edge)));
  }
  if (plate.whole_tets > 0) {
    warnings.push_back(
        text("the %s plate holds all corners of %lld tets, so they cannot deform: they are thinner than its tolerance, "
             "%.3g mm; take a smaller --plate-tolerance",
             name, static_cast<long long>(plate.whole_tets), mm * plates.tolerance));
  }
}

}  // namespace

PlatesOfBody hold_between_plates(std::span<const MeshLevel> levels, double tolerance) {
  const auto [low, high] = std::ranges::minmax(levels.back().rest, {}, [](const Point& x) { return x[2]; });
  PlatesOfBody plates;
  plates.low = low[2];
  plates.high = high[2];
  plates.mean_edge = mean_edge_of(levels.back());
  plates.tolerance = tolerance * plates.mean_edge;
  const double end = end_of_nearby(tolerance) * plates.mean_edge;
  const std::vector<fem::Face> surface = fem::boundary_faces(levels.front().mesh);
  plates.lower = hold(levels, surface, low[2], plates, end);
  plates.upper = hold(levels, surface, high[2], plates, end);
  return plates;
}

std::string describe(const PlatesOfBody& plates) {
  constexpr double mm2 = 1e6;
  return text("plates hold %zu and %zu nodes, %.6g and %.6g mm^2 of the surface (lower and upper)",
              plates.lower.nodes.front().size(), plates.upper.nodes.front().size(), mm2 * plates.lower.area,
              mm2 * plates.upper.area);
}

std::vector<std::string> warnings_of(const PlatesOfBody& plates) {
  std::vector<std::string> warnings;
  warn(warnings, "lower", plates.lower, plates);
  warn(warnings, "upper", plates.upper, plates);
  return warnings;
}

void require_faces(const PlatesOfBody& plates) {
  const std::size_t lower = plates.lower.nodes.back().size(), upper = plates.upper.nodes.back().size();
  if (lower >= 3 && upper >= 3) return;
  throw Error(text(
      "the plates hold the nodes within %.3g mm of the lowest and of the highest node along z. These are only %zu "
      "and %zu, with %lld and %lld more just beyond: give the mesh flat faces there, or a larger --plate-tolerance",
      1e3 * plates.tolerance, lower, upper, static_cast<long long>(plates.lower.just_beyond),
      static_cast<long long>(plates.upper.just_beyond)));
}

}  // namespace physgen::truthcube
