// Red refinement of a tet along a path through its corners. Paths follow one direction in space, in fine tets as in
// coarse ones, so that refining again goes on alike.
#include <fem/mesh/at.h>
#include <fem/mesh/geometry.h>
#include <fem/mesh/refine.h>
#include <physgen/detail/launch.h>
#include <physgen/error.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace physgen::fem {

namespace {

// A node of the fine tets within one coarse tet: the middle of two corners of its path, which may be the same.
using Middle = std::array<std::size_t, 2>;

// The eight fine tets as paths. Edges of the path a, b, c of the coarse tet become halves of a, b, c in the first four
// and in turn b c a, b a c, c a b, a c b in the others: those with an odd exchange have the other sign of volume.
struct FinePath {
  std::array<Middle, 4> corners;
  bool odd;
};
constexpr std::array<FinePath, 8> fine_paths{{{{{{0, 0}, {0, 1}, {0, 2}, {0, 3}}}, false},
                                              {{{{0, 1}, {1, 1}, {1, 2}, {1, 3}}}, false},
                                              {{{{0, 2}, {1, 2}, {2, 2}, {2, 3}}}, false},
                                              {{{{0, 3}, {1, 3}, {2, 3}, {3, 3}}}, false},
                                              {{{{0, 1}, {0, 2}, {0, 3}, {1, 3}}}, false},
                                              {{{{0, 1}, {0, 2}, {1, 2}, {1, 3}}}, true},
                                              {{{{0, 2}, {0, 3}, {1, 3}, {2, 3}}}, false},
                                              {{{{0, 2}, {1, 2}, {1, 3}, {2, 3}}}, true}}};

// The direction of the paths. Its components are positive for the sake of Kuhn meshes, whose paths run along the axes,
// and no simple multiples of each other, lest edges of other meshes stand at right angles to it.
constexpr Point along{0.5257311121191336, 0.3249196962329063, 0.7862014103227434};

// A tet's corners in the order of the path, and whether that exchanges them an odd number of times.
struct Path {
  std::array<std::size_t, 4> corners{0, 1, 2, 3};
  bool odd = false;
};

Path path_of(const std::array<Index, 4>& tet, std::span<const Point> rest) {
  Path path;
  // From the first corner, because coordinates may be large beside the tet.
  const Point& origin = rest[static_cast<std::size_t>(tet[0])];
  std::array<double, 4> way{};
  for (std::size_t c = 0; c < 4; ++c) way[c] = dot(along, difference(rest[static_cast<std::size_t>(tet[c])], origin));
  for (std::size_t end = 3; end > 0; --end) {
    for (std::size_t c = 0; c < end; ++c) {
      if (way[path.corners[c]] <= way[path.corners[c + 1]]) continue;
      std::swap(path.corners[c], path.corners[c + 1]);
      path.odd = !path.odd;
    }
  }
  return path;
}

// The fine numbers of the midpoints of each tet's edges, local edges in the order of tet_edges.
HostList<std::array<Index, 6>> midpoints_of(const TetMesh& mesh) {
  HostList<std::array<Index, 6>> midpoints(mesh.tets.size());
  physgen::detail::for_each_index<8>(0, static_cast<index_t>(mesh.edges.size()), [&](index_t e) {
    for (Index k = mesh.edge_tets.first[at(e)]; k < mesh.edge_tets.first[at(e) + 1]; ++k) {
      const auto [tet, local] = mesh.edge_tets.entries[at(k)];
      midpoints[at(tet)][at(local % 6)] = mesh.nodes + static_cast<Index>(e);
    }
  });
  return midpoints;
}

std::size_t local_edge(std::size_t a, std::size_t b) {
  constexpr std::array<std::array<std::size_t, 4>, 4> edges{{{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}}};
  return edges[a][b];
}

std::array<Index, 4> fine_tet(const FinePath& fine_path, const Path& path, const std::array<Index, 4>& tet,
                              const std::array<Index, 6>& midpoints) {
  std::array<Index, 4> fine{};
  for (std::size_t c = 0; c < 4; ++c) {
    const std::size_t a = path.corners[fine_path.corners[c][0]], b = path.corners[fine_path.corners[c][1]];
    fine[c] = a == b ? tet[a] : midpoints[local_edge(a, b)];
  }
  if (fine_path.odd != path.odd) std::swap(fine[1], fine[2]);
  return fine;
}

}  // namespace

