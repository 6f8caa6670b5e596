// Lists node by node: the edges of a node to higher ones, and their tets, are found among its tets. Every list is
// ascending, so results depend neither on the order of construction nor on threads.
#include <fem/mesh/at.h>
#include <fem/mesh/mesh.h>
#include <fem/mesh/stages.h>
#include <physgen/detail/first_index.h>
#include <physgen/error.h>
#include <physgen/fill_rows.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace physgen::fem {

namespace {

using Tets = std::vector<std::array<Index, 4>>;

void check_entries(std::size_t objects, std::size_t each, const char* what) {
  if (objects > static_cast<std::size_t>(std::numeric_limits<Index>::max()) / each) {
    throw Error("mesh: incidences of " + std::to_string(objects) + " " + what + " do not fit a 32-bit index");
  }
}

void check_corners(Index nodes, const Tets& tets) {
  InStage stage("checks of tets");
  stage.moves(tets);
  const auto is_sound = [&](const std::array<Index, 4>& tet) {
    const auto [low, high] = std::ranges::minmax(tet);
    return low >= 0 && high < nodes && tet[0] != tet[1] && tet[0] != tet[2] && tet[0] != tet[3] && tet[1] != tet[2] &&
           tet[1] != tet[3] && tet[2] != tet[3];
  };
  const auto count = static_cast<index_t>(tets.size());
  const index_t lowest = physgen::detail::first_index(count, [&](index_t t) { return !is_sound(tets[at(t)]); });
  if (lowest == count) return;
  const std::string which = "mesh: tet " + std::to_string(lowest);
  const auto [low, high] = std::ranges::minmax(tets[at(lowest)]);
  if (low < 0 || high >= nodes) throw Error(which + " names a node outside 0 .. " + std::to_string(nodes - 1));
  throw Error(which + " names a node twice");
}

// The edges of one node to higher nodes, ascending, and how many tets have each. A thread has one of these.
class EdgesOfNode {
 public:
  explicit EdgesOfNode(Index nodes) : slot_(at(nodes), none) {}

  struct Edge {
    Index other, tets;
  };

  // Calls use(other, tet, local) for each edge of each tet of the node to a higher one, tets ascending.
  template <class Use>
  static void each_use(Index node, const Tets& tets, const IncidenceList& node_tets, const Use& use) {
    constexpr std::array<std::array<Index, 4>, 4> edge_of_corners{
        {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}}};
    for (Index k = node_tets.first[at(node)]; k < node_tets.first[at(node) + 1]; ++k) {
      const auto [tet, corner] = node_tets.entries[at(k)];
      const std::array<Index, 4>& corners = tets[at(tet)];
      for (Index c = 0; c < 4; ++c) {
        if (corners[at(c)] <= node) continue;
        use(corners[at(c)], tet, edge_of_corners[at(corner)][at(c)] + (corner > c ? 6 : 0));
      }
    }
  }

  const std::vector<Edge>& find(Index node, const Tets& tets, const IncidenceList& node_tets) {
    for (const Edge& edge : edges_) slot_[at(edge.other)] = none;
    edges_.clear();
    each_use(node, tets, node_tets, [this](Index other, Index /*tet*/, Index /*local*/) {
      Index& slot = slot_[at(other)];
      if (slot == none) {
        slot = static_cast<Index>(edges_.size());
        edges_.push_back({other, 0});
      }
      ++edges_[at(slot)].tets;
    });
    return edges_;
  }

  // Those that find() has found: writes their ends, where their tets end, and these.
  void put(Index node, const Tets& tets, const IncidenceList& node_tets, Index begin, std::array<Index, 2>* ends,
           Index* last, IncidenceEntry* entries) {
    std::ranges::sort(edges_, {}, &Edge::other);
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const Edge& edge = edges_[k];
      ends[k] = {node, edge.other};
      slot_[at(edge.other)] = begin;
      begin += edge.tets;
      last[k] = begin;
    }
    each_use(node, tets, node_tets,
             [this, entries](Index other, Index tet, Index local) { entries[slot_[at(other)]++] = {tet, local}; });
  }

 private:
  static constexpr Index none = -1;

  std::vector<Index> slot_;  // per node: its place in edges_; from put() on the next place among the entries
  std::vector<Edge> edges_;
};

// mesh.node_tets of mesh.tets.
void find_rows_of_tets(TetMesh& mesh) {
  InStage stage("rows of tets");
  fill_rows(
      Host{}, mesh.nodes, static_cast<index_t>(mesh.tets.size()),
      [&mesh](index_t t, const auto& put) {
        for (Index c = 0; c < 4; ++c) put(mesh.tets[at(t)][at(c)], IncidenceEntry{static_cast<Index>(t), c});
      },
      mesh.node_tets.first, mesh.node_tets.entries);
  stage.moves(mesh.tets, mesh.node_tets.first, mesh.node_tets.entries);
}

