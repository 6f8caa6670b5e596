// Nodes of a box that lie alike: what is found around the first of them, moved, is what lies around each.
#pragma once

#include <fem/mesh/at.h>
#include <fem/mesh/mesh.h>
#include <physgen/fill_rows.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace physgen::fem::detail {

/// Where a node of a box lies, along each axis.
[[nodiscard]] inline std::array<Index, 3> place_of(const BoxCells& box, Index node) {
  const Index row = box.cells[0] + 1, layer = row * (box.cells[1] + 1);
  return {node % row, node % layer / row, node / layer};
}

/// Calls act(cell, slot) for the cells of a node, ascending: the slot that cell_patches() gives it there.
template <class Act>
void each_cell_of_node(const BoxCells& box, const std::array<Index, 3>& place, const Act& act) {
  const auto& cells = box.cells;
  for (Index slot = 7; slot >= 0; --slot) {
    std::array<Index, 3> cell{};
    bool exists = true;
    for (std::size_t k = 0; k < 3; ++k) {
      cell[k] = place[k] - (slot >> k & 1);
      exists = exists && cell[k] >= 0 && cell[k] < cells[k];
    }
    if (exists) act(cell[0] + cells[0] * (cell[1] + cells[1] * cell[2]), slot);
  }
}

/// Nodes of a box lie alike where the cells up to `reach` before and behind them, along each axis, are there alike and
/// mirrored alike.
class AlikeNodes {
 public:
  /// A node, and how many places along each axis it is beyond the first node of its kind.
  struct Node {
    Index number, kind;
    std::array<Index, 3> beyond;
  };

  AlikeNodes(const BoxCells& box, Index reach);

  [[nodiscard]] index_t count() const { return index_t{cells_[0] + 1} * (cells_[1] + 1) * (cells_[2] + 1); }
  [[nodiscard]] index_t kinds() const { return static_cast<index_t>(first_.size()); }
  /// The first node of a kind.
  [[nodiscard]] Index first(index_t kind) const { return first_[at(kind)]; }
  /// What to add to numbers of nodes around the first node of its kind for those around a node.
  [[nodiscard]] Index nodes_beyond(const Node& node) const {
    return node.beyond[0] + (cells_[0] + 1) * (node.beyond[1] + (cells_[1] + 1) * node.beyond[2]);
  }
  /// The same of cells, and of nodes of the box of cells half as wide.
  [[nodiscard]] Index cells_beyond(const Node& node) const {
    return node.beyond[0] + cells_[0] * (node.beyond[1] + cells_[1] * node.beyond[2]);
  }
  [[nodiscard]] Index fine_nodes_beyond(const Node& node) const {
    return 2 * (node.beyond[0] + (2 * cells_[0] + 1) * (node.beyond[1] + (2 * cells_[1] + 1) * node.beyond[2]));
  }

  /// Calls act(node) for each node, on several threads.
  /// @param act throws nothing
  template <class Act>
  void each(const Act& act) const {
    each_row([](Index /*first*/) { return 0; }, [&act](const Node& node, int /*own*/) { act(node); });
  }
  /// Calls act(node, own) for each node of a row along x, ascending, with own = begin(the first of them); the rows on
  /// several threads.
  template <class Begin, class Act>
  void each_row(const Begin& begin, const Act& act) const {
    const index_t rows = index_t{cells_[1] + 1} * (cells_[2] + 1);
    physgen::detail::for_each_index<512>(0, rows, [&, this](index_t row) {
      const auto y = static_cast<Index>(row % (cells_[1] + 1)), z = static_cast<Index>(row / (cells_[1] + 1));
      const Place &of_y = along_[1][at(y)], &of_z = along_[2][at(z)];
      const auto x_kinds = static_cast<Index>(kinds_[0]), y_kinds = static_cast<Index>(kinds_[1]);
      const auto number = static_cast<Index>(row * (cells_[0] + 1));
      auto own = begin(number);
      for (Index x = 0; x <= cells_[0]; ++x) {
        const Place& of_x = along_[0][at(x)];
        act(Node{number + x,
                 of_x.kind + x_kinds * (of_y.kind + y_kinds * of_z.kind),
                 {of_x.beyond, of_y.beyond, of_z.beyond}},
            own);
      }
    });
  }

 private:
  struct Place {
    Index kind, beyond;
  };

  std::array<Index, 3> cells_;
  std::array<std::vector<Place>, 3> along_;  // per axis
  std::array<index_t, 3> kinds_{};           // along each axis
  std::vector<Index> first_;                 // per kind
};

inline AlikeNodes::AlikeNodes(const BoxCells& box, Index reach) : cells_(box.cells) {
  enum class Cell : std::uint8_t { none, plain, mirrored };
  const std::array<Index, 3> mirrored{box.mirrored.x, box.mirrored.y, box.mirrored.z};
  std::array<std::vector<Index>, 3> first;  // places along each axis
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<std::vector<Cell>> kinds;
    for (Index x = 0; x <= cells_[axis]; ++x) {
      std::vector<Cell> around;
      for (Index c = x - reach; c < x + reach; ++c) {
        const bool exists = c >= 0 && c < cells_[axis];
        around.push_back(!exists ? Cell::none : (c >= mirrored[axis] ? Cell::mirrored : Cell::plain));
      }
      const auto kind = static_cast<std::size_t>(std::ranges::find(kinds, around) - kinds.begin());
      if (kind == kinds.size()) {
        kinds.push_back(around);
        first[axis].push_back(x);
      }
      along_[axis].push_back({static_cast<Index>(kind), x - first[axis][kind]});
    }
    kinds_[axis] = static_cast<index_t>(kinds.size());
  }
  for (const Index z : first[2]) {
    for (const Index y : first[1]) {
      for (const Index x : first[0]) first_.push_back(x + (cells_[0] + 1) * (y + (cells_[1] + 1) * z));
    }
  }
}

/// append_rows() of nodes: visited is the first node of each kind alone.
/// @param move what it returns for (entry, node) is an entry of that node, `entry` being one of the first of its kind
template <class Entry, class MakeScratch, class Visit, class Move>
void move_rows(const AlikeNodes& nodes, const MakeScratch& make_scratch, const Visit& visit, const Move& move,
               HostList<Index>& first, HostList<Entry>& entries) {
  HostList<Index> first_of_kind;
  HostList<Entry> of_kinds;
  append_rows(
      Host{}, nodes.kinds(), make_scratch,
      [&](index_t kind, auto& scratch, std::vector<Entry>& row) { visit(index_t{nodes.first(kind)}, scratch, row); },
      first_of_kind, of_kinds);
  first.resize(at(nodes.count()) + 1);
  first.back() = 0;
  nodes.each([&](const AlikeNodes::Node& node) {
    first[at(node.number)] = first_of_kind[at(node.kind) + 1] - first_of_kind[at(node.kind)];
  });
  entries.resize(at(exclusive_scan(Host{}, std::span(first))));
  nodes.each([&](const AlikeNodes::Node& node) {
    Entry* next = entries.data() + first[at(node.number)];
    const Entry* const end = of_kinds.data() + first_of_kind[at(node.kind) + 1];
    for (const Entry* entry = of_kinds.data() + first_of_kind[at(node.kind)]; entry < end; ++entry) {
      *next++ = move(*entry, node);
    }
  });
}

}  // namespace physgen::fem::detail
