// The prescribed motion and the forces at the nodes of each level, from those of the finest one.
#pragma once

#include <fem/solver/arrays/solver_arrays.h>
#include <fem/solver/quasistatic.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace physgen::fem {

/// Stores motion [m] and forces [N] at a load of 1. @param a a group with the arrays `motion` and `loads`
/// @param fixed per node: bit k is set where component k is prescribed @param forces one per node, or none
template <class Arrays>
void store_loading(Arrays& a, std::span<const std::uint8_t> fixed, const std::vector<Point>& motion,
                   const std::vector<Point>& forces) {
  put_each(a.motion, [&](index_t n, auto&& node) {
    for (int k = 0; k < 3; ++k) {
      const bool is_fixed = (fixed[std::size_t(n)] >> k & 1) != 0;
      node.dx()[k] = is_fixed ? motion[std::size_t(n)][std::size_t(k)] : 0.0;
    }
  });
  put_each(a.loads, [&](index_t n, auto&& node) {
    for (int k = 0; k < 3; ++k) node.f()[k] = forces.empty() ? 0.0 : forces[std::size_t(n)][std::size_t(k)];
  });
}

/// The prescribed components of a level's nodes, as MeshLevel::fixed has them.
template <class On, class Constraints>
[[nodiscard]] std::vector<std::uint8_t> plain_constraints(On& on, const Constraints& constraints) {
  on.wait();
  const auto host = moved_to<quasistatic::NodeConstraintArray<typename Constraints::Precision>>(constraints);
  std::vector<std::uint8_t> fixed(std::size_t(host.size()));
  for (index_t n = 0; n < host.size(); ++n) {
    const int bits = host.const_view()[n].fixed();
    fixed[std::size_t(n)] = static_cast<std::uint8_t>(bits);
  }
  return fixed;
}
/// The parents of a level's nodes, as MeshLevel::parents has them.
template <class On, class Parents>
[[nodiscard]] std::vector<std::array<Index, 2>> plain_parents(On& on, const Parents& parents) {
  on.wait();
  const auto host = moved_to<quasistatic::NodeParentsArray<typename Parents::Precision>>(parents);
  std::vector<std::array<Index, 2>> plain(std::size_t(host.size()));
  for (index_t n = 0; n < host.size(); ++n) {
    for (int k = 0; k < 2; ++k) plain[std::size_t(n)][std::size_t(k)] = host.const_view()[n].nodes()[k];
  }
  return plain;
}

/// Motion of nodes that coincide, and forces shared by the parents.
inline void coarsen_loading(std::span<const std::array<Index, 2>> parents, Index coarse_nodes,
                            std::vector<Point>& motion, std::vector<Point>& forces) {
  const auto size = static_cast<std::size_t>(coarse_nodes);
  std::vector<Point> coarse_motion(size, Point{}), coarse_forces(forces.empty() ? 0 : size, Point{});
  for (std::size_t n = 0; n < parents.size(); ++n) {
    const auto [p, q] = parents[n];
    if (p == q) coarse_motion[static_cast<std::size_t>(p)] = motion[n];
    if (forces.empty()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      coarse_forces[static_cast<std::size_t>(p)][k] += 0.5 * forces[n][k];
      coarse_forces[static_cast<std::size_t>(q)][k] += 0.5 * forces[n][k];
    }
  }
  motion = std::move(coarse_motion);
  forces = std::move(coarse_forces);
}

/// Rounding of positions, eps |x|, times the stiffness of a node [N/m], with a factor for few numbers that add up [N].
/// @param farthest |x| at most [m]
[[nodiscard]] inline double rounding_force(double stiffness, double farthest, std::size_t nodes) {
  return 32 * std::numeric_limits<double>::epsilon() * farthest * stiffness * std::sqrt(double(nodes));
}

/// About the stiffness of a node, with that of planes where there are some [N/m].
/// @param spacing mean distance of neighbours [m]
[[nodiscard]] inline double node_stiffness(const SolverSettings& settings, bool planes, double spacing) {
  return spacing * settings.youngs_modulus *
         (1 / (1 - 2 * std::min(settings.poissons_ratio, 0.4999)) + (planes ? settings.plane_stiffness : 0.0));
}

/// The rounding force at a load between 0 and 1. @param level whose nodes all have tets, where it has no lists
[[nodiscard]] inline double rounding_force(const SolverSettings& settings, const MeshLevel& level,
                                           const std::vector<Point>& motion, bool planes, double spacing) {
  const auto& rows = level.mesh.node_tets.first;
  double farthest = 0;
  for (std::size_t n = 0; n < level.rest.size(); ++n) {
    if (!rows.empty() && rows[n] == rows[n + 1]) continue;  // no part of the body
    for (std::size_t k = 0; k < 3; ++k) {
      farthest = std::max(farthest, std::abs(level.rest[n][k]) + std::abs(motion[n][k]));
    }
  }
  return rounding_force(node_stiffness(settings, planes, spacing), farthest, level.rest.size());
}

}  // namespace physgen::fem
