// The product with the assembled stiffness, in CUDA's own way. For CUDA translation units.
#pragma once

#include <fem/kernels/symmetric_product_cuda.h>
#include <fem/solver/performs_in.h>
#include <physgen/cuda/executor.h>

namespace physgen::fem {

/// df = K dx; see symmetric_product_cuda.h.
template <PerformsIn<Cuda> On, class... Views>
void multiply(On& on, const SymmetricProduct<Views...>& product, const EdgeSums& sums) {
  on.perform([&](Stream stream) { multiply(Cuda{}, product, sums, SumOrder::any, stream); });
}

/// df += the edges' part of K dx.
template <PerformsIn<Cuda> On, class... Views>
void add_edges(On& on, const SymmetricProduct<Views...>& product, const EdgeSums& sums) {
  on.perform([&](Stream stream) { add_edges(Cuda{}, product, sums, SumOrder::any, stream); });
}

}  // namespace physgen::fem
