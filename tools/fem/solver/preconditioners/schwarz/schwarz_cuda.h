// Blocks of the Schwarz preconditioner on CUDA: a thread block forms the factor of one in shared memory, and a warp
// applies it, a lane for each slot. For CUDA translation units.
#pragma once

#include <fem/solver/performs_in.h>
#include <fem/solver/preconditioners/schwarz/schwarz.h>
#include <physgen/cuda/executor.h>

namespace physgen::fem {

namespace detail {

inline constexpr int factor_threads = 256;

/// As FactorBlock on the CPU: one thread block for each.
template <class Stiffness, class Edges, class SlotView, class BlockView, class FactorView>
__global__ void __launch_bounds__(factor_threads) factor_schwarz(index_t first, Stiffness stiffness, Edges edges,
                                                                 SlotView slots, BlockView blocks, FactorView factors) {
  using Real = typename Stiffness::Scalar;
  constexpr int size = schwarz_size, threads = factor_threads, warps = threads / 32;
  extern __shared__ unsigned char memory[];
  Real* matrix = reinterpret_cast<Real*>(memory);
  Real* roots = matrix + size * size;
  Real* least = roots + size;
  const index_t block = first + blockIdx.x;
  const int thread = static_cast<int>(threadIdx.x), lane = thread % 32, warp = thread / 32;
  const auto at = [&](int r, int c) -> Real& { return matrix[r * size + c]; };
  const auto put = [&](int i, int j, const Matrix3<Real>& K) {
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r) at(3 * i + r, 3 * j + c) = -K(r, c);
    }
  };
  for (int with_edges = 1; with_edges >= 0; --with_edges) {
    for (int k = thread; k < size * size; k += threads) matrix[k] = Real(0);
    __syncthreads();
    if (thread < schwarz_slots) {
      const index_t source = slots[schwarz_slots * block + thread].source();
      Vector3<Real> magnitude = Vector3<Real>::Zero();
      if (source >= 0) {
        put(thread, thread, stiffness.node(source));
        magnitude = stiffness.magnitude(source);
      }
      for (int c = 0; c < 3; ++c) least[3 * thread + c] = least_pivot<Real>(magnitude[c]);
    }
    if (with_edges != 0) {
      const auto range = edges.ranges()[block];
      const index_t begin = range.begin(), end = range.end();
      for (index_t k = begin + thread; k < end; k += threads) {
        const auto pair = edges.entries()[k];
        const int places = pair.places(), m = places % schwarz_slots, n = places / schwarz_slots;
        const Matrix3<Real> E = stiffness.edge(pair.edge());
        put(m, n, E);
        put(n, m, E.transpose());
      }
    }
    __syncthreads();
    bool failed = false;  // all threads alike
    for (int p = 0; p < size; ++p) {
      const Real pivot = at(p, p), bound = least[p];
      const bool kept = bound >= Real(0) && pivot > bound;
      failed = !kept && bound >= Real(0) && with_edges != 0;
      if (failed) break;
      if (thread == 0) roots[p] = kept ? Real(1) / sqrt(pivot) : Real(0);
      const Real inverse = kept ? Real(1) / pivot : Real(0);
      for (int r = p + 1 + warp; r < size; r += warps) {
        const Real factor = at(r, p) * inverse;
        __syncwarp();
        if (factor == Real(0)) {
          if (lane == 0) at(r, p) = Real(0);
          continue;
        }
        for (int c = lane; c < size; c += 32) {
          Real& entry = at(r, c);
          entry = c == p ? -factor : fma(-factor, at(p, c), entry);
        }
      }
      __syncthreads();
    }
    if (!failed) break;
    __syncthreads();  // the matrix is read no more
  }
  Real largest(0);
  for (int k = 0; k < size; k += 32) largest = math::max(largest, roots[k + lane]);
  for (int distance = 16; distance > 0; distance /= 2) {
    largest = math::max(largest, __shfl_xor_sync(0xffffffffU, largest, distance));
  }
  const Real scale = factor_scale<Real>(largest);
  if (thread == 0) blocks[block].scale() = scale;
  for (int k = thread; k < schwarz_factors; k += threads) {
    factors[schwarz_factors * block + k].W() =
        factor_block<Real>(k / schwarz_slots, k % schwarz_slots, roots, scale, at);
  }
}

