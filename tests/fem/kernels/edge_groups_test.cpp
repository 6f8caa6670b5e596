// The lists of groups, followed as the kernel on CUDA follows them.
#include <fem/kernels/edge_groups.h>
#include <fem/mesh/mesh.h>
#include <fem/mesh/renumber.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {
namespace {

using Edges = std::vector<std::array<Index, 2>>;

std::vector<Index> first_edges(Index nodes, std::span<const std::array<Index, 2>> edges) {
  std::vector<Index> first;
  for (Index n = 0; n <= nodes; ++n) {
    const auto from = std::ranges::lower_bound(edges, std::array<Index, 2>{n, -1});
    first.push_back(static_cast<Index>(from - edges.begin()));
  }
  return first;
}

/// Per node: what its group gives to it, then what other groups do, each as the edges in the order in which they are
/// added.
using Sums = std::vector<std::vector<Edges>>;

Sums follow(const EdgeGroups& groups, Index nodes, std::span<const std::array<Index, 2>> edges) {
  const EdgeGroups::View view = groups.view();
  Sums own(static_cast<std::size_t>(nodes));
  std::map<Index, Edges> stored;
  for (Index g = 0; g < view.groups; ++g) {
    const Index begin = view.first_node[g], end = view.first_node[g + 1], outers = view.first_outer[g];
    const Index slots = end - begin + view.first_outer[g + 1] - outers;
    EXPECT_LE(slots, view.most_slots);
    std::vector<Edges> sums(static_cast<std::size_t>(slots));
    const Index from = view.first_edge[begin], to = view.first_edge[end];
    for (Index stage = from; stage < to; stage += EdgeGroups::stage_edges) {
      const Index last = std::min(to, stage + EdgeGroups::stage_edges);
      std::vector<Index> by_rank(static_cast<std::size_t>(last - stage), -1);
      for (Index e = stage; e < last; ++e) {
        Index& here = by_rank.at(view.slot_rank[e] % EdgeGroups::stage_edges);
        EXPECT_EQ(here, -1) << "two edges of one rank";
        here = e;
      }
      std::set<std::uint32_t> seen;
      for (Index r = 0; r < last - stage; ++r) {
        const std::uint32_t slot = view.slot_rank[stage + r] >> EdgeGroups::rank_bits;
        const bool goes_on = r > 0 && slot == view.slot_rank[stage + r - 1] >> EdgeGroups::rank_bits;
        EXPECT_TRUE(goes_on || seen.insert(slot).second) << "a slot that two threads would add to";
        sums.at(slot).push_back(edges[static_cast<std::size_t>(by_rank[static_cast<std::size_t>(r)])]);
      }
    }
    for (Index slot = 0; slot < slots; ++slot) {
      const Edges& sum = sums[static_cast<std::size_t>(slot)];
      if (slot < end - begin) {
        own[static_cast<std::size_t>(begin + slot)].push_back(sum);
      } else {
        EXPECT_TRUE(stored.emplace(view.place[outers + slot - (end - begin)], sum).second) << "a place of two sums";
      }
    }
  }
  EXPECT_EQ(static_cast<index_t>(stored.size()), groups.sums());
  for (Index n = 0; n < nodes; ++n) {
    for (Index k = view.first_sum[n]; k < view.first_sum[n + 1]; ++k) {
      own[static_cast<std::size_t>(n)].push_back(stored.at(k));
    }
  }
  return own;
}

TEST(EdgeGroups, add_each_edge_once_to_its_second_node_in_the_order_of_edges) {
  std::vector<TetMesh> meshes;
  meshes.push_back(make_tet_mesh(3, {}));
  meshes.push_back(make_box_mesh(17, 11, 13));
  meshes.push_back(renumbered(meshes.back(), random_numbering(meshes.back(), 5)));
  std::vector<std::array<Index, 4>> fan;
  for (Index n = 1; n + 2 < 2000; ++n) fan.push_back({0, n, n + 1, n + 2});
  meshes.push_back(make_tet_mesh(2000, fan));
  for (const TetMesh& mesh : meshes) {
    for (const Index each : {1, 64, 512}) {
      std::vector<Index> first_node;
      for (Index n = 0; n < mesh.nodes; n += each) first_node.push_back(n);
      first_node.push_back(mesh.nodes);
      const EdgeGroups groups(first_edges(mesh.nodes, mesh.edges), mesh.edges, first_node, SpaceKind::host);
      const Sums sums = follow(groups, mesh.nodes, mesh.edges);
      std::vector<Edges> expected(static_cast<std::size_t>(mesh.nodes));
      for (const auto& edge : mesh.edges) expected[static_cast<std::size_t>(edge[1])].push_back(edge);
      for (std::size_t n = 0; n < sums.size(); ++n) {
        Edges all;
        // What the node's own group gives is added before the sums of the others, all of lower numbers.
        for (std::size_t k = 1; k < sums[n].size(); ++k) all.insert(all.end(), sums[n][k].begin(), sums[n][k].end());
        all.insert(all.end(), sums[n][0].begin(), sums[n][0].end());
        EXPECT_EQ(all, expected[n]) << "node " << n << " of " << mesh.nodes << ", groups of " << each;
      }
    }
  }
}

TEST(EdgeGroups, of_a_part_give_its_own_nodes_the_sums_of_the_whole) {
  const TetMesh mesh = make_box_mesh(17, 11, 13);
  const Index each = nodes_of_group(mesh.nodes);
  const EdgeGroups whole(first_edges(mesh.nodes, mesh.edges), mesh.edges,
                         groups_of_part(0, mesh.nodes, mesh.nodes, std::identity()), SpaceKind::host);
  const Sums expected = follow(whole, mesh.nodes, mesh.edges);
  for (const auto& [begin, end] :
       {std::pair<Index, Index>{0, 5 * each}, {7 * each, 12 * each}, {9 * each, mesh.nodes}}) {
    // Its own nodes, and those at the other end of their edges; three local numbers below stand for none.
    std::set<Index> here;
    for (Index n = begin; n < end; ++n) here.insert(n);
    const auto is_own = [&](Index n) { return begin <= n && n < end; };
    for (const auto& [m, n] : mesh.edges) {
      if (is_own(m) || is_own(n)) here.insert({m, n});
    }
    constexpr Index none = 3;
    std::vector<Index> global(none, -1);
    global.insert(global.end(), here.begin(), here.end());
    std::map<Index, Index> local;
    for (std::size_t n = none; n < global.size(); ++n) local[global[n]] = static_cast<Index>(n);
    Edges edges;
    for (const auto& [m, n] : mesh.edges) {
      if (is_own(m) || is_own(n)) edges.push_back({local[m], local[n]});
    }
    const auto nodes = static_cast<Index>(global.size());
    const EdgeGroups part(first_edges(nodes, edges), edges,
                          groups_of_part(none, nodes, mesh.nodes,
                                         [&](index_t n) { return index_t{global[static_cast<std::size_t>(n)]}; }),
                          SpaceKind::host);
    Sums sums = follow(part, nodes, edges);
    for (Index n = begin; n < end; ++n) {
      auto& of_node = sums[static_cast<std::size_t>(local[n])];
      for (Edges& sum : of_node) {
        for (auto& edge : sum)
          edge = {global[static_cast<std::size_t>(edge[0])], global[static_cast<std::size_t>(edge[1])]};
      }
      EXPECT_EQ(of_node, expected[static_cast<std::size_t>(n)]) << "node " << n;
    }
  }
}

TEST(EdgeGroups, of_too_many_nodes_are_refused) {
  const TetMesh mesh = make_box_mesh(17, 11, 13);
  const std::vector<Index> first_node{0, 600, mesh.nodes};
  try {
    const EdgeGroups groups(first_edges(mesh.nodes, mesh.edges), mesh.edges, first_node, SpaceKind::host);
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(" on: a thread block has 512 at most"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace physgen::fem
