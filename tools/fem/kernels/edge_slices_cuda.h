// Products of edges' blocks that lie by slices of nodes, by one thread block on CUDA: see edge_slices.h. For CUDA
// translation units.
#pragma once

#include <fem/kernels/edge_slices.h>
#include <fem/numerics/scalar.h>
#include <physgen/cuda/check.h>
#include <physgen/cuda/parallel_for.h>

namespace physgen::fem {

/// The arrays of a product with blocks of edges alone; views of any layout and format.
template <class EdgeStiffnessView, class DisplacementView, class DifferentialView>
struct SliceProduct {
  using Scalar = typename DifferentialView::Precision;
  EdgeSlices::View slices;
  EdgeStiffnessView edge_stiffness;  ///< elasticity::EdgeStiffness, in the order of slices
  DisplacementView displacements;    ///< elasticity::NodeDisplacement
  DifferentialView differentials;    ///< elasticity::NodeForceDifferential: the product is added
};
template <class... Arguments>
SliceProduct(EdgeSlices::View, Arguments...) -> SliceProduct<Arguments...>;

namespace detail {

/// Calls use(place, k) for the k-th edge of a node, for all k that are `turn` modulo `turns`. The lanes of a warp have
/// the nodes of a slice, or numbers behind the last node, and come here together.
template <class Use>
__device__ void for_each_edge_of_slice(const EdgeSlices::View& slices, Index node, int turn, int turns,
                                       const Use& use) {
  constexpr unsigned all = 0xffffffffU;
  const unsigned below = (1U << (threadIdx.x % 32)) - 1;
  const bool exists = node < slices.nodes;
  const Index begin = exists ? slices.first[node] : 0;
  const int count = exists ? slices.first[node + 1] - begin : 0;
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
template <class Product>
__device__ void add_slices(const Product& product) {
  using S = typename Product::Scalar;
  __shared__ S displacements[3][EdgeSlices::most_nodes], sums[3][EdgeSlices::most_nodes];
  const EdgeSlices::View& slices = product.slices;
  const auto thread = static_cast<int>(threadIdx.x), threads = static_cast<int>(blockDim.x);
  for (int node = thread; node < slices.nodes; node += threads) {
    const Vector3<S> dx = product.displacements[index_t{node}].dx();
    PHYSGEN_UNROLL
    for (int k = 0; k < 3; ++k) {
      displacements[k][node] = dx[k];
      sums[k][node] = S(0);
    }
  }
  __syncthreads();
  const Vector3<S> zero = Vector3<S>::Zero();
  const int width = (slices.nodes + EdgeSlices::slice - 1) / EdgeSlices::slice * EdgeSlices::slice;
  const int step = width < threads ? width : threads, turns = threads / step, turn = thread / step;
  for (int node = thread % step; turn < turns && node < width; node += step) {
    const bool exists = node < slices.nodes;
    Vector3<S> dx = zero, sum = zero;
    if (exists) dx = Vector3<S>(displacements[0][node], displacements[1][node], displacements[2][node]);
    for_each_edge_of_slice(slices, node, turn, turns, [&](Index place, int /*k*/) {
      const Index other = slices.others[place];
      const Matrix3<S> E = product.edge_stiffness[index_t{place}].E();
      const Vector3<S> to_other = transpose_multiply_add<S>(E, dx, zero);
      Vector3<S> dx_other;
      PHYSGEN_UNROLL
      for (int k = 0; k < 3; ++k) {
        dx_other[k] = displacements[k][other];
        atomicAdd(&sums[k][other], to_other[k]);
      }
      sum = multiply_add<S>(E, dx_other, sum);
    });
    if (exists) {
      PHYSGEN_UNROLL
      for (int k = 0; k < 3; ++k) atomicAdd(&sums[k][node], sum[k]);
    }
  }
  __syncthreads();
  for (int node = thread; node < slices.nodes; node += threads) {
    product.differentials[index_t{node}].df() += Vector3<S>(sums[0][node], sums[1][node], sums[2][node]);
  }
}

constexpr int slice_threads = 1024;

template <class Product>
__global__ void __launch_bounds__(slice_threads) add_all_slices(const Product product) {
  add_slices(product);
}

/// The edges of a node are shared by so many thread blocks.
constexpr int edge_turns = 4;

template <class Kernel>
__global__ void for_each_edge_of_slices(const EdgeSlices::View slices, const Kernel kernel) {
  const auto node = static_cast<Index>(blockIdx.x * blockDim.x + threadIdx.x);
  const Index first = node < slices.nodes ? slices.first[node] : 0;
  for_each_edge_of_slice(slices, node, static_cast<int>(blockIdx.y), edge_turns,
                         [&](Index place, int k) { kernel(index_t{first + k}, index_t{place}); });
}

}  // namespace detail

/// df += what the edges have of K dx, ordered in `stream`; does not wait. The order of the sums differs from run to
/// run.
/// @pre the views have the slices' nodes and edges
/// @throw Error when the launch fails
template <class... Views>
void add_edges(Cuda /*space*/, const SliceProduct<Views...>& product, Stream stream = nullptr) {
  if (product.slices.nodes == 0) return;
  detail::add_all_slices<<<1, detail::slice_threads, 0, stream>>>(product);
  cuda::check(cudaGetLastError(), "launching the edges of a product by slices");
}

/// Calls kernel(e, i) for each edge: e is its number in the mesh, i in the order of slices.
/// @throw Error when the launch fails
template <class Kernel>
void for_each_edge(Cuda /*space*/, const EdgeSlices::View& slices, const Kernel& kernel, Stream stream = nullptr) {
  if (slices.nodes == 0) return;
  constexpr int threads = 2 * EdgeSlices::slice;
  const dim3 blocks(static_cast<unsigned>((slices.nodes + threads - 1) / threads), detail::edge_turns);
  detail::for_each_edge_of_slices<<<blocks, threads, 0, stream>>>(slices, kernel);
  cuda::check(cudaGetLastError(), "launching a kernel over edges by slices");
}

}  // namespace physgen::fem
