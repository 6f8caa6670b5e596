// The product with a level's scaled stiffness, in CUDA's own way. For CUDA translation units. On several ranks it is
// the general one.
#pragma once

#include <fem/kernels/symmetric_product_cuda.h>
#include <fem/solver/performs_in.h>
#include <fem/solver/preconditioners/multigrid/cycle.h>
#include <fem/solver/preconditioners/multigrid/row_product.h>
#include <physgen/cuda/executor.h>

namespace physgen::fem {

namespace detail {

template <class On, class Level, class DisplacementView, class DifferentialView>
void add_scaled_edges(On& on, Level& level, const DisplacementView& x, const DifferentialView& y) {
  if (level.rows.is_empty()) {
    add_edges(on, scaled_product(level, x, y), level.sums);
  } else {
    run_rows(on, level.nodes(), AddRowProduct{level.rows.view(), level.scaled_edges.const_view(), x, y});
  }
}

}  // namespace detail

/// r += the edges' part of K d of a level's scaled stiffness.
template <PerformsIn<Cuda> On, class Level>
  requires(!OnRanks<On>)
void add_scaled_edges(On& on, Level& level) {
  detail::add_scaled_edges(on, level, level.direction.const_view(), level.residual.view());
}

/// y = K x of a level's scaled stiffness.
template <PerformsIn<Cuda> On, class Level, class DisplacementView, class DifferentialView>
  requires(!OnRanks<On>)
void multiply_scaled(On& on, Level& level, const DisplacementView& x, const DifferentialView& y) {
  on.run(level.nodes(), MultiplyNodes{level.scaled_nodes.const_view(), x, y});
  detail::add_scaled_edges(on, level, x, y);
}

/// At each entry of rows, where a level has them.
template <PerformsIn<Cuda> On, class Level, class Kernel>
  requires(!OnRanks<On>)
void scale_edges(On& on, Level& level, const Kernel& kernel) {
  if (level.rows.is_empty()) {
    on.run(level.edge_count(), kernel);
  } else {
    on.run(level.scaled_edges.size(), AtEntries{kernel, level.node_edges.const_view().entries()});
  }
}

}  // namespace physgen::fem
