// The symmetric product on CUDA: see symmetric_product.h. For CUDA translation units.
#pragma once

#include <fem/kernels/symmetric_product.h>
#include <physgen/cuda/check.h>
#include <physgen/cuda/parallel_for.h>

#include <algorithm>

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

constexpr int threads_per_block = 128;
constexpr int staged_edges = 256;

/// Contributions that other blocks may have written since this one began: from the L2 cache, which all have.
template <class S>
__device__ Vector3<S> value_in_cache(const Contribution<S>* from) {
  if constexpr (sizeof(S) == 4) {
    const float4 words = __ldcg(reinterpret_cast<const float4*>(from));
    return {words.x, words.y, words.z};
  } else {
    const double2 xy = __ldcg(reinterpret_cast<const double2*>(from));
    return {xy.x, xy.y, __ldcg(&from->z)};
  }
}

/// What a kernel goes by: see EdgeSums.
struct OrderedSums {
  Index nodes, tiles, delay;
  const Index *first, *begin, *place, *needed;
  unsigned *begun, *ended, *groups;
};

/// The nodes of a tile and all their edges as m: contributions to these pass through shared memory and are added in
/// order, those to other nodes are stored.
template <bool kAdds, class Product>
__device__ void sum_own_edges(const Product& product, const OrderedSums& sums, Index tile,
                              typename Product::Scalar (&own)[3][staged_edges],
                              Contribution<typename Product::Scalar>* contributions,
                              Contribution<typename Product::Scalar>* own_sums) {
  using S = typename Product::Scalar;
  const Index node_begin = tile * EdgeSums::tile_nodes;
  const Index node_end = min(node_begin + EdgeSums::tile_nodes, sums.nodes);
  const Index node = node_begin + static_cast<Index>(threadIdx.x);
  const bool has_node = node < node_end;
  const Index begin = sums.first[node_begin], end = sums.first[node_end];
  Vector3<S> sum = Vector3<S>::Zero();
  if (has_node) {
    if constexpr (kAdds) {
      sum = product.differentials[index_t{node}].df();
    } else {
      sum = node_contribution(product, index_t{node});
    }
  }
  for (Index stage = begin; stage < end; stage += staged_edges) {
    const Index stage_end = min(stage + staged_edges, end);
    for (Index e = stage + static_cast<Index>(threadIdx.x); e < stage_end; e += threads_per_block) {
      const EdgeContributions<S> contribution = edge_contributions(product, index_t{e});
      for (int k = 0; k < 3; ++k) own[k][e - stage] = contribution.to_m[k];
      contributions[sums.place[e]] = Contribution<S>(contribution.to_n);
    }
    __syncthreads();
    if (has_node) {
      const Index from = max(sums.first[node], stage), to = min(sums.first[node + 1], stage_end);
      for (Index e = from; e < to; ++e) sum += Vector3<S>(own[0][e - stage], own[1][e - stage], own[2][e - stage]);
    }
    __syncthreads();
  }
  if (has_node) own_sums[node] = Contribution<S>(sum);
}

/// The nodes of a tile get their sums, once all tiles have stored whose edges lead to it.
template <class Product>
__device__ void add_contributions_of_others(const Product& product, const OrderedSums& sums, Index tile,
                                            typename Product::Scalar (&staged)[3][staged_edges],
                                            const Contribution<typename Product::Scalar>* contributions,
                                            const Contribution<typename Product::Scalar>* own_sums) {
  using S = typename Product::Scalar;
  constexpr int group_tiles = EdgeSums::group_tiles;
  const auto thread = static_cast<Index>(threadIdx.x);
  for (Index g = sums.needed[tile] / group_tiles + thread; g <= tile / group_tiles; g += threads_per_block) {
    const auto all = static_cast<unsigned>(min(group_tiles, sums.tiles - g * group_tiles));
    while (*static_cast<volatile const unsigned*>(&sums.groups[g]) < all) __nanosleep(100);
  }
  __threadfence();
  __syncthreads();
  const Index node_begin = tile * EdgeSums::tile_nodes;
  const Index node_end = min(node_begin + EdgeSums::tile_nodes, sums.nodes);
  const Index node = node_begin + static_cast<Index>(threadIdx.x);
  const bool has_node = node < node_end;
  const Index begin = sums.begin[node_begin], end = sums.begin[node_end];
  Vector3<S> sum = Vector3<S>::Zero();
  if (has_node) sum = value_in_cache(&own_sums[node]);
  for (Index stage = begin; stage < end; stage += staged_edges) {
    const Index stage_end = min(stage + staged_edges, end);
    for (Index k = stage + static_cast<Index>(threadIdx.x); k < stage_end; k += threads_per_block) {
      const Vector3<S> value = value_in_cache(&contributions[k]);
      for (int c = 0; c < 3; ++c) staged[c][k - stage] = value[c];
    }
    __syncthreads();
    if (has_node) {
      const Index from = max(sums.begin[node], stage), to = min(sums.begin[node + 1], stage_end);
      for (Index k = from; k < to; ++k) {
        sum += Vector3<S>(staged[0][k - stage], staged[1][k - stage], staged[2][k - stage]);
      }
    }
    __syncthreads();
  }
  if (has_node) product.differentials[index_t{node}].df() = sum;
}

