#include <fem/solver/linear/product_cuda.h>
#include <physgen/cuda/executor.h>

#include "linear_solves/vendor_program.h"
#include "linear_solves/vendor_solver.h"
#include "vendor/cusparse_product.h"

namespace physgen::bench {

VendorMeasurement solve_by_vendor(const fem::AssembledStiffness& stiffness, std::span<const std::uint8_t> fixed,
                                  std::span<const fem::Point> force, const fem::LinearTask& task,
                                  std::vector<fem::Point>* step) {
  CudaExecutor on(static_cast<index_t>(stiffness.nodes.size()));
  VendorProgram<CudaExecutor, CusparseProduct> program(
      on, stiffness, fixed, force,
      [&](float* x, float* y, Stream stream) { return CusparseProduct::fastest(stiffness, fixed, x, y, stream); });
  VendorMeasurement measurement = program.measure(task);
  if (step != nullptr) program.read_step(*step);
  return measurement;
}

}  // namespace physgen::bench
