// The symmetric product on CUDA: see symmetric_product.h. For CUDA translation units.
#pragma once

#include <fem/kernels/symmetric_product.h>
#include <physgen/cuda/check.h>
#include <physgen/cuda/parallel_for.h>

namespace physgen::fem {

/// df = what the nodes have of K dx.
template <class NodeStiffnessView, class DisplacementView, class DifferentialView>
struct MultiplyNodes {
  using Scalar = typename DifferentialView::Precision;
  NodeStiffnessView node_stiffness;  ///< elasticity::NodeStiffness
  DisplacementView displacements;    ///< elasticity::NodeDisplacement
  DifferentialView differentials;    ///< elasticity::NodeForceDifferential, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    differentials[node].df() = detail::node_contribution(*this, node);
  }
};

namespace detail {

/// A thread takes an edge. Edges of one node lie side by side: their contributions to it are summed within the warp,
/// and one thread adds the sum.
template <class Product>
__global__ void add_edge_products(const Product product, index_t edges) {
  using S = typename Product::Scalar;
  constexpr unsigned all = 0xffffffffU;
  const index_t i = blockIdx.x * index_t{blockDim.x} + threadIdx.x;
  const int lane = static_cast<int>(threadIdx.x % 32);
  int m = -1;
  Vector3<S> sum = Vector3<S>::Zero();
  if (i < edges) {
    const EdgeContributions<S> contribution = edge_contributions(product, i);
    const auto ends = product.edges[i].nodes();
    m = ends[0];
    sum = contribution.to_m;
    add(i, product.differentials[ends[1]].df(), contribution.to_n);
  }
#pragma unroll
  for (int distance = 1; distance < 32; distance *= 2) {
    const int other = __shfl_down_sync(all, m, distance);
    const bool same = lane + distance < 32 && other == m;
#pragma unroll
    for (int k = 0; k < 3; ++k) {
      const S value = __shfl_down_sync(all, sum[k], distance);
      sum[k] += same ? value : S(0);
    }
  }
  const int before = __shfl_up_sync(all, m, 1);
  if (i < edges && (lane == 0 || before != m)) add(i, product.differentials[m].df(), sum);
}

constexpr int nodes_per_block = 32;
constexpr int threads_per_block = 128;
constexpr int staged_edges = 256;

/// A block takes some nodes and all their edges as m: contributions to these pass through shared memory and are added
/// in order, those to other nodes are stored.
template <bool kAdds, class Product>
__global__ void __launch_bounds__(threads_per_block)
    sum_own_edges(const Product product, index_t nodes, const Index* first, const Index* place,
                  Contribution<typename Product::Scalar>* contributions) {
  using S = typename Product::Scalar;
  __shared__ S own[3][staged_edges];
  const index_t node_begin = blockIdx.x * index_t{nodes_per_block};
  const index_t node_end = node_begin + nodes_per_block < nodes ? node_begin + nodes_per_block : nodes;
  const index_t node = node_begin + threadIdx.x;
  const bool has_node = threadIdx.x < nodes_per_block && node < node_end;
  const Index begin = first[node_begin], end = first[node_end];
  Vector3<S> sum = Vector3<S>::Zero();
  if (has_node) {
    if constexpr (kAdds) {
      sum = product.differentials[node].df();
    } else {
      sum = node_contribution(product, node);
    }
  }
  for (Index stage = begin; stage < end; stage += staged_edges) {
    const Index stage_end = stage + staged_edges < end ? stage + staged_edges : end;
    for (Index e = stage + static_cast<Index>(threadIdx.x); e < stage_end; e += threads_per_block) {
      const EdgeContributions<S> contribution = edge_contributions(product, index_t{e});
      for (int k = 0; k < 3; ++k) own[k][e - stage] = contribution.to_m[k];
      contributions[place[e]] = Contribution<S>(contribution.to_n);
    }
    __syncthreads();
    if (has_node) {
      const Index from = first[node] > stage ? first[node] : stage;
      const Index to = first[node + 1] < stage_end ? first[node + 1] : stage_end;
      for (Index e = from; e < to; ++e) sum += Vector3<S>(own[0][e - stage], own[1][e - stage], own[2][e - stage]);
    }
    __syncthreads();
  }
  if (has_node) product.differentials[node].df() = sum;
}

template <class Product>
struct AddContributions {
  Product product;
  const Index* begin;
  const Contribution<typename Product::Scalar>* contributions;
  __device__ void operator()(index_t node) const { add_contributions(product, node, begin, contributions); }
};

/// df = K dx; or, where it adds, df += what the edges have of K dx.
template <bool kAdds, class... Views>
void sum_edges(Cuda space, const SymmetricProduct<Views...>& product, const EdgeSums& sums, SumOrder order,
               Stream stream) {
  using Product = SymmetricProduct<Views...>;
  using Scalar = typename Product::Scalar;
  require_sizes(product, sums, SpaceKind::cuda, order);
  if (sums.nodes() == 0) return;
  const auto blocks = [](index_t objects, int each) { return static_cast<unsigned>((objects + each - 1) / each); };
  if (order == SumOrder::any) {
    if constexpr (!kAdds) {
      parallel_for(space, sums.nodes(),
                   MultiplyNodes{product.node_stiffness, product.displacements, product.differentials}, stream);
    }
    if (sums.edges() == 0) return;
    constexpr int threads = 256;
    add_edge_products<<<blocks(sums.edges(), threads), threads, 0, stream>>>(product, sums.edges());
    cuda::check(cudaGetLastError(), "launching the edges of a symmetric product");
    return;
  }
  sum_own_edges<kAdds><<<blocks(sums.nodes(), nodes_per_block), threads_per_block, 0, stream>>>(
      product, sums.nodes(), sums.first(), sums.place(), sums.contributions<Scalar>());
  cuda::check(cudaGetLastError(), "launching the edges of a symmetric product");
  parallel_for(space, sums.nodes(),
               AddContributions<Product>{product, sums.contributions_begin(), sums.contributions<Scalar>()}, stream);
}

}  // namespace detail

/// df = K dx, ordered in `stream`; does not wait. SumOrder::any adds with atomics, in an order that differs from run to
/// run; SumOrder::fixed stores the contributions and gives the same bits on every run.
/// @pre the differentials' elements are stored as computed
/// @throw Error when arrays of the product differ in size, `sums` was made for other sizes, or not for CUDA memory and
/// this precision, or a launch fails
template <class... Views>
void multiply(Cuda space, const SymmetricProduct<Views...>& product, const EdgeSums& sums, SumOrder order,
              Stream stream = nullptr) {
  detail::sum_edges<false>(space, product, sums, order, stream);
}

/// df += what the edges have of K dx: all of it but the diagonal blocks, for kernels that form that part themselves. As
/// multiply() otherwise.
template <class... Views>
void add_edges(Cuda space, const SymmetricProduct<Views...>& product, const EdgeSums& sums, SumOrder order,
               Stream stream = nullptr) {
  detail::sum_edges<true>(space, product, sums, order, stream);
}

}  // namespace physgen::fem
