// The product with a level's scaled stiffness, in CUDA's own way. For CUDA translation units.
#pragma once

#include <fem/kernels/symmetric_product_cuda.h>
#include <fem/solver/performs_in.h>
#include <fem/solver/preconditioners/multigrid/cycle.h>
#include <fem/solver/preconditioners/multigrid/row_product.h>
#include <fem/solver/row_sums_cuda.h>
#include <physgen/cuda/executor.h>

namespace physgen::fem {

namespace detail {

/// on.run(n, kernel) with arrays that each of several ranks has whole. @param views as perform_here() takes it
template <class On, class Kernel, class Views>
void run_here(On& on, index_t n, const Kernel& kernel, const Views& views) {
  if constexpr (OnRanks<On>) {
    perform_here(on, [&](Stream stream) { parallel_for(Cuda{}, n, kernel, stream); }, views);
  } else {
    on.run(n, kernel);
  }
}

template <class On, class Level, class DisplacementView, class DifferentialView>
void add_scaled_edges(On& on, Level& level, const DisplacementView& x, const DifferentialView& y) {
  const auto product = scaled_product(level, x, y);
  if (level.rows.is_empty()) return add_edges(on, product, level.sums);
  const AddRowProduct by_rows{level.rows.view(), level.scaled_edges.const_view(), x, y};
  if constexpr (OnRanks<On>) {
    perform_here(on, [&](Stream stream) { start_rows(0, level.nodes(), by_rows, stream); }, product);
  } else {
    run_rows(on, level.nodes(), by_rows);
  }
}

}  // namespace detail

/// r += the edges' part of K d of a level's scaled stiffness.
template <PerformsIn<Cuda> On, class Level>
void add_scaled_edges(On& on, Level& level) {
  detail::add_scaled_edges(on, level, level.direction.const_view(), level.residual.view());
}

/// y = K x of a level's scaled stiffness.
template <PerformsIn<Cuda> On, class Level, class DisplacementView, class DifferentialView>
void multiply_scaled(On& on, Level& level, const DisplacementView& x, const DifferentialView& y) {
  const auto product = scaled_product(level, x, y);
  if constexpr (OnRanks<On>) {
    if (level.rows.is_empty()) return multiply(on, product, level.sums);
  }
  detail::run_here(on, level.nodes(), MultiplyNodes{level.scaled_nodes.const_view(), x, y}, product);
  detail::add_scaled_edges(on, level, x, y);
}

/// At each entry of rows, where a level has them.
template <PerformsIn<Cuda> On, class Level, class Kernel>
void scale_edges(On& on, Level& level, const Kernel& kernel) {
  if (level.rows.is_empty()) {
    on.run(level.edge_count(), kernel);
  } else {
    detail::run_here(on, level.scaled_edges.size(), AtEntries{kernel, level.node_edges.const_view().entries()}, kernel);
  }
}

}  // namespace physgen::fem
