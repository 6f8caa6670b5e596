// Builds edges and incidence lists by counting and sorting; every list is ascending, so results do not depend on the
// order of construction.
#include <fem/mesh/mesh.h>
#include <physgen/error.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <string>
#include <utility>

namespace physgen::fem {

namespace {

void check_entries(std::size_t objects, std::size_t each, const char* what) {
  if (objects > static_cast<std::size_t>(std::numeric_limits<Index>::max()) / each) {
    throw Error("mesh: incidences of " + std::to_string(objects) + " " + what + " do not fit a 32-bit index");
  }
}

// Lists, for objects 0 .. count-1, the elements that touch them, in the order in which `each` visits the pairs.
template <class Each>
IncidenceList collect(std::size_t count, const Each& each) {
  IncidenceList list;
  list.first.assign(count + 1, 0);
  each([&list](Index object, IncidenceEntry /*entry*/) { ++list.first[static_cast<std::size_t>(object) + 1]; });
  for (std::size_t i = 0; i < count; ++i) list.first[i + 1] += list.first[i];
  list.entries.resize(static_cast<std::size_t>(list.first[count]));
  std::vector<Index> next(list.first.begin(), list.first.end() - 1);
  each([&list, &next](Index object, IncidenceEntry entry) {
    list.entries[static_cast<std::size_t>(next[static_cast<std::size_t>(object)]++)] = entry;
  });
  return list;
}

// One appearance of an edge in a tet: ends in ascending order, then the place, so that sorting groups equal edges.
struct EdgeUse {
  Index m, n;
  IncidenceEntry use;
  auto operator<=>(const EdgeUse&) const = default;
};

std::vector<EdgeUse> edge_uses(const std::vector<std::array<Index, 4>>& tets) {
  std::vector<EdgeUse> uses;
  uses.reserve(tets.size() * tet_edges.size());
  for (std::size_t t = 0; t < tets.size(); ++t) {
    for (std::size_t local = 0; local < tet_edges.size(); ++local) {
      const Index a = tets[t][static_cast<std::size_t>(tet_edges[local][0])];
      const Index b = tets[t][static_cast<std::size_t>(tet_edges[local][1])];
      const auto place = static_cast<Index>(local + (a > b ? 6 : 0));
      uses.push_back({std::min(a, b), std::max(a, b), {static_cast<Index>(t), place}});
    }
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

}  // namespace

TetMesh make_tet_mesh(Index nodes, std::vector<std::array<Index, 4>> tets) {
  if (nodes < 0) throw Error("mesh: " + std::to_string(nodes) + " nodes; there must be 0 or more");
  // 12: a loose tet has 6 edges of its own, and each edge is an incidence of two nodes.
  check_entries(tets.size(), 2 * tet_edges.size(), "tets");
  for (std::size_t t = 0; t < tets.size(); ++t) {
    std::array<Index, 4> corners = tets[t];
    std::sort(corners.begin(), corners.end());
    if (corners[0] < 0 || corners[3] >= nodes) {
      throw Error("mesh: tet " + std::to_string(t) + " names a node outside 0 .. " + std::to_string(nodes - 1));
    }
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) {
      throw Error("mesh: tet " + std::to_string(t) + " names a node twice");
    }
  }
  TetMesh mesh;
  mesh.nodes = nodes;
  mesh.tets = std::move(tets);

  const std::vector<EdgeUse> uses = edge_uses(mesh.tets);
  for (const EdgeUse& use : uses) {
    if (mesh.edges.empty() || mesh.edges.back() != std::array{use.m, use.n}) mesh.edges.push_back({use.m, use.n});
    mesh.edge_tets.entries.push_back(use.use);
    mesh.edge_tets.first.resize(mesh.edges.size() + 1);
    mesh.edge_tets.first.back() = static_cast<Index>(mesh.edge_tets.entries.size());
  }
  if (mesh.edges.empty()) mesh.edge_tets.first = {0};

  const auto count = static_cast<std::size_t>(nodes);
  mesh.node_tets = collect(count, [&mesh](auto&& visit) {
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      for (std::size_t c = 0; c < 4; ++c)
        visit(mesh.tets[t][c], IncidenceEntry{static_cast<Index>(t), static_cast<Index>(c)});
    }
  });
  mesh.node_edges = collect(count, [&mesh](auto&& visit) {
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      for (std::size_t side = 0; side < 2; ++side) {
        visit(mesh.edges[e][side], IncidenceEntry{static_cast<Index>(e), static_cast<Index>(side)});
      }
    }
  });
  return mesh;
}

TetMesh make_box_mesh(Index nx, Index ny, Index nz, const MirroredFrom& mirrored) {
  if (nx < 1 || ny < 1 || nz < 1) {
    throw Error("box mesh: cells " + std::to_string(nx) + " x " + std::to_string(ny) + " x " + std::to_string(nz) +
                "; each count must be at least 1");
  }
  // In double first: the product of three 32-bit counts overflows 64 bits.
  if (36. * nx * ny * nz > std::numeric_limits<Index>::max()) {
    throw Error("box mesh: " + std::to_string(6. * nx * ny * nz) + " tets: their incidences do not fit a 32-bit index");
  }
  // The six paths from corner 0 to corner 7 of a cell along its edges; odd ones have two corners exchanged, which turns
  // their volume positive.
  constexpr std::array<std::array<unsigned, 4>, 6> paths{
      {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 3, 2, 7}, {0, 5, 1, 7}, {0, 6, 4, 7}}};
  const auto node = [nx, ny](Index x, Index y, Index z) { return x + (nx + 1) * (y + (ny + 1) * z); };
  std::vector<std::array<Index, 4>> tets;
  tets.reserve(static_cast<std::size_t>(6) * static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) *
               static_cast<std::size_t>(nz));
  for (Index z = 0; z < nz; ++z) {
    for (Index y = 0; y < ny; ++y) {
      for (Index x = 0; x < nx; ++x) {
        const unsigned mirror = (x >= mirrored.x ? 1U : 0U) | (y >= mirrored.y ? 2U : 0U) | (z >= mirrored.z ? 4U : 0U);
        for (const auto& path : paths) {
          std::array<Index, 4> tet{};
          for (std::size_t c = 0; c < 4; ++c) {
            const auto corner = static_cast<Index>(path[c] ^ mirror);
            tet[c] = node(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2));
          }
          if (std::popcount(mirror) % 2 != 0) std::swap(tet[1], tet[2]);  // a mirror turns volumes negative
          tets.push_back(tet);
        }
      }
    }
  }
  return make_tet_mesh((nx + 1) * (ny + 1) * (nz + 1), std::move(tets));
}

}  // namespace physgen::fem