Refined refine(const TetMesh& mesh, std::span<const Point> rest) {
  const auto nodes = static_cast<std::size_t>(mesh.nodes);
  if (rest.size() != nodes) {
    throw Error("refine: " + std::to_string(rest.size()) + " positions for a mesh of " + std::to_string(nodes) +
                " nodes");
  }
  constexpr std::size_t most = std::numeric_limits<Index>::max();
  if (mesh.edges.size() > most - nodes || mesh.tets.size() > most / 8) {
    throw Error("refine: " + std::to_string(8 * mesh.tets.size()) + " tets and " +
                std::to_string(nodes + mesh.edges.size()) + " nodes do not fit a 32-bit index");
  }
  Refined fine;
  fine.rest.resize(nodes + mesh.edges.size());
  fine.parents.resize(nodes + mesh.edges.size());
  physgen::detail::for_each_index<2>(0, mesh.nodes, [&](index_t v) {
    fine.rest[at(v)] = rest[at(v)];
    fine.parents[at(v)] = {static_cast<Index>(v), static_cast<Index>(v)};
  });
  physgen::detail::for_each_index<4>(0, static_cast<index_t>(mesh.edges.size()), [&](index_t e) {
    const auto [m, n] = mesh.edges[at(e)];
    const Point &a = rest[at(m)], &b = rest[at(n)];
    fine.rest[nodes + at(e)] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
    fine.parents[nodes + at(e)] = {m, n};
  });
  const auto midpoints = midpoints_of(mesh);
  std::vector<std::array<Index, 4>> tets(8 * mesh.tets.size());
  physgen::detail::for_each_index<16>(0, static_cast<index_t>(mesh.tets.size()), [&](index_t t) {
    const Path path = path_of(mesh.tets[at(t)], rest);
    for (std::size_t k = 0; k < 8; ++k) {
      tets[8 * at(t) + k] = fine_tet(fine_paths[k], path, mesh.tets[at(t)], midpoints[at(t)]);
    }
  });
  fine.mesh = make_tet_mesh(static_cast<Index>(fine.rest.size()), std::move(tets));
  return fine;
}

std::vector<std::array<Index, 2>> box_parents(Index nx, Index ny, Index nz, const MirroredFrom& mirrored) {
  if (nx < 1 || ny < 1 || nz < 1) {
    throw Error("box parents: cells " + std::to_string(nx) + " x " + std::to_string(ny) + " x " + std::to_string(nz) +
                "; each count must be at least 1");
  }
  // In double first: the product of three 32-bit counts overflows 64 bits. 36: as in make_box_mesh().
  if (36. * 8. * nx * ny * nz > std::numeric_limits<Index>::max()) {
    throw Error("box parents: " + std::to_string(48. * nx * ny * nz) +
                " tets: their incidences do not fit a 32-bit index");
  }
  const BoxCells coarse{{nx, ny, nz}, mirrored};
  std::vector<std::array<Index, 2>> parents(at(2 * nx + 1) * at(2 * ny + 1) * at(2 * nz + 1));
  physgen::detail::for_each_index<64>(0, index_t{2 * ny + 1} * (2 * nz + 1), [&](index_t row) {
    const auto y = static_cast<Index>(row % (2 * ny + 1)), z = static_cast<Index>(row / (2 * ny + 1));
    std::array<Index, 2>* next = parents.data() + row * (2 * nx + 1);
    for (Index x = 0; x <= 2 * nx; ++x) *next++ = box_parents_at(coarse, {x, y, z});
  });
  return parents;
}

}  // namespace physgen::fem
