// METIS cuts the graph of nodes; the order is a stable sort by part.
#include <fem/mesh/at.h>
#include <fem/mesh/order.h>
#include <fem/mesh/stages.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <vector>

#ifdef PHYSGEN_HAS_METIS
#include <metis.h>

#include <mutex>
#include <type_traits>
#endif

namespace physgen::fem {

namespace {

constexpr Index most_parts = 64, least_nodes = 8;

Index parts_of(Index nodes) {
  Index parts = most_parts;
  while (parts > 1 && nodes / parts < least_nodes) parts /= 2;
  return parts;
}

#ifdef PHYSGEN_HAS_METIS

/// Per node, its part. The body is halved again and again, so that runs of parts are compact, too: METIS's other way
/// (METIS_PartGraphKway) leaves up to twice as many edges between two or four runs of parts.
std::vector<Index> cut_into_parts(const TetMesh& mesh, Index parts) {
  static_assert(std::is_same_v<idx_t, Index>, "METIS is built with numbers of 32 bits");
  std::vector<idx_t> part(at(mesh.nodes), 0);
  if (parts == 1) return part;
  std::vector<idx_t> first(mesh.node_edges.first.begin(), mesh.node_edges.first.end());
  std::vector<idx_t> neighbours;
  neighbours.reserve(mesh.node_edges.entries.size());
  for (const auto& [edge, side] : mesh.node_edges.entries) {
    neighbours.push_back(mesh.edges[at(edge)][at(1 - side)]);
  }
  std::array<idx_t, METIS_NOPTIONS> options{};
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = 1;
  idx_t nodes = mesh.nodes, constraints = 1, cut = 0;
  static std::mutex one_at_a_time;  // rand() is one for the program
  const std::lock_guard lock(one_at_a_time);
  const int status = METIS_PartGraphRecursive(&nodes, &constraints, first.data(), neighbours.data(), nullptr, nullptr,
                                              nullptr, &parts, nullptr, nullptr, options.data(), &cut, part.data());
  if (status != METIS_OK) {
    throw Error("METIS did not cut a mesh of " + std::to_string(nodes) + " nodes into " + std::to_string(parts) +
                " parts" + (status == METIS_ERROR_MEMORY ? ": its memory ended" : "") +
                "; keep the mesh's own order, or take a coarser mesh");
  }
  return part;
}

#else

std::vector<Index> cut_into_parts(const TetMesh& /*mesh*/, Index /*parts*/) {
  throw Error(
      "an order by parts needs METIS, which this build does not have; install libmetis-dev and configure with "
      "-DPHYSGEN_METIS=ON, or keep the mesh's own order");
}

#endif

/// 0, 1, ... count-1, sorted by key(number); equal ones stay in their order.
template <class Key>
std::vector<Index> sorted(std::size_t count, const Key& key) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, {}, key);
  return order;
}

}  // namespace

#ifdef PHYSGEN_HAS_METIS
bool has_metis() { return true; }
#else
bool has_metis() { return false; }
#endif

Renumbering order_by_parts(const TetMesh& mesh, std::span<const Index> material_ends) {
  InStage stage("order by parts");
  const std::vector<Index> part = cut_into_parts(mesh, parts_of(mesh.nodes));
  Renumbering numbers;
  numbers.node_order = sorted(part.size(), [&](Index n) { return part[at(n)]; });
  // The lowest new node of a tet is of the lowest of its nodes' parts.
  numbers.tet_order = sorted(mesh.tets.size(), [&](Index t) {
    const auto& [a, b, c, d] = mesh.tets[at(t)];
    const auto material = std::ranges::upper_bound(material_ends, t) - material_ends.begin();
    return std::pair(material, std::min({part[at(a)], part[at(b)], part[at(c)], part[at(d)]}));
  });
  stage.moves(mesh.node_edges.first, mesh.node_edges.entries, mesh.edges, mesh.tets, numbers.node_order,
              numbers.tet_order);
  return numbers;
}

}  // namespace physgen::fem
