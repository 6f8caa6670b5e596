// Products of edges' blocks that lie by bricks of nodes, on CUDA: see edge_bricks.h. For CUDA translation units.
#pragma once

#include <fem/kernels/edge_bricks.h>
#include <fem/numerics/scalar.h>
#include <physgen/cuda/check.h>
#include <physgen/cuda/parallel_for.h>

namespace physgen::fem {

/// The arrays of a product with blocks of edges alone; views of any layout and format.
/// @tparam DifferentialView AosPadded, so that the three sums of a node are one atomic
template <class EdgeStiffnessView, class DisplacementView, class DifferentialView>
struct BrickProduct {
  using Scalar = typename DifferentialView::Precision;
  EdgeBricks::View bricks;
  EdgeStiffnessView edge_stiffness;  ///< elasticity::EdgeStiffness, in the order of bricks
  DisplacementView displacements;    ///< elasticity::NodeDisplacement
  DifferentialView differentials;    ///< elasticity::NodeForceDifferential: the product is added
};
template <class... Arguments>
BrickProduct(EdgeBricks::View, Arguments...) -> BrickProduct<Arguments...>;

namespace detail {

template <Index kMostNodes>
constexpr int brick_threads = kMostNodes > EdgeBricks::most_nodes ? 1024 : 512;

/// Calls use(place, k) for the k-th edge of the node at a place of the order, for all k that are `turn` modulo `turns`.
/// The lanes of a warp have the places of a slice and come here together.
/// @param exists whether this lane has a place
template <class Use>
__device__ void for_each_edge_of_slice(const EdgeBricks::View& bricks, Index at, bool exists, int turn, int turns,
                                       const Use& use) {
  constexpr unsigned all = 0xffffffffU;
  const unsigned below = (1U << (threadIdx.x % 32)) - 1;
  const Index begin = exists ? bricks.begin[at] : 0;
  const int count = exists ? bricks.begin[at + 1] - begin : 0;
  Index place = __shfl_sync(all, begin, 0);
  for (int k = 0, next = turn;; ++k) {
    const unsigned active = __ballot_sync(all, k < count);
    if (active == 0) return;
    if (k == next) {
      next += turns;
      if (k < count) use(place + __popc(active & below), k);
    }
    place += __popc(active);
  }
}

/// By one thread block: a thread takes a node, or every so manieth of its edges where there are more threads.
template <Index kMostNodes, class Product>
__device__ void add_brick(const Product& product, Index brick) {
  using S = typename Product::Scalar;
  __shared__ S displacements[3][kMostNodes], sums[3][kMostNodes];
  const EdgeBricks::View& bricks = product.bricks;
  const Index from = bricks.places_begin(brick), nodes = bricks.places_begin(brick + 1) - from;
  const auto thread = static_cast<int>(threadIdx.x), threads = static_cast<int>(blockDim.x);
  for (int own = thread; own < nodes; own += threads) {
    const index_t node = bricks.order[from + own];
    const Vector3<S> dx = product.displacements[node].dx();
    PHYSGEN_UNROLL
    for (int k = 0; k < 3; ++k) {
      displacements[k][own] = dx[k];
      sums[k][own] = S(0);
    }
  }
  __syncthreads();
  const Vector3<S> zero = Vector3<S>::Zero();
  const int width = (nodes + EdgeBricks::slice - 1) / EdgeBricks::slice * EdgeBricks::slice;
  const int step = width < threads ? width : threads, turns = threads / step, turn = thread / step;
  for (int own = thread % step; turn < turns && own < width; own += step) {
    const bool exists = own < nodes;
    Vector3<S> dx = zero, sum = zero;
    if (exists) dx = Vector3<S>(displacements[0][own], displacements[1][own], displacements[2][own]);
    for_each_edge_of_slice(bricks, from + own, exists, turn, turns, [&](Index place, int /*k*/) {
      const Index other = bricks.others[place];
      const Matrix3<S> E = product.edge_stiffness[index_t{place}].E();
      const Vector3<S> to_other = transpose_multiply_add<S>(E, dx, zero);
      Vector3<S> dx_other;
      if (other < 0) {
        const Index at = ~other;
        PHYSGEN_UNROLL
        for (int k = 0; k < 3; ++k) {
          dx_other[k] = displacements[k][at];
          atomicAdd(&sums[k][at], to_other[k]);
        }
      } else {
        dx_other = product.displacements[index_t{other}].dx();
        add(index_t{place}, product.differentials[index_t{other}].df(), to_other);
      }
      sum = multiply_add<S>(E, dx_other, sum);
    });
    if (exists) {
      PHYSGEN_UNROLL
      for (int k = 0; k < 3; ++k) atomicAdd(&sums[k][own], sum[k]);
    }
  }
  __syncthreads();
  for (int own = thread; own < nodes; own += threads) {
    const index_t node = bricks.order[from + own];
    const Vector3<S> sum(sums[0][own], sums[1][own], sums[2][own]);
    if (bricks.bricks == 1) {
      product.differentials[node].df() += sum;
    } else {
      add(node, product.differentials[node].df(), sum);
    }
  }
}

template <Index kMostNodes, class Product>
__global__ void __launch_bounds__(brick_threads<kMostNodes>) add_bricks(const Product product) {
  add_brick<kMostNodes>(product, static_cast<Index>(blockIdx.x));
}

/// Slices of a brick, and turns at the edges of their nodes, are spread over thread blocks.
constexpr int slices_per_block = 4, edge_turns = 4;

template <class Kernel>
__global__ void for_each_edge_of_bricks(const EdgeBricks::View bricks, const Kernel kernel) {
  const auto brick = static_cast<Index>(blockIdx.x);
  const auto at = bricks.places_begin(brick) + static_cast<Index>(blockIdx.y * blockDim.x + threadIdx.x);
  const bool exists = at < bricks.places_begin(brick + 1);
  const Index first = exists ? bricks.first[bricks.order[at]] : 0;
  for_each_edge_of_slice(bricks, at, exists, static_cast<int>(blockIdx.z), edge_turns,
                         [&](Index place, int k) { kernel(index_t{first + k}, index_t{place}); });
}

}  // namespace detail

/// df += what the edges have of K dx, ordered in `stream`; does not wait. The order of the sums differs from run to
/// run.
/// @pre the differentials' elements are stored as computed; the views have the bricks' nodes and edges
/// @throw Error when the launch fails
template <class... Views>
void add_edges(Cuda /*space*/, const BrickProduct<Views...>& product, Stream stream = nullptr) {
  if (product.bricks.nodes == 0) return;
  constexpr Index few = EdgeBricks::few_nodes, most = EdgeBricks::most_nodes;
  const auto blocks = static_cast<unsigned>(product.bricks.bricks);
  if (blocks == 1) {
    detail::add_bricks<few><<<blocks, detail::brick_threads<few>, 0, stream>>>(product);
  } else {
    detail::add_bricks<most><<<blocks, detail::brick_threads<most>, 0, stream>>>(product);
  }
  cuda::check(cudaGetLastError(), "launching the edges of a product by bricks");
}

/// Calls kernel(e, i) for each edge: e is its number in the mesh, i in the order of bricks.
/// @throw Error when the launch fails
template <class Kernel>
void for_each_edge(Cuda /*space*/, const EdgeBricks::View& bricks, const Kernel& kernel, Stream stream = nullptr) {
  if (bricks.nodes == 0) return;
  constexpr int threads = detail::slices_per_block * EdgeBricks::slice;
  const Index most = bricks.bricks == 1 ? bricks.nodes : EdgeBricks::most_nodes;
  const dim3 blocks(static_cast<unsigned>(bricks.bricks), static_cast<unsigned>((most + threads - 1) / threads),
                    detail::edge_turns);
  detail::for_each_edge_of_bricks<<<blocks, threads, 0, stream>>>(bricks, kernel);
  cuda::check(cudaGetLastError(), "launching a kernel over edges by bricks");
}

}  // namespace physgen::fem
