// The command line of linear_solves.
#pragma once

#include <fem/solver/linear_measurement.h>
#include <truthcube/options.h>

#include <filesystem>
#include <string>
#include <vector>

namespace physgen::truthcube {

/// The methods that are measured, a row each.
enum class Method {
  multigrid,     ///< conjugate gradients with the solver's V-cycle
  schwarz,       ///< the same with the multilevel Schwarz preconditioner
  block_jacobi,  ///< the same with block Jacobi
  none,          ///< the same without a preconditioner
  vendor,        ///< conjugate gradients with block Jacobi over cuSPARSE's block sparse product
};

struct LinearOptions {
  std::vector<int> cells{16};
  std::vector<double> poissons_ratios{0.49};
  VolumeTreatment volume = VolumeTreatment::patches;
  double compression = 0;
  std::vector<Method> methods{Method::multigrid, Method::block_jacobi};
  std::vector<fem::TangentPrecision> precisions{fem::TangentPrecision::half};
  std::vector<fem::LinearNorm> norms{fem::LinearNorm::euclidean};
  double tolerance = 1e-4;
  int repeats = 5;
  bool copies = false;  ///< whether the device's own copy is measured, too
  fem::Device device = fem::Device::cpu;
  std::filesystem::path output;  ///< empty: no file
  int threads = 0;               ///< of the CPU, see physgen::set_threads()
  std::string help;              ///< what to print where help was asked for
};

[[nodiscard]] std::string name_of(Method method);
[[nodiscard]] std::string name_of(fem::TangentPrecision precision);
[[nodiscard]] std::string name_of(fem::LinearNorm norm);
[[nodiscard]] std::string name_of(VolumeTreatment volume);

/// @throw Error for a flag or value that does not exist, with the nearest name, is out of range, or has no method here
[[nodiscard]] LinearOptions parse_linear(const std::vector<std::string>& arguments);

}  // namespace physgen::truthcube
