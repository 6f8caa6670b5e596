// What lies around a node depends on which of its eight cells there are and how they are mirrored: one pattern for each
// of the few kinds of nodes, in numbers relative to the node's, is all that is ever found; the rest is copied.
#include <fem/mesh/at.h>
#include <fem/mesh/box_lists.h>
#include <fem/mesh/stages.h>
#include <physgen/scan.h>

#include <algorithm>
#include <bit>
#include <map>
#include <optional>

namespace physgen::fem::detail {

namespace {

using physgen::detail::for_each_index;

// Higher neighbours of a node: steps (dx, dy, dz) from -1 to 1, ascending by their nodes' numbers, are the numbers
// 14 to 26 of (dx + 1) + 3 (dy + 1) + 9 (dz + 1); 26 - s is the way back of s.
constexpr Index steps = 27, here = 13;

// What lies around a node.
struct Pattern {
  // Tets are relative to the first one of the cell above the node along all axes.
  std::vector<IncidenceEntry> node_tets;
  std::vector<Index> higher;              // steps to neighbours
  std::vector<Index> last;                // per neighbour, one past its tets
  std::vector<IncidenceEntry> edge_tets;  // of the edges to them
  std::uint32_t mask = 0;                 // of `higher`

  [[nodiscard]] Index rank(Index step) const { return std::popcount(mask & ((std::uint32_t{1} << step) - 1)); }
};

// The cells below and above a node along an axis.
enum class Cell : std::uint8_t { none, plain, mirrored };
using Sides = std::array<Cell, 2>;

class Box {
 public:
  Box(Index nx, Index ny, Index nz, const MirroredFrom& mirrored)
      : cells_{nx, ny, nz}, mirrored_{mirrored.x, mirrored.y, mirrored.z} {
    for (Index z = 0; z <= nz; ++z) add_kind(2, z);
    for (Index y = 0; y <= ny; ++y) add_kind(1, y);
    for (Index x = 0; x <= nx; ++x) add_kind(0, x);
    for (std::size_t z = 0; z < kinds_[2].size(); ++z) {
      for (std::size_t y = 0; y < kinds_[1].size(); ++y) {
        for (std::size_t x = 0; x < kinds_[0].size(); ++x) {
          patterns_.push_back(make_pattern({kinds_[0][x], kinds_[1][y], kinds_[2][z]}));
        }
      }
    }
  }

  [[nodiscard]] index_t rows() const { return index_t{cells_[1] + 1} * (cells_[2] + 1); }
  // Calls act(node, pattern, first tet of the cell above it along all axes) for the nodes of a row along x.
  template <class Act>
  void each_node(index_t row, const Act& act) const {
    const auto y = static_cast<Index>(row % (cells_[1] + 1)), z = static_cast<Index>(row / (cells_[1] + 1));
    for (Index x = 0; x <= cells_[0]; ++x) {
      const auto node = static_cast<Index>(row * (cells_[0] + 1)) + x;
      act(node, pattern_of({x, y, z}), 6 * (x + cells_[0] * (y + cells_[1] * z)));
    }
  }
  [[nodiscard]] const Pattern& pattern_of(const std::array<Index, 3>& x) const {
    const auto kind = [&](std::size_t k) { return kind_of_[k][at(x[k])]; };
    return patterns_[kind(0) + kinds_[0].size() * (kind(1) + kinds_[1].size() * kind(2))];
  }
  [[nodiscard]] Index distance(Index step) const {
    return step % 3 - 1 + (cells_[0] + 1) * (step / 3 % 3 - 1 + (cells_[1] + 1) * (step / 9 - 1));
  }
  // The node that a step leads to, if there is one.
  [[nodiscard]] std::optional<std::array<Index, 3>> neighbour(std::array<Index, 3> x, Index step) const {
    for (std::size_t k = 0; k < 3; ++k, step /= 3) {
      x[k] += step % 3 - 1;
      if (x[k] < 0 || x[k] > cells_[k]) return std::nullopt;
    }
    return x;
  }
  [[nodiscard]] std::array<Index, 3> place(Index node) const {
    const Index row = cells_[0] + 1, layer = row * (cells_[1] + 1);
    return {node % row, node % layer / row, node / layer};
  }