/// Block b, in the order in which blocks begin, forms what tile b stores, and then ends tile b - delay: what it reads
/// was stored lately and lies in the L2 cache. A block waits for tiles alone of blocks that have begun, which wait for
/// nothing before they have stored. The last block to end leaves the counts as they were.
template <bool kAdds, class Product>
__global__ void __launch_bounds__(threads_per_block)
    sum_edges_in_order(const Product product, const OrderedSums sums,
                       Contribution<typename Product::Scalar>* contributions,
                       Contribution<typename Product::Scalar>* own_sums) {
  __shared__ typename Product::Scalar staged[3][staged_edges];
  __shared__ unsigned number;
  if (threadIdx.x == 0) number = atomicAdd(sums.begun, 1U);
  __syncthreads();
  const auto tile = static_cast<Index>(number);
  if (tile < sums.tiles) {
    sum_own_edges<kAdds>(product, sums, tile, staged, contributions, own_sums);
    __threadfence();
    __syncthreads();
    if (threadIdx.x == 0) atomicAdd(&sums.groups[tile / EdgeSums::group_tiles], 1U);
  }
  if (tile >= sums.delay) {
    add_contributions_of_others(product, sums, tile - sums.delay, staged, contributions, own_sums);
  }
  __syncthreads();
  if (threadIdx.x == 0) number = atomicAdd(sums.ended, 1U);
  __syncthreads();
  if (number + 1 < gridDim.x) return;
  for (auto g = static_cast<Index>(threadIdx.x); g * EdgeSums::group_tiles < sums.tiles; g += threads_per_block) {
    sums.groups[g] = 0;
  }
  if (threadIdx.x == 0) *sums.begun = *sums.ended = 0;
}

/// How many tiles a block lags behind: as many as blocks fit on the device.
template <class Global>
[[nodiscard]] Index tiles_of_delay(Global* kernel) {
  static thread_local int asked_device = -1;
  static thread_local Index blocks = 0;
  int device = 0;
  cuda::check(cudaGetDevice(&device), "asking for the current device");
  if (device != asked_device) {
    int each = 0, processors = 0;
    cuda::check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&each, kernel, threads_per_block, 0),
                "asking how many blocks fit");
    cuda::check(cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, device),
                "asking how many processors there are");
    blocks = each * processors;
    asked_device = device;
  }
  return blocks;
}

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
  const auto tiles = static_cast<Index>(sums.tiles());
  const Index lag = tiles_of_delay(sum_edges_in_order<kAdds, Product>);
  // Whole groups, so that a tile's own group has begun when the tile is ended.
  const Index delay = (std::min(lag, tiles) / EdgeSums::group_tiles + 1) * EdgeSums::group_tiles;
  const OrderedSums ordered{static_cast<Index>(sums.nodes()),
                            tiles,
                            delay,
                            sums.first(),
                            sums.contributions_begin(),
                            sums.place(),
                            sums.needed(),
                            sums.begun(),
                            sums.ended(),
                            sums.groups()};
  sum_edges_in_order<kAdds><<<static_cast<unsigned>(tiles + delay), threads_per_block, 0, stream>>>(
      product, ordered, sums.contributions<Scalar>(), sums.own_sums<Scalar>());
  cuda::check(cudaGetLastError(), "launching the edges of a symmetric product");
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
