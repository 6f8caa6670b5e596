// The product with the assembled stiffness, in the CPU's own way.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/kernels/symmetric_product_host.h>
#include <fem/solver/performs_in.h>
#include <physgen/executor.h>

namespace physgen::fem {

/// df = K dx; see symmetric_product_host.h.
template <PerformsIn<Host> On, class... Views>
void multiply(On& on, const SymmetricProduct<Views...>& product, const EdgeSums& sums) {
  perform_in_place_of(on, product.differentials.size(), product,
                      [&](Stream /*stream*/) { multiply(Host{}, product, sums, SumOrder::fixed); });
}

/// df += the edges' part of K dx.
template <PerformsIn<Host> On, class... Views>
void add_edges(On& on, const SymmetricProduct<Views...>& product, const EdgeSums& sums) {
  perform_in_place_of(on, product.differentials.size(), product,
                      [&](Stream /*stream*/) { add_edges(Host{}, product, sums, SumOrder::fixed); });
}

}  // namespace physgen::fem

#pragma pop_macro("I")