/// A lane's vector from another lane.
template <class S>
__device__ inline Vector3<S> of_lane(const Vector3<S>& v, int lane) {
  constexpr unsigned all = 0xffffffffU;
  return {__shfl_sync(all, v[0], lane), __shfl_sync(all, v[1], lane), __shfl_sync(all, v[2], lane)};
}

/// W^T W r of one block. Of diagonal d, lane i has the 3x3 block of slots i and (i + d) % 32: the later of the two is
/// its row. What a lane forms for another one is handed over within the warp.
/// @param factor (d) this lane's block of diagonal d
template <class S, class Factor>
__device__ inline Vector3<S> apply_factor(const Factor& factor, int lane, const Vector3<S>& r) {
  constexpr int unrolled = sizeof(S) == 4 ? 16 : 1;  // what is kept in registers needs constant numbers
  const Vector3<S> zero = Vector3<S>::Zero();
  Vector3<S> y = multiply_add<S>(factor(0), r, zero);
#pragma unroll(unrolled)
  for (int d = 1; d <= 16; ++d) {
    const bool is_column = lane + d < 32, takes = lane >= d;
    const Vector3<S> other = of_lane(r, (lane + d) % 32);
    Vector3<S> v;
    for (int k = 0; k < 3; ++k) v[k] = is_column ? r[k] : other[k];
    const Vector3<S> product = multiply_add<S>(factor(d), v, zero);
    const Vector3<S> taken = of_lane(product, (lane + 32 - d) % 32);
    for (int k = 0; k < 3; ++k) y[k] += (is_column ? S(0) : product[k]) + (takes ? taken[k] : S(0));
  }
  Vector3<S> z = multiply_add<S>(Matrix3<S>(factor(0).transpose()), y, zero);
#pragma unroll(unrolled)
  for (int d = 1; d <= 16; ++d) {
    const bool is_column = lane + d < 32, takes = lane < d;
    const Vector3<S> other = of_lane(y, (lane + d) % 32);
    Vector3<S> v;
    for (int k = 0; k < 3; ++k) v[k] = is_column ? other[k] : y[k];
    const Vector3<S> product = multiply_add<S>(Matrix3<S>(factor(d).transpose()), v, zero);
    const Vector3<S> taken = of_lane(product, (lane + 32 - d) % 32);
    for (int k = 0; k < 3; ++k) z[k] += (is_column ? product[k] : S(0)) + (takes ? taken[k] : S(0));
  }
  return z;
}

/// Sums r over the slots of each supernode, which lie side by side, and hands the sums to the next level.
/// @return whether this warp was the last that the parent block waited for
template <class Product, class S>
__device__ inline bool hand_over(const Product& product, index_t block, int lane, int parent, Vector3<S> r) {
  constexpr unsigned all = 0xffffffffU;
  const int above = product.blocks[block].parent();
  if (above < 0) return false;
#pragma unroll
  for (int distance = 1; distance < 32; distance *= 2) {
    const int other = __shfl_down_sync(all, parent, distance);
    const bool same = lane + distance < 32 && other == parent;
    for (int k = 0; k < 3; ++k) {
      const S value = __shfl_down_sync(all, r[k], distance);
      r[k] += same ? value : S(0);
    }
  }
  const int before = __shfl_up_sync(all, parent, 1);
  if (parent >= 0 && (lane == 0 || before != parent)) product.supernode_residual[parent].df() = r;
  __threadfence();
  __syncwarp();
  int is_last = 0;
  if (lane == 0) {
    const auto waiting = product.blocks[above];
    const int children = waiting.children();
    if (atomicAdd(&waiting.arrived(), 1) + 1 == children) {
      waiting.arrived() = 0;  // for the next application
      is_last = 1;
    }
  }
  is_last = __shfl_sync(all, is_last, 0);
  __threadfence();
  return is_last != 0;
}

