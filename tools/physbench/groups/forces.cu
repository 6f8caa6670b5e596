// The product with the assembled stiffness on the GPU: by gathers over incidences, and by its symmetric half.
#include <fem/kernels/symmetric_product_cuda.h>

#include "groups/forces.h"
#include "measure/cuda_rows.h"

namespace physgen::bench {

namespace {

template <fem::SumOrder kOrder>
struct Multiply {
  template <class Product>
  void operator()(const Product& product, fem::EdgeSums& sums) const {
    fem::multiply(Cuda{}, product, sums, kOrder);
  }
};

template <class Real>
void add_both(std::vector<Row>& rows, index_t tets) {
  add_symmetric_row<CudaKernels, Real>(rows, tets, "symmetric_fast", Multiply<fem::SumOrder::any>());
  add_symmetric_row<CudaKernels, Real>(rows, tets, "symmetric_deterministic", Multiply<fem::SumOrder::fixed>());
}

[[maybe_unused]] const bool rows =
    add(Part{"forces", 0, "add_force_differential", "cuda", [](std::vector<Row>& rows, const Sizes& given) {
               const Sizes sizes = sizes_of_forces(given);
               const auto usual = rows_of_kernel("add_force_differential", "cuda", sizes);
               rows.insert(rows.end(), usual.begin(), usual.end());
               add_both<float>(rows, sizes.cuda);
               add_both<double>(rows, sizes.cuda);
             }});

}  // namespace

}  // namespace physgen::bench
