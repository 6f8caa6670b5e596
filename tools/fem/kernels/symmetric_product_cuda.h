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

/// What the edges of a group give to its slots, in the order of the edges.
/// @tparam kHoldsAll whether all are in shared memory; else those of outer nodes are in the places of their sums
template <bool kHoldsAll, class S>
struct SlotSums {
  S* shared;  ///< [3][room]
  int room, own;
  const Index* place;  ///< of the group's outer nodes
  Contribution<S>* contributions;

  [[nodiscard]] __device__ bool is_shared(int slot) const { return kHoldsAll || slot < own; }
  [[nodiscard]] __device__ Vector3<S> get(int slot) const {
    if (is_shared(slot)) return {shared[slot], shared[room + slot], shared[2 * room + slot]};
    return contributions[place[slot - own]].value();
  }
  __device__ void set(int slot, const Vector3<S>& sum) const {
    if (is_shared(slot)) {
      for (int k = 0; k < 3; ++k) shared[k * room + slot] = sum[k];
    } else {
      contributions[place[slot - own]] = Contribution<S>(sum);
    }
  }
};

constexpr int group_threads = EdgeGroups::stage_edges;
constexpr int nodes_of_thread = EdgeGroups::most_nodes / group_threads;

/// A thread block takes a group, its edges by stages: a thread multiplies an edge, and behind a barrier adds those
/// terms of the stage that one slot gets, and those that its own nodes get as m. Sums for outer nodes are stored.
template <bool kAdds, bool kHoldsAll, class Product>
__global__ void __launch_bounds__(group_threads)
    sum_groups(const Product product, const EdgeGroups::View groups, int room,
               Contribution<typename Product::Scalar>* contributions) {
  using S = typename Product::Scalar;
  extern __shared__ unsigned char memory[];
  __shared__ S to_m[2][3][group_threads], to_n[2][3][group_threads];
  __shared__ int slot_of[2][group_threads];
  const auto t = static_cast<int>(threadIdx.x);
  const Index* const first_node = groups.first_node + blockIdx.x;
  const Index* const first_outer = groups.first_outer + blockIdx.x;
  const int own = first_node[1] - first_node[0], slots = own + first_outer[1] - first_outer[0];
  const SlotSums<kHoldsAll, S> sums{reinterpret_cast<S*>(memory), room, own, groups.place + first_outer[0],
                                    contributions};
  for (int slot = t; slot < slots; slot += group_threads) sums.set(slot, Vector3<S>::Zero());
  Vector3<S> sum[nodes_of_thread];
  Index from[nodes_of_thread], to[nodes_of_thread];
#pragma unroll
  for (int k = 0; k < nodes_of_thread; ++k) {
    from[k] = to[k] = 0;
    if (t + k * group_threads >= own) continue;
    const index_t node = first_node[0] + t + k * group_threads;
    from[k] = groups.first_edge[node];
    to[k] = groups.first_edge[node + 1];
    if constexpr (kAdds) {
      sum[k] = product.differentials[node].df();
    } else {
      sum[k] = node_contribution(product, node);
    }
  }
  const Index end = groups.first_edge[first_node[1]];
  int buffer = 0;  // of two: threads fill one while others still add up the terms of the other
  for (Index stage = groups.first_edge[first_node[0]]; stage < end; stage += group_threads, buffer ^= 1) {
    const int edges = end - stage < group_threads ? end - stage : group_threads;
    if (t < edges) {
      const EdgeContributions<S> terms = edge_contributions(product, index_t{stage + t});
      const std::uint32_t slot_rank = groups.slot_rank[stage + t];
      const auto rank = static_cast<int>(slot_rank % group_threads);
      slot_of[buffer][t] = static_cast<int>(slot_rank >> EdgeGroups::rank_bits);
#pragma unroll
      for (int k = 0; k < 3; ++k) {
        to_m[buffer][k][t] = terms.to_m[k];
        to_n[buffer][k][rank] = terms.to_n[k];
      }
    }
    __syncthreads();
#pragma unroll
    for (int k = 0; k < nodes_of_thread; ++k) {
      const int first = from[k] > stage ? from[k] - stage : 0, last = to[k] - stage < edges ? to[k] - stage : edges;
      for (int e = first; e < last; ++e) {
        sum[k] += Vector3<S>(to_m[buffer][0][e], to_m[buffer][1][e], to_m[buffer][2][e]);
      }
    }
    if (t < edges && (t == 0 || slot_of[buffer][t - 1] != slot_of[buffer][t])) {
      const int slot = slot_of[buffer][t];
      Vector3<S> of_slot = sums.get(slot);
      for (int e = t; e < edges && slot_of[buffer][e] == slot; ++e) {
        of_slot += Vector3<S>(to_n[buffer][0][e], to_n[buffer][1][e], to_n[buffer][2][e]);
      }
      sums.set(slot, of_slot);
    }
  }
  __syncthreads();
#pragma unroll
  for (int k = 0; k < nodes_of_thread; ++k) {
    const int slot = t + k * group_threads;
    if (slot < own) product.differentials[index_t{first_node[0] + slot}].df() = Vector3<S>(sum[k] + sums.get(slot));
  }
  if constexpr (kHoldsAll) {
    for (int slot = own + t; slot < slots; slot += group_threads) {
      contributions[sums.place[slot - own]] = Contribution<S>(sums.get(slot));
    }
  }
}

