// What the lists of a hierarchy have in common: edges under their first nodes, patches of nodes, and sets of nodes. For
// hierarchy.cpp, level_graphs.cpp and coarse_terms.cpp.
#pragma once

#include <fem/mesh/at.h>
#include <fem/mesh/mesh.h>
#include <fem/mesh/stages.h>
#include <fem/solver/mesh_level.h>
#include <physgen/fill_rows.h>

#include <vector>

namespace physgen::fem::detail {

using physgen::detail::for_each_index;
using physgen::detail::RegionFailure;
using physgen::detail::sort_row;
using physgen::detail::Spares;

/// Made on several threads.
template <class T>
[[nodiscard]] HostList<T> copy_of(const HostList<T>& list) {
  HostList<T> copy(list.size());
  for_each_index(0, static_cast<index_t>(list.size()), [&](index_t k) { copy[at(k)] = list[at(k)]; });
  return copy;
}

/// Per node, the first of its edges to higher nodes; and one more. @param edges ascending
[[nodiscard]] inline HostList<Index> first_edges(Index nodes, std::span<const std::array<Index, 2>> edges) {
  const auto count = static_cast<index_t>(edges.size());
  HostList<Index> first(at(nodes) + 1);
  for_each_index(0, count + 1, [&](index_t e) {
    const Index from = e == 0 ? 0 : edges[at(e - 1)][0] + 1, to = e == count ? nodes : edges[at(e)][0];
    for (Index n = from; n <= to; ++n) first[at(n)] = static_cast<Index>(e);
  });
  return first;
}

/// A set of nodes higher than one, and a number for each. A thread that makes many has one of these.
class HigherNodes {
 public:
  explicit HigherNodes(Index nodes) : owner_(at(nodes), -1), number_(at(nodes)) {}

  /// Makes it the empty set of a node; of each node once.
  void begin(Index node) {
    node_ = node;
    nodes_.clear();
  }
  /// Adds a node, if it is higher and not in the set. @return its number; of what it adds 0
  Index& add(Index other) {
    Index& number = number_[at(other)];
    if (other > node_ && owner_[at(other)] != node_) {
      owner_[at(other)] = node_;
      number = 0;
      nodes_.push_back(other);
    }
    return number;
  }
  [[nodiscard]] Index& number(Index other) { return number_[at(other)]; }
  /// Ascending from here on.
  [[nodiscard]] const std::vector<Index>& sorted() {
    sort_row(nodes_.data(), nodes_.data() + nodes_.size());
    return nodes_;
  }

 private:
  Index node_ = -1;
  std::vector<Index> owner_, number_, nodes_;
};

/// Calls act(node, scratch) for each node, each thread with a scratch of its own that make() makes.
template <class Make, class Act>
void each_node(Index nodes, const Make& make, const Act& act) {
  constexpr index_t block = 256;
  Spares<decltype(make())> spares;
  RegionFailure failure;
  for_each_index<16 * block>(0, (nodes + block - 1) / block, [&](index_t b) {
    failure.guard([&] {
      spares.lend(make, [&](auto& scratch) {
        const auto end = static_cast<Index>(std::min(index_t{nodes}, (b + 1) * block));
        for (auto n = static_cast<Index>(b * block); n < end; ++n) act(n, scratch);
      });
    });
  });
  failure.rethrow();
}

/// Per node: patch, slot.
[[nodiscard]] inline IncidenceList patches_of_nodes(const MeshLevel& level) {
  InStage stage("rows of patches");
  const VolumePatches& patches = level.patches;
  IncidenceList list;
  fill_rows(
      Host{}, level.mesh.nodes, static_cast<index_t>(patches.nodes.size()),
      [&patches](index_t p, const auto& put) {
        for (Index slot = 0; slot < patches.node_counts[at(p)]; ++slot) {
          put(patches.nodes[at(p)][at(slot)], IncidenceEntry{static_cast<Index>(p), slot});
        }
      },
      list.first, list.entries);
  stage.moves(patches.nodes, list.first, list.entries);
  return list;
}

}  // namespace physgen::fem::detail
