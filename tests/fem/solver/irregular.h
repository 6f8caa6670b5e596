// Irregular meshes as users bring them: boxes of any size with jittered nodes, bodies that are no boxes, and nodes and
// tets in random order; refined into levels.
#pragma once

#include <fem/mesh/refine.h>
#include <fem/solver/quasistatic.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <numeric>
#include <random>

namespace physgen::fem {

/// Nodes and tets, before anything is made of them.
struct Tets {
  std::vector<Point> rest;  ///< [m]
  std::vector<std::array<Index, 4>> tets;
};

/// A box of cells with a corner in the origin. Coordinates that are not on the boundary are jittered, so that faces
/// stay flat.
/// @param jitter as a part of a cell
/// @param seed of the jitter, printed
inline Tets irregular_box(const std::array<Index, 3>& cells, const Point& size, double jitter, std::uint64_t seed) {
  std::printf("nodes jittered by %g of a cell, seed %llu\n", jitter, static_cast<unsigned long long>(seed));
  Tets box;
  box.tets = make_box_mesh(cells[0], cells[1], cells[2]).tets;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(-jitter, jitter);
  for (Index z = 0; z <= cells[2]; ++z) {
    for (Index y = 0; y <= cells[1]; ++y) {
      for (Index x = 0; x <= cells[0]; ++x) {
        const std::array<Index, 3> at{x, y, z};
        Point point;
        for (std::size_t k = 0; k < 3; ++k) {
          const double moved = at[k] > 0 && at[k] < cells[k] ? part(random) : 0;
          point[k] = at[k] == cells[k] ? size[k] : size[k] * ((at[k] + moved) / cells[k]);
        }
        box.rest.push_back(point);
      }
    }
  }
  return box;
}

/// The tets whose centre is inside, with the nodes that they need.
inline Tets cut(const Tets& all, const std::function<bool(const Point&)>& inside) {
  Tets left;
  std::vector<Index> numbers(all.rest.size(), -1);
  for (const auto& tet : all.tets) {
    Point centre{};
    for (const Index n : tet) {
      for (std::size_t k = 0; k < 3; ++k) centre[k] += all.rest[static_cast<std::size_t>(n)][k] / 4;
    }
    if (!inside(centre)) continue;
    auto kept = tet;
    for (Index& n : kept) {
      Index& number = numbers[static_cast<std::size_t>(n)];
      if (number < 0) {
        number = static_cast<Index>(left.rest.size());
        left.rest.push_back(all.rest[static_cast<std::size_t>(n)]);
      }
      n = number;
    }
    left.tets.push_back(kept);
  }
  return left;
}

/// Small cubes of one cell that stand apart on the plane z = 0: so many, with 8 nodes each. In cells of a background
/// grid they have about 12.
inline Tets studs(Index along_x, Index along_y, double width) {
  constexpr Index apart = 5;
  const std::array<Index, 3> cells{apart * (along_x - 1) + 1, apart * (along_y - 1) + 1, 1};
  const Tets plate = irregular_box(cells, {cells[0] * width, cells[1] * width, width}, 0, 0);
  return cut(plate, [=](const Point& centre) {
    return static_cast<Index>(centre[0] / width) % apart == 0 && static_cast<Index>(centre[1] / width) % apart == 0;
  });
}

/// The same body with nodes, tets, and the first three corners of each tet in random order.
/// @param seed of the order, printed
inline Tets shuffled(const Tets& tets, std::uint64_t seed) {
  std::printf("nodes and tets in random order, seed %llu\n", static_cast<unsigned long long>(seed));
  std::mt19937_64 random(seed);
  std::vector<Index> numbers(tets.rest.size());
  std::iota(numbers.begin(), numbers.end(), Index{0});
  std::shuffle(numbers.begin(), numbers.end(), random);
  Tets result{tets.rest, tets.tets};
  for (std::size_t n = 0; n < numbers.size(); ++n) result.rest[static_cast<std::size_t>(numbers[n])] = tets.rest[n];
  for (auto& tet : result.tets) {
    for (Index& n : tet) n = numbers[static_cast<std::size_t>(n)];
    std::rotate(tet.begin(), tet.begin() + static_cast<int>(random() % 3), tet.begin() + 3);  // keeps its volume's sign
  }
  std::shuffle(result.tets.begin(), result.tets.end(), random);
  return result;
}

/// A mesh alone, or refined: finest first, with greedy patches on every level where they are asked for.
/// @param fixed which components are prescribed at a rest position
inline std::vector<MeshLevel> make_levels(const Tets& tets, int refinements, bool patches,
                                          const std::function<std::uint8_t(const Point&)>& fixed) {
  std::vector<MeshLevel> levels(1);
  levels[0].mesh = make_tet_mesh(static_cast<Index>(tets.rest.size()), tets.tets);
  levels[0].rest = tets.rest;
  for (int k = 0; k < refinements; ++k) {
    Refined refined = refine(levels.front().mesh, levels.front().rest);
    MeshLevel finer;
    finer.mesh = std::move(refined.mesh);
    finer.rest = std::move(refined.rest);
    finer.parents = std::move(refined.parents);
    levels.insert(levels.begin(), std::move(finer));
  }
  for (MeshLevel& level : levels) {
    for (const Point& x : level.rest) level.fixed.push_back(fixed(x));
    if (patches) level.patches = greedy_patches(level.mesh);
  }
  for (std::size_t l = 0; patches && l + 1 < levels.size(); ++l) {
    const IncidenceList& inside = levels[l].patches.patch_tets;
    for (std::size_t p = 0; p + 1 < inside.first.size(); ++p) {
      // Tets 8 t .. 8 t + 7 are parts of the coarse tet t.
      const Index tet = inside.entries[static_cast<std::size_t>(inside.first[p])].element / 8;
      levels[l].patch_parents.push_back(levels[l + 1].patches.tet_patch[static_cast<std::size_t>(tet)]);
    }
  }
  return levels;
}

/// One vector per node, from its rest position.
inline std::vector<Point> at_nodes(const std::vector<Point>& rest, const std::function<Point(const Point&)>& vector) {
  std::vector<Point> result;
  result.reserve(rest.size());
  for (const Point& x : rest) result.push_back(vector(x));
  return result;
}

}  // namespace physgen::fem
