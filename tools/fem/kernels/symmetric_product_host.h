// The symmetric product on the CPU: see symmetric_product.h.
#pragma once

#include <fem/kernels/symmetric_product.h>
#include <physgen/parallel_for.h>

#include <algorithm>
#include <array>
#include <vector>

namespace physgen::fem {

namespace detail {

/// df = K dx; or, where it adds, df += what the edges have of K dx.
template <bool kAdds, class... Views>
void sum_edges(const SymmetricProduct<Views...>& product, const EdgeSums& sums) {
  using Product = SymmetricProduct<Views...>;
  using Scalar = typename Product::Scalar;
  detail::require_sizes(product, sums, SpaceKind::host, SumOrder::fixed);
  constexpr int W = native_lanes<Scalar>;
  constexpr index_t block = 512;  // nodes; their contributions stay in the cache
  const Index* first = sums.first();
  const Index* place = sums.place();
  auto* contributions = sums.contributions<Scalar>();
  const index_t nodes = sums.nodes(), blocks = (nodes + block - 1) / block;
  physgen::detail::RegionFailure failure;
  physgen::detail::for_parts<block>(blocks, [&](index_t part_begin, index_t part_end) {
    std::vector<std::array<Scalar, 3>> own;  // contributions to m of the block's edges
    for (index_t b = part_begin; b < part_end; ++b) {
      failure.guard([&] {
        const index_t node_begin = b * block, node_end = std::min(nodes, node_begin + block);
        const index_t begin = first[node_begin], end = first[node_end];
        own.resize(static_cast<std::size_t>(end - begin));
        for (index_t p = begin / W * W; p < end; p += W) {  // packs at the ends also see edges of the neighbours
          const auto pack = p + W <= sums.edges()
                                ? detail::edge_contributions(product, Pack<W>{p})
                                : detail::edge_contributions(product, partial_pack<W>(p, 0, sums.edges()));
          alignas(64) std::array<std::array<Scalar, W>, 6> lanes;
          for (std::size_t k = 0; k < 3; ++k) {
            pack.to_m[static_cast<int>(k)].store_aligned(lanes[k].data());
            pack.to_n[static_cast<int>(k)].store_aligned(lanes[3 + k].data());
          }
          for (index_t e = std::max(p, begin); e < std::min(p + W, end); ++e) {
            const auto l = static_cast<std::size_t>(e - p);
            own[static_cast<std::size_t>(e - begin)] = {lanes[0][l], lanes[1][l], lanes[2][l]};
            contributions[place[e]] = Contribution<Scalar>({lanes[3][l], lanes[4][l], lanes[5][l]});
          }
        }
        for (index_t node = node_begin; node < node_end; ++node) {
          Vector3<Scalar> sum;
          if constexpr (kAdds) {
            sum = product.differentials[node].df();
          } else {
            sum = detail::node_contribution(product, node);
          }
          for (index_t e = first[node]; e < first[node + 1]; ++e) {
            const auto& to_m = own[static_cast<std::size_t>(e - begin)];
            sum += Vector3<Scalar>(to_m[0], to_m[1], to_m[2]);
          }
          product.differentials[node].df() = sum;
        }
      });
    }
  });
  physgen::detail::for_each_index(0, nodes, [&](index_t node) {
    failure.guard([&] { detail::add_contributions(product, node, sums.contributions_begin(), contributions); });
  });
  failure.rethrow();
}

}  // namespace detail

/// df = K dx. Both orders of sums are the fixed one here, and independent of the number of threads: atomics are what a
/// CPU is slow at.
/// @throw Error when arrays of the product differ in size, or `sums` was made for other sizes, or not for host memory
/// and this precision
template <class... Views>
void multiply(Host /*space*/, const SymmetricProduct<Views...>& product, const EdgeSums& sums, SumOrder /*order*/) {
  detail::sum_edges<false>(product, sums);
}

/// df += what the edges have of K dx: all of it but the diagonal blocks, for kernels that form that part themselves. As
/// multiply() otherwise.
template <class... Views>
void add_edges(Host /*space*/, const SymmetricProduct<Views...>& product, const EdgeSums& sums, SumOrder /*order*/) {
  detail::sum_edges<true>(product, sums);
}

}  // namespace physgen::fem
