// The mesh of relax, and a digest of what is computed over it.
#pragma once

#include <elasticity.physgen.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

namespace relaxed {
using namespace physgen;

/// A lattice, whose edges ascend by their first node, and some edges to far nodes.
struct Mesh {
  index_t side;
  std::vector<std::array<index_t, 2>> edges;
  std::vector<std::vector<elasticity::Incidence<float>>> ends;

  Mesh(index_t cells, bool is_near) : side(cells + 1), ends(static_cast<std::size_t>(side * side * side)) {
    std::mt19937 random(7);
    for (index_t i = 0; i < nodes(); ++i) {
      const std::array<index_t, 3> at = place(i);
      for (std::size_t k = 0; k < 3; ++k) {
        const index_t step = k == 0 ? 1 : k == 1 ? side : side * side;
        if (at[k] + 1 < side) add(i, i + step);
      }
      if (i % 97 == 0 && !is_near) add(i, static_cast<index_t>(random()) % nodes());
    }
  }
  [[nodiscard]] index_t nodes() const { return side * side * side; }
  [[nodiscard]] index_t springs() const { return static_cast<index_t>(edges.size()); }
  [[nodiscard]] const auto& edge(index_t e) const { return edges[static_cast<std::size_t>(e)]; }
  [[nodiscard]] const auto& row(index_t node) const { return ends[static_cast<std::size_t>(node)]; }
  [[nodiscard]] std::array<index_t, 3> place(index_t node) const {
    return {node % side, node / side % side, node / side / side};
  }
  [[nodiscard]] elasticity::NodePosition<float> position(index_t node) const {
    elasticity::NodePosition<float> value{};
    const std::array<index_t, 3> at = place(node);
    for (int k = 0; k < 3; ++k) {
      const auto x = static_cast<float>(at[static_cast<std::size_t>(k)]);
      value.x[k] = x + 0.1F * static_cast<float>((node * (k + 3)) % 7);
    }
    return value;
  }

 private:
  void add(index_t a, index_t b) {
    if (a == b) return;
    for (int k = 0; k < 2; ++k) {
      elasticity::Incidence<float> end{};
      end.element = static_cast<std::int32_t>(edges.size());
      end.local = k;
      ends[static_cast<std::size_t>(k == 0 ? a : b)].push_back(end);
    }
    edges.push_back({a, b});
  }
};

struct Digest {
  std::uint64_t hash = 0xcbf29ce484222325;
  void add(float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    for (int k = 0; k < 4; ++k) hash = (hash ^ (bits >> (8 * k) & 255)) * 0x100000001b3;
  }
};

constexpr double at_rest = 1e-3;

void add(Digest& digest, const auto& positions) {
  for (index_t i = 0; i < positions.size(); ++i) {
    for (int k = 0; k < 3; ++k) digest.add(positions[i].x()[k]);
  }
}

}  // namespace relaxed
