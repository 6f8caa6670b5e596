// Whether what a solver on several ranks hands out of nodes and tets that are named is that of all.
#pragma once

#include <fem/solver/solvers/solver_on_ranks.h>
#include <physgen/distributed/ranks.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace physgen::fem {

/// Named in any order, some more than once and most not at all; ascending; and none. Where it is another, all ranks
/// end.
/// @param all of the first rank @param of_named of_named(numbers)
template <class All, class OfNamed>
void check_named(const Ranks& ranks, const std::string& what, Index count, const All& all, const OfNamed& of_named) {
  constexpr unsigned seed = 2611;  // the same on all ranks
  std::mt19937 random(seed);
  std::vector<Index> named(static_cast<std::size_t>(count / 3 + 1));
  for (Index& n : named) n = std::uniform_int_distribution<Index>(0, count - 1)(random);
  std::vector<Index> ascending = named;
  std::ranges::sort(ascending);
  for (const std::vector<Index>& asked : {named, ascending, std::vector<Index>()}) {
    const auto found = of_named(asked);
    bool is_same = found.size() == (ranks.is_first() ? asked.size() : 0);
    for (std::size_t i = 0; i < found.size() && is_same; ++i)
      is_same = found[i] == all.at(static_cast<std::size_t>(asked[i]));
    if (!is_same) ranks.fail(what + " of named objects are not theirs, with the seed " + std::to_string(seed));
  }
}

/// @param solver an EquilibriumSolver or a DynamicSolver @param tets of the finest mesh
template <class Solver>
void check_named(const Ranks& ranks, Solver& solver, std::size_t tets) {
  auto& on_ranks = dynamic_cast<RankReport&>(solver);
  const std::vector<Index> nodes = on_ranks.nodes_of_levels();
  const auto positions_of = [&](std::size_t level) {
    return [&, level](const auto& named) { return on_ranks.positions_of(level, named); };
  };
  const auto forces_of = [&](std::size_t level) {
    return [&, level](const auto& named) { return on_ranks.forces_of(level, named); };
  };
  check_named(ranks, "positions", nodes.at(0), solver.positions(), positions_of(0));
  check_named(ranks, "forces", nodes[0], solver.forces(), forces_of(0));
  check_named(ranks, "stresses", static_cast<Index>(tets), solver.stresses(),
              [&](const auto& named) { return on_ranks.stresses_of(named); });
  if constexpr (requires { solver.state(); }) {
    const auto state = solver.state();
    if (state.positions.size() != nodes.size()) ranks.fail("a solver has other levels than its state");
    for (std::size_t l = 1; l < nodes.size(); ++l) {
      check_named(ranks, "coarser positions", nodes[l], state.positions[l], positions_of(l));
    }
    const auto coarser = solver.coarser_equilibrium();
    if (coarser.has_value() != on_ranks.coarser_contacts().has_value()) ranks.fail("contacts belong to no equilibrium");
    if (coarser) check_named(ranks, "coarser forces", nodes.at(1), coarser->forces, forces_of(1));
  }
}

}  // namespace physgen::fem
