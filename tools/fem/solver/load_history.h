// Loadings that change along a path: loads that follow curves of their own, and a solver that goes along them.
#pragma once

#include <fem/solver/quasistatic.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace physgen::fem {

/// A factor of loads, linear between the points of a table and constant beyond its ends.
struct LoadCurve {
  std::string name;
  std::vector<std::array<double, 2>> points;  ///< load, or a time that stands for it; and factor. Loads ascend

  /// @pre as require_curve() says
  [[nodiscard]] double at(double load) const;
};

/// @throw Error naming the curve when it has no points, a number is not finite, or its loads do not ascend
void require_curve(const LoadCurve& curve);

/// What a body is loaded with at each load: motion, forces and pressures that grow in proportion to it, and others that
/// follow curves.
struct LoadHistory {
  struct Part {
    LoadCurve curve;
    Loading loading;  ///< at a factor of 1
  };
  Loading proportional;
  std::vector<Part> parts;

  /// All of them as one loading: that at a factor of 1, and that of a solver whose load is 1 then.
  [[nodiscard]] Loading at(double load) const;
};

/// A solver whose solve_to() takes a load of the history. Where Newton's method does not get to a load, it goes there
/// in halves along the history, up to `most_bisections` times. A curve that is not 0 at a load of 0 acts at once in the
/// first solve.
/// @param solver of history.at(), at rest
/// @throw Error as require_curve(), and as EquilibriumSolver::set_loading()
[[nodiscard]] std::unique_ptr<EquilibriumSolver> follow(std::unique_ptr<EquilibriumSolver> solver, LoadHistory history,
                                                        int most_bisections = SolverSettings().most_bisections);

}  // namespace physgen::fem
