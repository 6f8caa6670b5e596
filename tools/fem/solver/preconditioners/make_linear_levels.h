// The levels of a preconditioner, from the levels of meshes that a solver is given.
#pragma once

#include <fem/mesh/stages.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/hierarchy/level_graphs.h>
#include <fem/solver/levels/linear_level.h>
#include <fem/solver/preconditioners/all.h>
#include <fem/solver/settings.h>

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace physgen::fem {

/// The levels that a solver uses of those it is given, finest first.
struct LevelsInUse {
  std::span<const MeshLevel> levels;
  std::vector<LevelGraph> graphs;  ///< of each
  std::size_t solved = 1;          ///< on how many of them equilibrium is solved
};
[[nodiscard]] inline LevelsInUse levels_in_use(const std::vector<MeshLevel>& given, const SolverSettings& settings) {
  const auto meshes = static_cast<std::size_t>(std::ranges::find_if(given, &MeshLevel::is_grid) - given.begin());
  const auto [used, solved] = used_levels(settings, given.size(), meshes);
  LevelsInUse result{std::span(given).first(used), {}, solved};
  result.graphs = graphs_in_use(result.levels, settings);
  return result;
}

/// Of each graph only the edges stay.
/// @tparam Level LevelOver
template <class Level>
[[nodiscard]] std::vector<std::unique_ptr<Level>> make_linear_levels(LevelsInUse& used,
                                                                     const SolverSettings& settings) {
  const Preconditioner kind = settings.newton.preconditioner.kind;
  std::vector<std::unique_ptr<Level>> made;
  for (std::size_t l = 0; l < used.graphs.size(); ++l) {
    InStage stage("arrays of levels");
    stage.moves(used.graphs[l].edges, used.graphs[l].node_edges.entries);
    const LevelGraph* next = l + 1 < used.graphs.size() ? &used.graphs[l + 1] : nullptr;
    if (settings.newton.product == Product::assembled) {
      made.push_back(std::make_unique<Level>(used.graphs[l], next));
    } else {
      const MatrixFree needs{asks_for(kind, asks::inverses), next != nullptr};
      made.push_back(std::make_unique<Level>(used.graphs[l], needs));
    }
    if (l < used.solved) {
      with_preconditioner(kind,
                          [&]<class Type>() { Type::make_arrays(*made.back(), used.graphs[l], used.levels[l].rest); });
    }
    stage.moves_bytes(made.back()->bytes());
    used.graphs[l].node_edges = used.graphs[l].children = used.graphs[l].edge_terms = {};
  }
  return made;
}

}  // namespace physgen::fem
