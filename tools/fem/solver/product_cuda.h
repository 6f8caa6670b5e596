// The steps that an executor does in a way of its own on CUDA: the product with the assembled stiffness, and the
// coarsest inverse. For CUDA translation units.
#pragma once

#include <fem/kernels/edge_slices_cuda.h>
#include <fem/kernels/symmetric_product_cuda.h>
#include <fem/solver/coarse_inverse.h>
#include <fem/solver/cycle.h>
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

namespace detail {

template <class On, class Level, class DisplacementView, class DifferentialView>
void add_scaled_edges(On& on, Level& level, const DisplacementView& x, const DifferentialView& y) {
  if (level.slices.is_empty()) {
    add_edges(on, scaled_product(level, x, y), level.sums);
  } else {
    on.perform([&](Stream stream) {
      add_edges(Cuda{}, SliceProduct{level.slices.view(), level.scaled_edges.const_view(), x, y}, stream);
    });
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
  on.run(level.nodes(), MultiplyNodes{level.scaled_nodes.const_view(), x, y});
  detail::add_scaled_edges(on, level, x, y);
}

/// Into the order of slices, where a level has them.
template <PerformsIn<Cuda> On, class Level, class Kernel>
void scale_edges(On& on, Level& level, const Kernel& kernel) {
  if (level.slices.is_empty()) {
    on.run(level.edge_count(), kernel);
  } else {
    on.perform([&](Stream stream) { for_each_edge(Cuda{}, level.slices.view(), kernel, stream); });
  }
}

namespace detail {

/// Gauss-Jordan without pivots over a symmetric positive definite matrix of n nodes, in one thread block of 32 x 32.
/// Rows of components that are prescribed, or whose pivot is rounding, stay 0.
/// @param shared whether the matrix lies in shared memory while this runs
template <class Stiffness, class InverseView>
__global__ void __launch_bounds__(1024)
    invert_dense(int n, int edges, bool shared, Stiffness stiffness, InverseView inverse) {
  using Real = typename InverseView::Precision;
  extern __shared__ unsigned char memory[];
  const int size = 3 * n, tx = static_cast<int>(threadIdx.x), ty = static_cast<int>(threadIdx.y), thread = 32 * ty + tx;
  Real* column = reinterpret_cast<Real*>(memory);  // of the pivot, before the step
  Real* row = column + size;
  Real* matrix = row + size;
  const auto far = [&](int r, int c) -> decltype(auto) {
    return inverse[index_t{r / 3} * n + c / 3].G()[3 * (c % 3) + r % 3];
  };
  const auto at = [&](int r, int c) -> Real { return shared ? matrix[r * size + c] : static_cast<Real>(far(r, c)); };
  const auto set = [&](int r, int c, Real value) {
    if (shared) {
      matrix[r * size + c] = value;
    } else {
      far(r, c) = value;
    }
  };
  const auto put = [&](index_t i, index_t j, const Matrix3<Real>& block) {
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r) set(3 * static_cast<int>(i) + r, 3 * static_cast<int>(j) + c, block(r, c));
    }
  };
  for (int r = ty; r < size; r += 32) {
    for (int c = tx; c < size; c += 32) set(r, c, Real(0));
  }
  __syncthreads();
  for (int i = thread; i < n; i += 1024) stiffness.put_node(i, put);
  for (int e = thread; e < edges; e += 1024) stiffness.put_edge(e, put);
  __syncthreads();
  for (int p = 0; p < size; ++p) {
    for (int k = thread; k < size; k += 1024) {
      column[k] = at(k, p);
      row[k] = at(p, k);
    }
    __syncthreads();
    const Real pivot = column[p];
    const Real factor = pivot > least_coarse_pivot<Real> ? Real(1) / pivot : Real(0);
    for (int r = ty; r < size; r += 32) {
      const Real scaled = column[r] * factor;
      for (int c = tx; c < size; c += 32) {
        if (r == p) {
          set(r, c, c == p ? factor : row[c] * factor);
        } else {
          set(r, c, c == p ? -scaled : fma(-scaled, row[c], at(r, c)));
        }
      }
    }
    __syncthreads();
  }
  if (!shared) return;
  for (int r = ty; r < size; r += 32) {
    for (int c = tx; c < size; c += 32) far(r, c) = at(r, c);
  }
}

}  // namespace detail

/// Makes the inverse of the scaled stiffness over its free components. @pre the level has its scales
template <PerformsIn<Cuda> On, class Level>
void invert_coarsest(On& on, Level& level) {
  if (level.coarse_inverse.size() == 0) return;
  constexpr std::size_t most_shared = 48 * 1024;
  const auto size = static_cast<std::size_t>(3 * level.nodes());
  const std::size_t lines = 2 * size * sizeof(typename Level::Real), whole = lines + size * lines / 2;
  const bool shared = whole <= most_shared;
  on.perform([&](Stream stream) {
    detail::invert_dense<<<1, dim3(32, 32), shared ? whole : lines, stream>>>(
        static_cast<int>(level.nodes()), static_cast<int>(level.edge_count()), shared, detail::scaled_stiffness(level),
        level.coarse_inverse.view());
    cuda::check(cudaGetLastError(), "inverting the coarsest level");
  });
}

}  // namespace physgen::fem