// mesh.edges and mesh.edge_tets of mesh.tets and mesh.node_tets.
void find_edges(TetMesh& mesh) {
  InStage stage("edges and their tets");
  constexpr index_t block = 256;
  const index_t nodes = mesh.nodes, blocks = (nodes + block - 1) / block;
  HostList<Index> edges(at(nodes) + 1), uses(at(nodes) + 1);  // of each node; then where those of each begin
  physgen::detail::Spares<EdgesOfNode> spares;
  const auto each_node = [&](const auto& act) {
    physgen::detail::RegionFailure failure;
    physgen::detail::for_each_index<16 * block>(0, blocks, [&](index_t b) {
      failure.guard([&] {
        spares.lend([&] { return EdgesOfNode(mesh.nodes); },
                    [&](EdgesOfNode& own) {
                      const auto end = static_cast<Index>(std::min(nodes, (b + 1) * block));
                      for (auto n = static_cast<Index>(b * block); n < end; ++n) {
                        act(n, own, own.find(n, mesh.tets, mesh.node_tets));
                      }
                    });
      });
    });
    failure.rethrow();
  };
  each_node([&](Index n, EdgesOfNode& /*own*/, const std::vector<EdgesOfNode::Edge>& found) {
    edges[at(n)] = static_cast<Index>(found.size());
    uses[at(n)] = 0;
    for (const auto& edge : found) uses[at(n)] += edge.tets;
  });
  edges.back() = uses.back() = 0;
  const index_t count = exclusive_scan(Host{}, std::span(edges));
  mesh.edge_tets.entries.resize(at(exclusive_scan(Host{}, std::span(uses))));
  mesh.edges.resize(at(count));
  mesh.edge_tets.first.resize(at(count) + 1);
  mesh.edge_tets.first[0] = 0;
  each_node([&](Index n, EdgesOfNode& own, const std::vector<EdgesOfNode::Edge>& /*found*/) {
    const std::size_t first = at(edges[at(n)]);
    own.put(n, mesh.tets, mesh.node_tets, uses[at(n)], mesh.edges.data() + first,
            mesh.edge_tets.first.data() + first + 1, mesh.edge_tets.entries.data());
  });
  stage.moves(mesh.tets, mesh.node_tets.first, mesh.node_tets.entries, mesh.edges, mesh.edge_tets.first,
              mesh.edge_tets.entries);
}

}  // namespace

IncidenceList edges_of_nodes(Index nodes, std::span<const std::array<Index, 2>> edges) {
  InStage stage("rows of edges");
  check_entries(edges.size(), 2, "edges");
  const auto count = static_cast<index_t>(edges.size());
  HostList<Index> first_higher(at(nodes) + 1), first_lower, lower;  // of the edges to higher nodes, and to lower ones
  physgen::detail::for_each_index(0, count + 1, [&](index_t e) {
    const Index from = e == 0 ? 0 : edges[at(e - 1)][0] + 1, to = e == count ? nodes : edges[at(e)][0];
    for (Index n = from; n <= to; ++n) first_higher[at(n)] = static_cast<Index>(e);
  });
  fill_rows(
      Host{}, nodes, count, [edges](index_t e, const auto& put) { put(edges[at(e)][1], static_cast<Index>(e)); },
      first_lower, lower);
  IncidenceList list;
  list.first.resize(at(nodes) + 1);
  list.entries.resize(2 * edges.size());
  list.first[0] = 0;
  physgen::detail::for_each_index<16>(0, nodes, [&](index_t n) {
    IncidenceEntry* next = list.entries.data() + first_lower[at(n)] + first_higher[at(n)];
    for (Index k = first_lower[at(n)]; k < first_lower[at(n) + 1]; ++k) *next++ = {lower[at(k)], 1};
    for (Index e = first_higher[at(n)]; e < first_higher[at(n) + 1]; ++e) *next++ = {e, 0};
    list.first[at(n) + 1] = first_lower[at(n) + 1] + first_higher[at(n) + 1];
  });
  stage.moves(edges, list.first, list.entries);
  return list;
}

TetMesh make_tet_mesh(Index nodes, std::vector<std::array<Index, 4>> tets) {
  if (nodes < 0) throw Error("mesh: " + std::to_string(nodes) + " nodes; there must be 0 or more");
  // 12: a loose tet has 6 edges of its own, and each edge is an incidence of two nodes.
  check_entries(tets.size(), 2 * tet_edges.size(), "tets");
  check_corners(nodes, tets);
  TetMesh mesh;
  mesh.nodes = nodes;
  mesh.tets = std::move(tets);
  find_rows_of_tets(mesh);
  find_edges(mesh);
  mesh.node_edges = edges_of_nodes(nodes, mesh.edges);
  return mesh;
}

}  // namespace physgen::fem
