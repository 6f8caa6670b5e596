// Conjugate gradients with block Jacobi over cuSPARSE's block sparse product, on CUDA: what one has without writing a
// product or a preconditioner of one's own. All else is as favourable as it is for the solver that it is compared with.
#pragma once

#include <fem/solver/assembled_stiffness.h>
#include <fem/solver/linear_measurement.h>

#include <span>
#include <vector>

#include "linear_solves/vendor_measurement.h"

namespace physgen::bench {

/// Solves K dx = -force in float, as often as the task says.
/// @param fixed per node: bit k is set where component k is prescribed
/// @param step where it is wanted
/// @pre missing_cusparse() is empty (vendor/cusparse_product.h)
/// @throw Error when sizes differ, or CUDA or cuSPARSE fails
[[nodiscard]] VendorMeasurement solve_by_vendor(const fem::AssembledStiffness& stiffness,
                                                std::span<const std::uint8_t> fixed, std::span<const fem::Point> force,
                                                const fem::LinearTask& task, std::vector<fem::Point>* step);

}  // namespace physgen::bench