 private:
  void add_kind(std::size_t axis, Index x) {
    const auto cell = [&](Index c) {
      if (c < 0 || c >= cells_[axis]) return Cell::none;
      return c >= mirrored_[axis] ? Cell::mirrored : Cell::plain;
    };
    const Sides sides{cell(x - 1), cell(x)};
    auto& kinds = kinds_[axis];
    const auto found = std::ranges::find(kinds, sides);
    kind_of_[axis].push_back(static_cast<std::size_t>(found - kinds.begin()));
    if (found == kinds.end()) kinds.push_back(sides);
  }

  [[nodiscard]] Pattern make_pattern(const std::array<Sides, 3>& around) const {
    Pattern pattern;
    std::map<Index, std::vector<IncidenceEntry>> uses;  // per step
    for (unsigned cell = 0; cell < 8; ++cell) {  // bit k: the cell above the node along axis k; ascending by number
      unsigned mirror = 0;
      bool exists = true;
      for (unsigned k = 0; k < 3; ++k) {
        const Cell side = around[k][cell >> k & 1];
        exists = exists && side != Cell::none;
        if (side == Cell::mirrored) mirror |= 1U << k;
      }
      if (!exists) continue;
      const auto below = [cell](unsigned k) { return static_cast<Index>(cell >> k & 1) - 1; };
      const Index first = 6 * (below(0) + cells_[0] * (below(1) + cells_[1] * below(2)));
      const auto own = static_cast<Index>(7 - cell);  // the node is this corner of the cell
      const auto tets = tets_of_cell(mirror);
      for (Index t = 0; t < 6; ++t) {
        for (Index c = 0; c < 4; ++c) {
          if (tets[at(t)][at(c)] == own) pattern.node_tets.push_back({first + t, c});
        }
        for (Index local = 0; local < 6; ++local) {
          const Index a = tets[at(t)][at(tet_edges[at(local)][0])], b = tets[at(t)][at(tet_edges[at(local)][1])];
          if (std::min(a, b) != own) continue;  // corners ascend as their nodes do
          uses[step_between(own, std::max(a, b))].push_back({first + t, a < b ? local : local + 6});
        }
      }
    }
    for (const auto& [step, entries] : uses) {
      pattern.higher.push_back(step);
      pattern.mask |= std::uint32_t{1} << step;
      pattern.edge_tets.insert(pattern.edge_tets.end(), entries.begin(), entries.end());
      pattern.last.push_back(static_cast<Index>(pattern.edge_tets.size()));
    }
    return pattern;
  }
  static Index step_between(Index from, Index to) {
    const auto along = [=](Index k) { return (to >> k & 1) - (from >> k & 1); };
    return here + along(0) + 3 * along(1) + 9 * along(2);
  }

