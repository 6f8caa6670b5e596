// A bar with groups of its faces and of all of it, for tests of load cases.
#pragma once

#include <fem/mesh/boundary.h>
#include <fem/mesh/refine.h>
#include <fem/solver/load_case.h>

#include <algorithm>

#include "bodies.h"
#include "irregular.h"

namespace physgen::fem {

inline constexpr Point size{0.2, 0.3, 0.5};  ///< of the bar [m]

/// A bar with groups of its faces: x0, x1 (its end), ..., all of it, and an edge.
struct GroupedBar {
  explicit GroupedBar(bool patches = false, int refinements = 0) {
    const Tets tets = irregular_box({2, 3, 4}, size, 0.2, 31);
    levels = make_levels(tets, refinements, patches, [](const Point&) -> std::uint8_t { return 0; });
    MeshLevel& coarsest = levels.back();
    const TetMesh& mesh = coarsest.mesh;
    std::vector<MeshGroup> named;
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double at : {0.0, size[k]}) {
        MeshGroup& group = named.emplace_back();
        group.name = std::string(1, "xyz"[k]) + (at > 0 ? "1" : "0");
        for (const Face& face : boundary_faces(mesh)) {
          const auto on = [&](Index n) { return coarsest.rest[static_cast<std::size_t>(n)][k] == at; };
          if (std::ranges::all_of(face, on)) group.faces.push_back({face[0], face[2], face[1]});  // inward
        }
      }
    }
    MeshGroup& all = named.emplace_back();
    all.name = "all";
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) all.tets.push_back(static_cast<Index>(t));
    MeshGroup& tip = named.emplace_back();
    tip.name = "tip";
    tip.nodes.push_back(mesh.nodes - 1);
    named.emplace_back().name = "empty";
    for (MeshGroup& group : named) complete(group, mesh.tets);
    groups.push_back(named);
    for (std::size_t l = levels.size() - 1; l-- > 0;) {
      groups.insert(groups.begin(), refine_groups(levels[l + 1].mesh, groups.front()));
    }
  }
  [[nodiscard]] const MeshGroup& group(const std::string& name) const { return group_named(groups.front(), name); }

  std::vector<MeshLevel> levels;
  std::vector<std::vector<MeshGroup>> groups;
};

inline SolverSettings settings_of(double nu = 0.3) {
  SolverSettings settings = exact_settings("neo-hookean", nu);
  settings.youngs_modulus = 1e4;
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  settings.nested = false;
  return settings;
}

/// Planes of symmetry at three faces, so that stress along z is all that a pull along z makes.
inline std::vector<Support> symmetric() { return {{"x0", {.x = 0.0}}, {"y0", {.y = 0.0}}, {"z0", {.z = 0.0}}}; }

}  // namespace physgen::fem
