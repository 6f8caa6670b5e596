#include <fem/kernels/edge_groups.h>
#include <fem/mesh/at.h>
#include <physgen/detail/host_loop.h>
#include <physgen/error.h>
#include <physgen/fill_rows.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace physgen::fem {

namespace {

/// What a group needs while its lists are made.
struct Terms {
  std::vector<std::uint64_t> by_node;  ///< the group's edges: n, and which edge, ascending
  std::vector<Index> of_stage;         ///< how many of each stage have been listed
};

}  // namespace

EdgeGroups::EdgeGroups(std::span<const Index> first_edge, std::span<const std::array<Index, 2>> edges,
                       std::span<const Index> first_node, SpaceKind space)
    : nodes_(static_cast<Index>(first_edge.size()) - 1),
      groups_(static_cast<Index>(first_node.size()) - 1),
      edges_(static_cast<index_t>(edges.size())) {
  HostList<std::uint32_t> slot_rank(edges.size());
  HostList<Index> found(edges.size()), first_outer(at(groups_) + 1);
  first_outer[0] = 0;
  constexpr std::uint32_t most_slots = ~std::uint32_t{0} >> rank_bits;
  physgen::detail::host_loop(groups_, [&](index_t g) {
    static thread_local Terms terms;
    const Index begin = first_node[at(g)], end = first_node[at(g) + 1];
    const Index from = first_edge[at(begin)], to = first_edge[at(end)];
    if (end - begin > most_nodes) {
      throw Error("a group of " + std::to_string(end - begin) + " nodes from node " + std::to_string(begin) +
                  " on: a thread block has " + std::to_string(most_nodes) + " at most");
    }
    terms.by_node.clear();
    terms.of_stage.assign(at((to - from) / stage_edges + 1), 0);
    for (Index e = from; e < to; ++e) {
      terms.by_node.push_back(std::uint64_t(edges[at(e)][1]) << 32 | static_cast<std::uint32_t>(e - from));
    }
    std::ranges::sort(terms.by_node);
    Index outers = 0;
    for (const std::uint64_t term : terms.by_node) {
      const auto n = static_cast<Index>(term >> 32), e = static_cast<Index>(term & 0xffffffffU);
      if (n >= end && (outers == 0 || found[at(from + outers - 1)] != n)) found[at(from + outers++)] = n;
      const auto slot = static_cast<std::uint32_t>(n < end ? n - begin : end - begin + outers - 1);
      if (slot > most_slots) {
        throw Error("the " + std::to_string(end - begin) + " nodes from node " + std::to_string(begin) +
                    " on have edges to more than " + std::to_string(most_slots) + " nodes; number the mesh anew");
      }
      const Index rank = terms.of_stage[at(e / stage_edges)]++;
      constexpr std::uint32_t ranks = stage_edges - 1;
      std::uint32_t& of_rank = slot_rank[at(from + e / stage_edges * stage_edges + rank)];
      of_rank = slot << rank_bits | (of_rank & ranks);
      std::uint32_t& of_edge = slot_rank[at(from + e)];
      of_edge = (of_edge & ~ranks) | static_cast<std::uint32_t>(rank);
    }
    first_outer[at(g) + 1] = outers;
  });
  for (std::size_t g = 0; g < at(groups_); ++g) {
    most_slots_ = std::max(most_slots_, first_node[g + 1] - first_node[g] + first_outer[g + 1]);
    first_outer[g + 1] += first_outer[g];
  }
  sums_ = first_outer.back();
  HostList<Index> outer(at(sums_)), first_sum, by_node;
  physgen::detail::for_each_index(0, groups_, [&](index_t g) {
    std::copy_n(found.begin() + first_edge[at(first_node[at(g)])], first_outer[at(g) + 1] - first_outer[at(g)],
                outer.begin() + first_outer[at(g)]);
  });
  fill_rows(
      Host{}, nodes_, sums_, [&](index_t k, const auto& put) { put(outer[at(k)], static_cast<Index>(k)); }, first_sum,
      by_node);

  const index_t count = 2 * (index_t{groups_} + 1) + 2 * (index_t{nodes_} + 1) + sums_ + edges_;
  lists_ = Buffer(space, count * index_t{sizeof(Index)}, "lists of groups of " + std::to_string(edges_) + " edges");
  HostList<Index> all(at(count));
  auto next = std::ranges::copy(first_node, all.begin()).out;
  next = std::ranges::copy(first_outer, next).out;
  next = std::ranges::copy(first_edge, next).out;
  next = std::ranges::copy(first_sum, next).out;
  physgen::detail::for_each_index(0, sums_, [&](index_t k) { next[by_node[at(k)]] = static_cast<Index>(k); });
  next += sums_;
  std::ranges::transform(slot_rank, next, [](std::uint32_t word) { return static_cast<Index>(word); });
  copy_memory(lists_.data(), space, reinterpret_cast<const std::byte*>(all.data()), SpaceKind::host, lists_.bytes());
}

EdgeGroups::View EdgeGroups::view() const {
  View view;
  view.groups = groups_;
  view.most_slots = most_slots_;
  const auto* next = reinterpret_cast<const Index*>(lists_.data());
  if (next == nullptr) return view;
  const auto take = [&](index_t count) { return std::exchange(next, next + count); };
  view.first_node = take(index_t{groups_} + 1);
  view.first_outer = take(index_t{groups_} + 1);
  view.first_edge = take(index_t{nodes_} + 1);
  view.first_sum = take(index_t{nodes_} + 1);
  view.place = take(sums_);
  view.slot_rank = reinterpret_cast<const std::uint32_t*>(next);
  return view;
}

}  // namespace physgen::fem
