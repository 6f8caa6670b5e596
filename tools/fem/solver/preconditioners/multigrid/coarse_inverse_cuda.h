// The coarsest inverse on CUDA, in one thread block. For CUDA translation units.
#pragma once

#include <fem/solver/performs_in.h>
#include <fem/solver/preconditioners/multigrid/coarse_inverse.h>
#include <physgen/cuda/executor.h>

namespace physgen::fem {

namespace detail {

/// Entries of the matrix that consists of an inverse's blocks.
template <class InverseView>
struct DenseEntries {
  using Real = typename InverseView::Precision;
  int nodes;
  InverseView inverse;  ///< quasistatic::CoarseInverse

  __device__ decltype(auto) operator()(int r, int c) const {
    return inverse[index_t{r / 3} * nodes + c / 3].G()[3 * (c % 3) + r % 3];
  }
};

/// The stiffness of n nodes as a dense matrix. @param thread of `threads`, which come here together
template <class Stiffness, class Entries>
__device__ void put_stiffness(int n, int edges, const Stiffness& stiffness, const Entries& entries, int thread,
                              int threads) {
  using Real = typename Entries::Real;
  const auto put = [&](index_t i, index_t j, const Matrix3<Real>& block) {
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r) entries(3 * static_cast<int>(i) + r, 3 * static_cast<int>(j) + c) = block(r, c);
    }
  };
  for (int k = thread; k < n * n; k += threads) put(k / n, k % n, Matrix3<Real>::Zero());
  __syncthreads();
  for (int i = thread; i < n; i += threads) stiffness.put_node(i, put);
  for (int e = thread; e < edges; e += threads) stiffness.put_edge(e, put);
  __syncthreads();
}

/// 1 / pivot, or 0 of a component that is prescribed, or whose pivot is rounding: its row and column become 0.
template <class Real>
__device__ Real pivot_factor(Real pivot) {
  return pivot > least_coarse_pivot<Real> ? Real(1) / pivot : Real(0);
}

constexpr int inverse_side = 16;                                   ///< threads by rows, and by columns
constexpr int inverse_tiles = 6;                                   ///< entries of a thread, by rows and by columns
constexpr int most_kept_nodes = inverse_side * inverse_tiles / 3;  ///< of which the matrix fits the threads' registers

/// Gauss-Jordan without pivoting over a symmetric positive definite matrix, which the threads of a block hold in their
/// registers: thread (tx, ty) the entries (ty + 16 a, tx + 16 b).
template <class Stiffness, class InverseView>
__global__ void __launch_bounds__(inverse_side* inverse_side)
    invert_few(int n, int edges, Stiffness stiffness, InverseView inverse) {
  using Real = typename InverseView::Precision;
  constexpr int side = inverse_side, tiles = inverse_tiles;
  __shared__ Real columns[2][side * tiles], rows[2][side * tiles];  // of the pivot, before the step; in turn
  const int size = 3 * n, tx = static_cast<int>(threadIdx.x), ty = static_cast<int>(threadIdx.y);
  const DenseEntries<InverseView> far{n, inverse};
  put_stiffness(n, edges, stiffness, far, side * ty + tx, side * side);
  Real own[tiles][tiles];
  const auto each_entry = [&](const auto& use) {
    PHYSGEN_UNROLL
    for (int a = 0; a < tiles; ++a) {
      PHYSGEN_UNROLL
      for (int b = 0; b < tiles; ++b) {
        const int r = ty + side * a, c = tx + side * b;
        if (r < size && c < size) use(own[a][b], r, c);
      }
    }
  };
  PHYSGEN_UNROLL
  for (int k = 0; k < tiles * tiles; ++k) own[k / tiles][k % tiles] = Real(0);
  each_entry([&](Real& mine, int r, int c) { mine = far(r, c); });
  PHYSGEN_UNROLL
  for (int tile = 0; tile < tiles; ++tile) {
    for (int k = 0; k < side && side * tile + k < size; ++k) {
      const int p = side * tile + k;
      Real *column = columns[p % 2], *row = rows[p % 2];
      PHYSGEN_UNROLL
      for (int a = 0; a < tiles; ++a) {
        if (tx == k) column[ty + side * a] = own[a][tile];
        if (ty == k) row[tx + side * a] = own[tile][a];
      }
      PHYSGEN_UNROLL
      for (int a = 0; a < tiles; ++a) {
        if (tx == k) own[a][tile] = Real(0);
        if (ty == k) own[tile][a] = Real(0);
      }
      __syncthreads();  // and behind it this row and column are written again after the next one alone
      const Real factor = pivot_factor<Real>(column[p]);
      Real of_column[tiles];
      PHYSGEN_UNROLL
      for (int b = 0; b < tiles; ++b) of_column[b] = tx + side * b == p ? Real(1) : row[tx + side * b];
      PHYSGEN_UNROLL
      for (int a = 0; a < tiles; ++a) {
        const int r = ty + side * a;
        const Real scaled = r == p ? -factor : column[r] * factor;
        PHYSGEN_UNROLL
        for (int b = 0; b < tiles; ++b) own[a][b] = fma(-scaled, of_column[b], own[a][b]);
      }
    }
  }
  each_entry([&](const Real& mine, int r, int c) { far(r, c) = mine; });
}