  std::array<Index, 3> cells_, mirrored_;
  std::array<std::vector<Sides>, 3> kinds_;          // of places along each axis
  std::array<std::vector<std::size_t>, 3> kind_of_;  // per place
  std::vector<Pattern> patterns_;
};

IncidenceEntry moved(const IncidenceEntry& entry, Index by) { return {entry.element + by, entry.local}; }

void write_node_tets(TetMesh& mesh, const Box& box) {
  InStage stage("rows of tets");
  mesh.node_tets.first.resize(at(mesh.nodes) + 1);
  mesh.node_tets.first.back() = 0;
  for_each_index<64>(0, box.rows(), [&](index_t row) {
    box.each_node(row, [&](Index n, const Pattern& pattern, Index /*tet*/) {
      mesh.node_tets.first[at(n)] = static_cast<Index>(pattern.node_tets.size());
    });
  });
  mesh.node_tets.entries.resize(at(exclusive_scan(Host{}, std::span(mesh.node_tets.first))));
  for_each_index<512>(0, box.rows(), [&](index_t row) {
    box.each_node(row, [&](Index n, const Pattern& pattern, Index tet) {
      IncidenceEntry* next = mesh.node_tets.entries.data() + mesh.node_tets.first[at(n)];
      for (const IncidenceEntry& entry : pattern.node_tets) *next++ = moved(entry, tet);
    });
  });
  stage.moves(mesh.node_tets.first, mesh.node_tets.entries);
}

/// @return the first edge of each node to a higher one, and one more
HostList<Index> write_edges(TetMesh& mesh, const Box& box) {
  InStage stage("edges and their tets");
  HostList<Index> first(at(mesh.nodes) + 1), uses(first.size());
  first.back() = uses.back() = 0;
  for_each_index<64>(0, box.rows(), [&](index_t row) {
    box.each_node(row, [&](Index n, const Pattern& pattern, Index /*tet*/) {
      first[at(n)] = static_cast<Index>(pattern.higher.size());
      uses[at(n)] = static_cast<Index>(pattern.edge_tets.size());
    });
  });
  mesh.edges.resize(at(exclusive_scan(Host{}, std::span(first))));
  mesh.edge_tets.first.resize(mesh.edges.size() + 1);
  mesh.edge_tets.first[0] = 0;
  mesh.edge_tets.entries.resize(at(exclusive_scan(Host{}, std::span(uses))));
  for_each_index<1024>(0, box.rows(), [&](index_t row) {
    box.each_node(row, [&](Index n, const Pattern& pattern, Index tet) {
      const Index begin = uses[at(n)];
      IncidenceEntry* next = mesh.edge_tets.entries.data() + begin;
      for (const IncidenceEntry& entry : pattern.edge_tets) *next++ = moved(entry, tet);
      std::size_t e = at(first[at(n)]);
      for (std::size_t k = 0; k < pattern.higher.size(); ++k, ++e) {
        mesh.edges[e] = {n, n + box.distance(pattern.higher[k])};
        mesh.edge_tets.first[e + 1] = begin + pattern.last[k];
      }
    });
  });
  stage.moves(mesh.edges, mesh.edge_tets.first, mesh.edge_tets.entries);
  return first;
}

void write_node_edges(TetMesh& mesh, const Box& box, const HostList<Index>& first) {
  InStage stage("rows of edges");
  const auto each_entry = [&](Index n, const Pattern& pattern, const auto& act) {
    const std::array<Index, 3> x = box.place(n);
    for (Index step = 0; step < here; ++step) {  // lower neighbours, ascending
      const auto from = box.neighbour(x, step);
      if (!from) continue;
      const Pattern& other = box.pattern_of(*from);
      const Index back = steps - 1 - step;
      if ((other.mask >> back & 1) != 0) act(IncidenceEntry{first[at(n + box.distance(step))] + other.rank(back), 1});
    }
    for (Index k = 0; k < static_cast<Index>(pattern.higher.size()); ++k) act(IncidenceEntry{first[at(n)] + k, 0});
  };
  mesh.node_edges.first.resize(at(mesh.nodes) + 1);
  mesh.node_edges.first.back() = 0;
  for_each_index<512>(0, box.rows(), [&](index_t row) {
    box.each_node(row, [&](Index n, const Pattern& pattern, Index /*tet*/) {
      Index count = 0;
      each_entry(n, pattern, [&count](const IncidenceEntry& /*entry*/) { ++count; });
      mesh.node_edges.first[at(n)] = count;
    });
  });
  mesh.node_edges.entries.resize(at(exclusive_scan(Host{}, std::span(mesh.node_edges.first))));
  for_each_index<1024>(0, box.rows(), [&](index_t row) {
    box.each_node(row, [&](Index n, const Pattern& pattern, Index /*tet*/) {
      IncidenceEntry* next = mesh.node_edges.entries.data() + mesh.node_edges.first[at(n)];
      each_entry(n, pattern, [&next](const IncidenceEntry& entry) { *next++ = entry; });
    });
  });
  stage.moves(first, mesh.node_edges.first, mesh.node_edges.entries);
}

}  // namespace

std::array<std::array<Index, 4>, 6> tets_of_cell(unsigned mirror) {
  // The six paths from corner 0 to corner 7 of a cell along its edges; odd ones have two corners exchanged, which turns
  // their volume positive.
  std::array<std::array<Index, 4>, 6> tets{
      {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 3, 2, 7}, {0, 5, 1, 7}, {0, 6, 4, 7}}};
  for (auto& tet : tets) {
    for (Index& corner : tet) corner ^= static_cast<Index>(mirror);
    if (std::popcount(mirror) % 2 != 0) std::swap(tet[1], tet[2]);  // a mirror turns volumes negative
  }
  return tets;
}

void write_box_lists(TetMesh& mesh, Index nx, Index ny, Index nz, const MirroredFrom& mirrored) {
  const Box box(nx, ny, nz, mirrored);
  write_node_tets(mesh, box);
  write_node_edges(mesh, box, write_edges(mesh, box));
}

}  // namespace physgen::fem::detail
