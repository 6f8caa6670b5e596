// The product with the assembled stiffness, in CUDA's own way. For CUDA translation units.
#pragma once

#include <fem/kernels/symmetric_product_cuda.h>
#include <fem/solver/performs_in.h>
#include <physgen/cuda/executor.h>

namespace physgen::fem {

namespace detail {
template <class On>
inline constexpr SumOrder sum_order = OnRanks<On> ? SumOrder::fixed : SumOrder::any;
}  // namespace detail

/// df = K dx; see symmetric_product_cuda.h.
template <PerformsIn<Cuda> On, class... Views>
void multiply(On& on, const SymmetricProduct<Views...>& product, const EdgeSums& sums) {
  perform_in_place_of(on, product.differentials.size(), product,
                      [&](Stream stream) { multiply(Cuda{}, product, sums, detail::sum_order<On>, stream); });
}

/// df += the edges' part of K dx.
template <PerformsIn<Cuda> On, class... Views>
void add_edges(On& on, const SymmetricProduct<Views...>& product, const EdgeSums& sums) {
  perform_in_place_of(on, product.differentials.size(), product,
                      [&](Stream stream) { add_edges(Cuda{}, product, sums, detail::sum_order<On>, stream); });
}

}  // namespace physgen::fem