/// The same of a matrix that stays where it is stored, by 32 x 32 threads.
template <class Stiffness, class InverseView>
__global__ void __launch_bounds__(1024) invert_many(int n, int edges, Stiffness stiffness, InverseView inverse) {
  using Real = typename InverseView::Precision;
  extern __shared__ unsigned char memory[];
  const int size = 3 * n, tx = static_cast<int>(threadIdx.x), ty = static_cast<int>(threadIdx.y), thread = 32 * ty + tx;
  Real* column = reinterpret_cast<Real*>(memory);  // of the pivot, before the step
  Real* row = column + size;
  const DenseEntries<InverseView> entries{n, inverse};
  put_stiffness(n, edges, stiffness, entries, thread, 1024);
  for (int p = 0; p < size; ++p) {
    for (int k = thread; k < size; k += 1024) {
      column[k] = entries(k, p);
      row[k] = entries(p, k);
    }
    __syncthreads();
    const Real factor = pivot_factor<Real>(column[p]);
    for (int r = ty; r < size; r += 32) {
      const Real scaled = r == p ? -factor : column[r] * factor;
      for (int c = tx; c < size; c += 32) {
        const Real before = r == p || c == p ? Real(0) : Real(entries(r, c));
        entries(r, c) = fma(-scaled, c == p ? Real(1) : row[c], before);
      }
    }
    __syncthreads();
  }
}

}  // namespace detail

/// Makes the inverse of the scaled stiffness over its free components. @pre the level has its scales
template <PerformsIn<Cuda> On, class Level>
void invert_coarsest(On& on, Level& level) {
  if (level.coarse_inverse.size() == 0) return;
  const auto n = static_cast<int>(level.nodes()), edges = static_cast<int>(level.edge_count());
  const auto stiffness = detail::scaled_stiffness(level);
  const auto inverse = level.coarse_inverse.view();
  perform_in_place_of(on, level.nodes(), detail::inverse_of(level), [&](Stream stream) {
    if (n <= detail::most_kept_nodes) {
      const dim3 threads(detail::inverse_side, detail::inverse_side);
      detail::invert_few<<<1, threads, 0, stream>>>(n, edges, stiffness, inverse);
    } else {
      const std::size_t lines = 2 * 3 * static_cast<std::size_t>(n) * sizeof(typename Level::Real);
      detail::invert_many<<<1, dim3(32, 32), lines, stream>>>(n, edges, stiffness, inverse);
    }
    cuda::check(cudaGetLastError(), "inverting the coarsest level");
  });
}

}  // namespace physgen::fem
