// The lists that the symmetric product goes by.
#include <fem/kernels/symmetric_product.h>
#include <physgen/detail/first_index.h>
#include <physgen/error.h>
#include <physgen/fill_rows.h>

#include <functional>
#include <string>
#include <vector>

namespace physgen::fem {

namespace {

std::size_t at(index_t i) { return static_cast<std::size_t>(i); }

/// @throw Error naming the first edge that is not above the one before it, or not one of nodes m < n
void check_edges(Index nodes, std::span<const std::array<Index, 2>> edges, index_t first_edge) {
  const auto is_sound = [=](index_t e) {
    const auto [m, n] = edges[at(e)];
    return e < first_edge || (m >= 0 && m < n && n < nodes && (e == first_edge || edges[at(e - 1)] < edges[at(e)]));
  };
  const auto count = static_cast<index_t>(edges.size());
  const index_t first = physgen::detail::first_index(count, [&](index_t e) { return !is_sound(e); });
  if (first == count) return;
  const std::string which = "edge " + std::to_string(first) + " of the mesh is ";
  if (first > first_edge && edges[at(first - 1)] >= edges[at(first)]) {
    throw Error(which + "not above the one before it; edges (m, n) must be ascending, as make_tet_mesh() makes them");
  }
  throw Error(which + "(" + std::to_string(edges[at(first)][0]) + ", " + std::to_string(edges[at(first)][1]) +
              "); edges (m, n) must have 0 <= m < n < " + std::to_string(nodes) + ", as make_tet_mesh() makes them");
}

}  // namespace

EdgeSums::EdgeSums(Index nodes, std::span<const std::array<Index, 2>> edges, SpaceKind space, int real_bytes,
                   SumOrder order, index_t first_edge, std::span<const Index> groups)
    : nodes_(nodes), edges_(static_cast<index_t>(edges.size())), space_(space), real_bytes_(real_bytes), order_(order) {
  check_edges(nodes, edges, first_edge);
  const bool is_on_host = space == SpaceKind::host;
  if (order == SumOrder::any && !is_on_host) return;  // atomics go by no lists
  const auto contributions = [&](index_t count, const char* of) {
    return Buffer(space, 4 * count * real_bytes, of + std::to_string(edges_) + " edges");
  };
  HostList<Index> elsewhere(is_on_host ? 0 : at(nodes_ + 1));
  if (is_on_host) {
    indices_ = Buffer(space, (2 * (nodes_ + 1) + edges_) * index_t{sizeof(Index)},
                      "lists of " + std::to_string(edges_) + " edges");
    contributions_ = contributions(edges_, "contributions of ");
  }
  Index* const first = is_on_host ? reinterpret_cast<Index*>(indices_.data()) : elsewhere.data();
  physgen::detail::for_each_index(first_edge, edges_ + 1, [=](index_t e) {
    const Index from = e == first_edge ? 0 : edges[at(e - 1)][0] + 1;
    const Index to = at(e) == edges.size() ? nodes : edges[at(e)][0];
    for (Index n = from; n <= to; ++n) first[n] = static_cast<Index>(e);
  });
  if (!is_on_host) {
    const auto own = groups.empty() ? groups_of_part(0, nodes, nodes, std::identity()) : std::vector<Index>();
    groups_ = EdgeGroups(elsewhere, edges, groups.empty() ? own : groups, space);
    contributions_ = contributions(groups_.sums(), "sums of groups of ");
    return;
  }
  // Edges ascend, so those of a first node lie side by side; those of a second node are its contributions, ascending.
  Index* const place = first + 2 * (nodes_ + 1);
  HostList<Index> begin, by_second;
  fill_rows(
      Host{}, nodes_, edges_,
      [=](index_t e, const auto& put) {
        if (e >= first_edge) put(edges[at(e)][1], static_cast<Index>(e));
      },
      begin, by_second);
  physgen::detail::for_each_index(0, nodes_ + 1, [&](index_t n) { first[nodes_ + 1 + n] = begin[at(n)]; });
  physgen::detail::for_each_index(0, edges_ - first_edge,
                                  [&](index_t k) { place[by_second[at(k)]] = static_cast<Index>(k); });
}

void EdgeSums::require(index_t nodes, index_t edges, SpaceKind space, int real_bytes, SumOrder order) const {
  if (order == SumOrder::fixed && order_ == SumOrder::any && space == SpaceKind::cuda) {
    throw Error(
        "a product in SumOrder::fixed was given sums made for SumOrder::any, which have no room for those of groups");
  }
  if (nodes == nodes_ && edges == edges_ && space == space_ && real_bytes == real_bytes_) return;
  const auto describe = [](index_t n, index_t e, SpaceKind s, int bytes) {
    return std::to_string(n) + " nodes and " + std::to_string(e) + " edges in " + name(s) + " memory, numbers of " +
           std::to_string(bytes) + " bytes";
  };
  throw Error("a product over " + describe(nodes, edges, space, real_bytes) + " was given sums made for " +
              describe(nodes_, edges_, space_, real_bytes_) + "; make an EdgeSums for it");
}

void detail::require_size(const char* array, index_t size, index_t expected) {
  if (size == expected) return;
  throw Error("a symmetric product over " + std::to_string(expected) + " objects was given " + array + " of " +
              std::to_string(size) + "; resize that array");
}

}  // namespace physgen::fem
