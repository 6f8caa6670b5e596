// The measurements of a solve by the vendor's product.
#pragma once

#include <fem/solver/linear_measurement.h>

#include <string>

namespace physgen::bench {

struct VendorMeasurement {
  /// Without assembly: the stiffness comes from the solver. The preconditioner is the inversion of the nodes' blocks.
  fem::LinearMeasurement measured;
  std::string product;  ///< which of cuSPARSE's
  std::string note;     ///< where the loop could not be recorded as a graph: why
};

}  // namespace physgen::bench
