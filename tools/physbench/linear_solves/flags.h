// The flags of the group linear_solves.
#pragma once

#include <fem/solver/linear_measurement.h>
#include <truthcube/options.h>

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace physgen::bench {

/// The methods that are measured, a row each: conjugate gradients with a preconditioner of the solver's catalogue, or
/// with block Jacobi over cuSPARSE's block sparse product.
using Method = std::optional<fem::Preconditioner>;
inline constexpr Method vendor = std::nullopt;

struct SolveFlags {
  std::vector<int> cells;  ///< empty: as --objects says, or 16
  std::vector<double> poissons_ratios{0.49};
  truthcube::VolumeTreatment volume = truthcube::VolumeTreatment::patches;
  double compression = 0;
  std::vector<Method> methods{fem::Preconditioner::multigrid, fem::Preconditioner::block_jacobi};
  std::vector<fem::TangentPrecision> precisions{fem::TangentPrecision::half};
  std::vector<fem::LinearNorm> norms{fem::LinearNorm::euclidean};
  double tolerance = 1e-4;
  int repeats = 5;
  fem::Device device = fem::Device::cpu;
};

[[nodiscard]] std::string name_of(Method method);
[[nodiscard]] std::string name_of(fem::TangentPrecision precision);
[[nodiscard]] std::string name_of(fem::LinearNorm norm);
[[nodiscard]] std::string name_of(truthcube::VolumeTreatment volume);

/// Lets the command line set `flags`, which lives as long as it.
void add_solve_flags(CLI::App& app, SolveFlags& flags);

/// @throw Error for a value that is out of range, or has no method here
void check(const SolveFlags& flags);

}  // namespace physgen::bench