/// A warp takes a block of nodes. The last of the warps whose blocks have a parent goes on with that one: so all levels
/// are one launch, and each sum has a fixed order.
template <class Product>
__global__ void __launch_bounds__(128) apply_schwarz_blocks(const Product product) {
  using S = typename Product::Scalar;
  const int lane = static_cast<int>(threadIdx.x % 32);
  index_t block = (blockIdx.x * index_t{blockDim.x} + threadIdx.x) / 32;
  if (block >= product.node_blocks) return;
  for (bool of_nodes = true;; of_nodes = false) {
    const auto slot = product.slots[schwarz_slots * block + lane];
    const index_t source = slot.source();
    const int parent = slot.parent();
    Vector3<S> r = Vector3<S>::Zero();
    if (source >= 0) {
      if (of_nodes) {
        r = product.residual[source].df();
      } else {  // not from this processor's cache
        const auto df = product.supernode_residual[source].df();
        r = {__ldcg(&df[0]), __ldcg(&df[1]), __ldcg(&df[2])};
      }
    }
    const auto load = [&](int d) -> Matrix3<S> {
      return product.factors[schwarz_factors * block + schwarz_slots * d + lane].W();
    };
    const S scale = product.blocks[block].scale();
    const Vector3<S> scaled = r * scale;
    Vector3<S> z;
    if constexpr (sizeof(S) == 4) {  // the factor is read once, all of it at a time
      Matrix3<S> kept[17];
#pragma unroll
      for (int d = 0; d <= 16; ++d) kept[d] = load(d);
      z = apply_factor<S>([&](int d) -> const Matrix3<S>& { return kept[d]; }, lane, scaled);
    } else {
      z = apply_factor<S>(load, lane, scaled);
    }
    z *= scale;
    if (source >= 0) {
      if (of_nodes) {
        product.corrections[source].dx() = z;
      } else {
        product.supernode_corrections[source].dx() = z;
      }
    }
    if (!hand_over(product, block, lane, parent, r)) return;
    block = product.blocks[block].parent();
  }
}

}  // namespace detail

/// Makes the factors of the blocks begin .. end-1, from the stiffness of what stands in them.
template <PerformsIn<Cuda> On, class Stiffness, class Arrays>
void factor_blocks(On& on, index_t begin, index_t end, const Stiffness& stiffness, Arrays& arrays) {
  using Real = typename Arrays::Real;
  if (begin == end) return;
  constexpr int bytes = (detail::schwarz_size + 2) * detail::schwarz_size * static_cast<int>(sizeof(Real));
  const auto edges = arrays.block_edges.const_view();
  const auto slots = arrays.slots.const_view();
  const auto blocks = arrays.blocks.view();
  const auto factors = arrays.factors.view();
  on.perform([&](Stream stream) {
    const auto kernel =
        detail::factor_schwarz<Stiffness, std::remove_const_t<decltype(edges)>, std::remove_const_t<decltype(slots)>,
                               std::remove_const_t<decltype(blocks)>, std::remove_const_t<decltype(factors)>>;
    cuda::check(cudaFuncSetAttribute(kernel, cudaFuncAttributeMaxDynamicSharedMemorySize, bytes),
                "asking for the shared memory of a Schwarz block");
    kernel<<<static_cast<unsigned>(end - begin), detail::factor_threads, bytes, stream>>>(begin, stiffness, edges,
                                                                                          slots, blocks, factors);
    cuda::check(cudaGetLastError(), "factoring Schwarz blocks");
  });
}

/// z of all blocks.
template <PerformsIn<Cuda> On, class... Views>
void apply_blocks(On& on, const SchwarzProduct<Views...>& product, const std::vector<Index>& /*first_block*/) {
  if (product.node_blocks == 0) return;
  constexpr int threads = 128;
  const index_t warps = threads / 32, blocks = (product.node_blocks + warps - 1) / warps;
  on.perform([&](Stream stream) {
    detail::apply_schwarz_blocks<<<static_cast<unsigned>(blocks), threads, 0, stream>>>(product);
    cuda::check(cudaGetLastError(), "applying Schwarz blocks");
  });
}

}  // namespace physgen::fem