/// Starts sum_groups() in `stream`.
template <bool kAdds, class Product>
void start_groups(const Product& product, const EdgeSums& sums, Stream stream) {
  using Scalar = typename Product::Scalar;
  // Of a block's shared memory, 1 KiB is the system's, and stages have some.
  constexpr int stage_bytes = group_threads * (12 * int{sizeof(Scalar)} + 8) + 1024;
  constexpr int slot_bytes = 3 * sizeof(Scalar), wanted_bytes = 96 * 1024;
  int device = 0, block_bytes = 0;
  cuda::check(cudaGetDevice(&device), "asking for the current device");
  cuda::check(cudaDeviceGetAttribute(&block_bytes, cudaDevAttrMaxSharedMemoryPerBlockOptin, device),
              "asking for its shared memory");
  const int most_bytes = block_bytes - stage_bytes < wanted_bytes ? block_bytes - stage_bytes : wanted_bytes;
  const EdgeGroups::View groups = sums.groups().view();
  const auto start = [&](auto* kernel, int room) {
    // The same for all products of this kernel, of which graphs may hold some.
    cuda::check(cudaFuncSetAttribute(kernel, cudaFuncAttributeMaxDynamicSharedMemorySize, most_bytes),
                "asking for shared memory");
    kernel<<<static_cast<unsigned>(groups.groups), group_threads, static_cast<std::size_t>(room) * slot_bytes,
             stream>>>(product, groups, room, sums.contributions<Scalar>());
    cuda::check(cudaGetLastError(), "launching the groups of a symmetric product");
  };
  if (groups.most_slots <= most_bytes / slot_bytes) {
    start(sum_groups<kAdds, true, Product>, groups.most_slots);
  } else {
    start(sum_groups<kAdds, false, Product>, EdgeGroups::most_nodes);
  }
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
  const EdgeGroups::View groups = sums.groups().view();
  if (groups.groups > 0) start_groups<kAdds>(product, sums, stream);
  parallel_for(space, sums.nodes(), AddContributions<Product>{product, groups.first_sum, sums.contributions<Scalar>()},
               stream);
}

}  // namespace detail

/// df = K dx, ordered in `stream`; does not wait. SumOrder::any adds with atomics, in an order that differs from run to
/// run; SumOrder::fixed stores sums of groups of nodes and gives the same bits on every run.
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
