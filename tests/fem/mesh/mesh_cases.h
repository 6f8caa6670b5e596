// Meshes that the tests of tools/fem/mesh run over: boxes with moved nodes and random numbers, and irregular ones.
#pragma once

#include <fem/mesh/geometry.h>
#include <fem/mesh/mesh.h>
#include <fem/mesh/renumber.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reference.h"

namespace physgen::fem::reference {

struct MeshCase {
  std::string name;
  TetMesh mesh;
  std::vector<Point> rest;  ///< [m]
};

/// A stream of the run's seed.
inline std::mt19937_64 random_stream(std::uint64_t stream) { return std::mt19937_64(seed() * 1000003 + stream); }

inline double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A box of cells of the given sides, its lowest corner at `origin`.
inline MeshCase box(Index nx, Index ny, Index nz, const Point& cell = {1, 1, 1}, const Point& origin = {0, 0, 0}) {
  MeshCase result{"box", make_box_mesh(nx, ny, nz), {}};
  for (Index z = 0; z <= nz; ++z) {
    for (Index y = 0; y <= ny; ++y) {
      for (Index x = 0; x <= nx; ++x) {
        result.rest.push_back({origin[0] + x * cell[0], origin[1] + y * cell[1], origin[2] + z * cell[2]});
      }
    }
  }
  return result;
}

/// All nodes moved by up to `amount` in each coordinate. Tets of unit cells stay positive up to 0.15.
inline MeshCase jittered(MeshCase given, double amount, std::uint64_t stream) {
  auto random = random_stream(stream);
  for (Point& x : given.rest) {
    for (double& coordinate : x) coordinate += uniform(random, -amount, amount);
  }
  given.name += ", jittered";
  return given;
}

/// The same mesh under random numbers of nodes and tets.
inline MeshCase shuffled(const MeshCase& given, std::uint64_t stream) {
  const Renumbering numbers = random_numbering(given.mesh, seed() * 1000003 + stream);
  MeshCase result{given.name + ", shuffled", renumbered(given.mesh, numbers), {}};
  for (const Index old : numbers.node_order) result.rest.push_back(given.rest[static_cast<std::size_t>(old)]);
  return result;
}

/// Tets drawn at random are cut into four around a new node within, `cuts` times: conforming, irregular connectivity.
inline MeshCase cut_at_random(const MeshCase& given, int cuts, std::uint64_t stream) {
  auto random = random_stream(stream);
  MeshCase result{given.name + ", cut at random", {}, given.rest};
  auto tets = given.mesh.tets;
  for (int cut = 0; cut < cuts; ++cut) {
    const std::size_t t = random() % tets.size();
    const auto corners = tets[t];
    std::array<double, 4> weights{};
    double sum = 0;
    for (double& weight : weights) sum += weight = uniform(random, 1, 2);
    Point inner{};
    for (std::size_t c = 0; c < 4; ++c) {
      const Point& x = result.rest[static_cast<std::size_t>(corners[c])];
      for (std::size_t k = 0; k < 3; ++k) inner[k] += weights[c] / sum * x[k];
    }
    const auto node = static_cast<Index>(result.rest.size());
    result.rest.push_back(inner);
    for (std::size_t c = 0; c < 4; ++c) {
      auto part = corners;
      part[c] = node;
      if (c == 0) {
        tets[t] = part;
      } else {
        tets.push_back(part);
      }
    }
  }
  result.mesh = make_tet_mesh(static_cast<Index>(result.rest.size()), std::move(tets));
  return result;
}

/// Two meshes as one that hangs nowhere together.
inline MeshCase beside(const MeshCase& one, const MeshCase& other) {
  MeshCase result{one.name + " beside " + other.name, {}, one.rest};
  result.rest.insert(result.rest.end(), other.rest.begin(), other.rest.end());
  auto tets = one.mesh.tets;
  for (auto tet : other.mesh.tets) {
    for (Index& corner : tet) corner += one.mesh.nodes;
    tets.push_back(tet);
  }
  result.mesh = make_tet_mesh(static_cast<Index>(result.rest.size()), std::move(tets));
  return result;
}

/// Tets around one edge: each of its two ends is a corner of all of them.
inline MeshCase star(Index tets) {
  MeshCase result{"star", {}, {{0, 0, 0}, {0, 0, 1}}};
  std::vector<std::array<Index, 4>> list;
  for (Index t = 0; t < tets; ++t) {
    const double angle = 2 * std::acos(-1.) * t / tets;
    result.rest.push_back({std::cos(angle), std::sin(angle), 0.5});
    list.push_back({0, 2 + t, 2 + (t + 1) % tets, 1});
  }
  result.mesh = make_tet_mesh(tets + 2, std::move(list));
  return result;
}

/// One tet with corners drawn at random, of positive volume.
inline MeshCase random_tet(std::uint64_t stream) {
  auto random = random_stream(stream);
  MeshCase result{"random tet", make_tet_mesh(4, {{0, 1, 2, 3}}), {}};
  do {
    result.rest.clear();
    for (int c = 0; c < 4; ++c) {
      result.rest.push_back({uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)});
    }
  } while (six_volumes({0, 1, 2, 3}, result.rest) < 0.05);
  return result;
}

/// Meshes of all kinds, each a conforming mesh of tets of positive volume.
inline std::vector<MeshCase> mesh_cases() {
  const MeshCase irregular = cut_at_random(jittered(box(4, 3, 5), 0.1, 2), 150, 3);
  return {box(3, 4, 2, {0.5, 2, 1}, {-1, 0, 7}),
          box(1, 1, 1),
          jittered(box(5, 5, 5), 0.15, 1),
          irregular,
          shuffled(irregular, 4),
          shuffled(beside(box(2, 2, 3), irregular), 5),
          random_tet(6),
          cut_at_random(random_tet(7), 40, 8)};
}

inline double volume_of(const TetMesh& mesh, const std::vector<Point>& rest) {
  double sum = 0;
  for (const auto& tet : mesh.tets) sum += six_volumes(tet, rest) / 6;
  return sum;
}

/// How many parts of the mesh, faces counted once, less those of odd dimension: nodes - edges + faces - tets, which is
/// 1 for each part that can be shrunk to a point. Counts nodes of tets alone.
inline std::int64_t euler_characteristic(const TetMesh& mesh) {
  std::set<Index> nodes;
  std::set<std::array<Index, 2>> edges;
  std::set<std::array<Index, 3>> faces;
  for (auto tet : mesh.tets) {
    std::ranges::sort(tet);
    nodes.insert(tet.begin(), tet.end());
    for (const auto& [a, b] : tet_edges) {
      edges.insert({tet[static_cast<std::size_t>(a)], tet[static_cast<std::size_t>(b)]});
    }
    for (const auto& face : {std::array{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
      faces.insert({tet[static_cast<std::size_t>(face[0])], tet[static_cast<std::size_t>(face[1])],
                    tet[static_cast<std::size_t>(face[2])]});
    }
  }
  return static_cast<std::int64_t>(nodes.size()) - static_cast<std::int64_t>(edges.size()) +
         static_cast<std::int64_t>(faces.size()) - static_cast<std::int64_t>(mesh.tets.size());
}

}  // namespace physgen::fem::reference
