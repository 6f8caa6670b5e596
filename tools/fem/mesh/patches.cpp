// Both ways number the patch of each tet; slots and lists follow from that number alone.
#include <fem/mesh/faces.h>
#include <fem/mesh/patches.h>
#include <fem/mesh/stages.h>
#include <physgen/detail/host_loop.h>
#include <physgen/error.h>

#include <algorithm>
#include <span>
#include <string>
#include <tuple>

namespace physgen::fem {

namespace {

constexpr Index none = -1;

std::size_t at(index_t i) { return static_cast<std::size_t>(i); }

// The nodes of a patch, ascending.
class NodeSet {
 public:
  [[nodiscard]] std::span<const Index> nodes() const { return std::span(nodes_).first(count_); }
  [[nodiscard]] bool has(Index node) const { return std::ranges::find(nodes(), node) != nodes().end(); }

  [[nodiscard]] Index missing(std::span<const Index> others) const {
    return static_cast<Index>(std::ranges::count_if(others, [this](Index node) { return !has(node); }));
  }

  [[nodiscard]] bool fits(std::span<const Index> others) const {
    return static_cast<Index>(count_) + missing(others) <= VolumePatches::max_nodes;
  }

  /// @pre fits(others)
  void add(std::span<const Index> others) {
    for (const Index node : others) {
      if (has(node)) continue;
      std::size_t slot = count_++;
      for (; slot > 0 && nodes_.at(slot - 1) > node; --slot) nodes_.at(slot) = nodes_.at(slot - 1);
      nodes_.at(slot) = node;
    }
  }

 private:
  std::array<Index, VolumePatches::max_nodes> nodes_{};
  std::size_t count_ = 0;
};

IncidenceList lists_of(const std::vector<Index>& tet_patch, std::size_t patches) {
  IncidenceList list;
  list.first.assign(patches + 1, 0);
  for (const Index patch : tet_patch) ++list.first[at(patch) + 1];
  for (std::size_t p = 0; p < patches; ++p) list.first[p + 1] += list.first[p];
  list.entries.resize(tet_patch.size());
  std::vector<Index> places(patches);
  for (std::size_t t = 0; t < tet_patch.size(); ++t) {
    const Index first = list.first[at(tet_patch[t])], place = places[at(tet_patch[t])]++;
    list.entries[at(first + place)] = {static_cast<Index>(t), place};
  }
  return list;
}

// Makes the lists of patches from the patch of each tet, numbered 0, 1, ...
// @pre no patch has more than 8 nodes
VolumePatches patches_of(const TetMesh& mesh, std::vector<Index> tet_patch, std::size_t count) {
  VolumePatches patches;
  std::vector<NodeSet> sets(count);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) sets[at(tet_patch[t])].add(mesh.tets[t]);
  patches.nodes.reserve(count);
  patches.node_counts.reserve(count);
  for (const NodeSet& set : sets) {
    std::array<Index, VolumePatches::max_nodes> slots{};
    slots.fill(set.nodes()[0]);
    std::ranges::copy(set.nodes(), slots.begin());
    patches.nodes.push_back(slots);
    patches.node_counts.push_back(static_cast<Index>(set.nodes().size()));
  }
  patches.tet_slots.resize(mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& slots = patches.nodes[at(tet_patch[t])];
    for (std::size_t c = 0; c < 4; ++c) {
      patches.tet_slots[t][c] = static_cast<std::uint8_t>(std::ranges::find(slots, mesh.tets[t][c]) - slots.begin());
    }
  }
  patches.patch_tets = lists_of(tet_patch, count);
  patches.tet_patch = std::move(tet_patch);
  return patches;
}

[[noreturn]] void refuse_other_than_cells() {
  throw Error(
      "cell patches: the tets are not those of the cells of a box, six after six, as make_box_mesh() numbers "
      "them; take greedy_patches() for other meshes");
}

// A box as make_box_mesh() numbers it.
struct Box {
  static constexpr std::size_t tets_per_cell = 6;
  index_t row, layer, cells_x, cells_y, cells;  // row, layer: distances of neighbours in y and z

  // The box whose first cell has these tets. @throw Error when there is none
  static Box of(const TetMesh& mesh) {
    NodeSet cell;
    for (std::size_t t = 0; t < tets_per_cell; ++t) {
      if (!cell.fits(mesh.tets[t])) refuse_other_than_cells();
      cell.add(mesh.tets[t]);
    }
    if (cell.nodes().size() < at(VolumePatches::max_nodes)) refuse_other_than_cells();
    const index_t row = cell.nodes()[2], layer = cell.nodes()[4];
    if (row < 2 || layer < 2 * row || layer % row != 0 || mesh.nodes % layer != 0) refuse_other_than_cells();
    const Box box{row, layer, row - 1, layer / row - 1, static_cast<index_t>(mesh.tets.size() / tets_per_cell)};
    const index_t cells_z = mesh.nodes / layer - 1;
    if (cells_z < 1 || box.cells != box.cells_x * box.cells_y * cells_z) refuse_other_than_cells();
    return box;
  }

  [[nodiscard]] std::array<Index, 8> corners(index_t cell) const {
    const index_t origin = cell % cells_x + row * (cell / cells_x % cells_y) + layer * (cell / (cells_x * cells_y));
    std::array<Index, 8> nodes{};
    for (index_t s = 0; s < 8; ++s) {
      nodes[at(s)] = static_cast<Index>(origin + (s & 1) + row * (s >> 1 & 1) + layer * (s >> 2));
    }
    return nodes;
  }
};

// The tet across each face, opposite each corner; none at the boundary.
std::vector<std::array<Index, 4>> neighbours_of(const TetMesh& mesh) {
  std::vector<std::array<Index, 4>> neighbours(mesh.tets.size(), {none, none, none, none});
  each_face(mesh.nodes, mesh.tets, [&neighbours](std::span<const FaceUse> uses) {
    if (uses.size() > 2) {
      const auto& [a, b, c] = uses[0].nodes;
      throw Error("patches: " + std::to_string(uses.size()) + " tets have the face of nodes " + std::to_string(a) +
                  ", " + std::to_string(b) + ", " + std::to_string(c) + ", among them tets " +
                  std::to_string(uses[0].use.element) + " and " + std::to_string(uses[1].use.element) +
                  "; at most two tets may share a face");
    }
    if (uses.size() < 2) return;
    const auto [one, corner] = uses[0].use;
    const auto [other, other_corner] = uses[1].use;
    neighbours[at(one)][at(corner)] = other;
    neighbours[at(other)][at(other_corner)] = one;
  });
  return neighbours;
}

class Greedy {
 public:
  explicit Greedy(const TetMesh& mesh)
      : mesh_(mesh), neighbours_(neighbours_of(mesh)), tet_patch_(mesh.tets.size(), none) {
    for (const auto& beside : neighbours_)
      free_beside_.push_back(static_cast<std::uint8_t>(4 - std::ranges::count(beside, none)));
  }

  VolumePatches run() && {
    for (Index start = next_start(); start != none; start = next_start()) grow(start);
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      if (patches_[p].tets.size() < least_tets) merge(static_cast<Index>(p));
    }
    std::vector<Index> numbers(patches_.size(), none);
    Index count = 0;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      if (!patches_[p].tets.empty()) numbers[p] = count++;
    }
    for (Index& patch : tet_patch_) patch = numbers[at(patch)];
    return patches_of(mesh_, std::move(tet_patch_), at(count));
  }

 private:
  static constexpr std::size_t least_tets = 3, most_tets = 6;

  struct Patch {
    std::vector<Index> tets;  // empty when merged into another
    NodeSet nodes;
  };

  // A free tet with the fewest free neighbours of those beside a patch, so that no tets are left over between patches;
  // none when no tet is free.
  Index next_start() {
    for (auto& waiting : waiting_) {
      while (waiting.next < waiting.tets.size()) {
        const Index tet = waiting.tets[waiting.next++];
        if (is_free(tet) && &waiting == &waiting_.at(free_beside(tet))) return tet;
      }
    }
    while (first_free_ < tet_patch_.size() && tet_patch_[first_free_] != none) ++first_free_;
    return first_free_ < tet_patch_.size() ? static_cast<Index>(first_free_) : none;
  }

  void grow(Index start) {
    Patch patch;
    const auto number = static_cast<Index>(patches_.size());
    for (Index tet = start; tet != none; tet = patch.tets.size() < most_tets ? best_for(patch) : none) {
      patch.tets.push_back(tet);
      patch.nodes.add(mesh_.tets[at(tet)]);
      tet_patch_[at(tet)] = number;
      for (const Index other : neighbours_[at(tet)]) {
        if (other == none) continue;
        --free_beside_[at(other)];
        if (is_free(other)) waiting_.at(free_beside(other)).tets.push_back(other);
      }
    }
    patches_.push_back(std::move(patch));
  }

  // The free neighbour that shares most corners with the patch, or none.
  [[nodiscard]] Index best_for(const Patch& patch) const {
    std::tuple<Index, std::size_t, Index> best{4, 0, none};  // nodes that it adds, its free neighbours, tet
    for (const Index tet : patch.tets) {
      for (const Index other : neighbours_[at(tet)]) {
        if (other == none || !is_free(other) || !patch.nodes.fits(mesh_.tets[at(other)])) continue;
        best = std::min(best, {patch.nodes.missing(mesh_.tets[at(other)]), free_beside(other), other});
      }
    }
    return std::get<2>(best);
  }

  void merge(Index number) {
    Patch& patch = patches_[at(number)];
    std::tuple<Index, std::size_t, Index> best{VolumePatches::max_nodes, 0, none};  // nodes it adds, tets, patch
    for (const Index tet : patch.tets) {
      for (const Index neighbour : neighbours_[at(tet)]) {
        if (neighbour == none || tet_patch_[at(neighbour)] == number) continue;
        const Index other = tet_patch_[at(neighbour)];
        const Patch& candidate = patches_[at(other)];
        if (!candidate.nodes.fits(patch.nodes.nodes())) continue;
        const auto together =
            static_cast<Index>(candidate.nodes.nodes().size()) + candidate.nodes.missing(patch.nodes.nodes());
        const std::tuple key{together, candidate.tets.size(), other};
        if (std::get<2>(best) == none || key < best) best = key;
      }
    }
    if (std::get<2>(best) == none) return;
    Patch& target = patches_[at(std::get<2>(best))];
    for (const Index tet : patch.tets) tet_patch_[at(tet)] = std::get<2>(best);
    target.tets.insert(target.tets.end(), patch.tets.begin(), patch.tets.end());
    target.nodes.add(patch.nodes.nodes());
    patch.tets.clear();
  }

  [[nodiscard]] bool is_free(Index tet) const { return tet_patch_[at(tet)] == none; }
  [[nodiscard]] std::size_t free_beside(Index tet) const { return free_beside_[at(tet)]; }

  struct Queue {
    std::vector<Index> tets;
    std::size_t next = 0;
  };

  const TetMesh& mesh_;
  std::vector<std::array<Index, 4>> neighbours_;
  std::vector<Index> tet_patch_;
  std::vector<std::uint8_t> free_beside_;  // per tet: how many neighbours are free
  // Tets by that number when they were put here; those taken or renumbered since are passed over.
  std::array<Queue, 4> waiting_;
  std::size_t first_free_ = 0;  // no tet before it is free
  std::vector<Patch> patches_;
};

}  // namespace

VolumePatches cell_patches(const TetMesh& box) {
  constexpr std::size_t each = Box::tets_per_cell;
  if (box.tets.empty() || box.tets.size() % each != 0) refuse_other_than_cells();
  const Box cells = Box::of(box);
  InStage stage("patches");
  VolumePatches patches;
  patches.nodes.resize(at(cells.cells));
  patches.node_counts.assign(at(cells.cells), VolumePatches::max_nodes);
  patches.tet_patch.resize(box.tets.size());
  patches.tet_slots.resize(box.tets.size());
  patches.patch_tets.first.resize(at(cells.cells) + 1);
  patches.patch_tets.entries.resize(box.tets.size());
  patches.patch_tets.first[0] = 0;
  physgen::detail::host_loop(cells.cells, [&](index_t cell) {
    const std::array<Index, 8> corners = cells.corners(cell);
    unsigned seen = 0;
    for (std::size_t k = 0; k < each; ++k) {
      const std::size_t t = each * at(cell) + k;
      for (std::size_t c = 0; c < 4; ++c) {
        const auto slot = static_cast<std::size_t>(std::ranges::find(corners, box.tets[t][c]) - corners.begin());
        if (slot == corners.size()) refuse_other_than_cells();
        patches.tet_slots[t][c] = static_cast<std::uint8_t>(slot);
        seen |= 1U << slot;
      }
      patches.tet_patch[t] = static_cast<Index>(cell);
      patches.patch_tets.entries[t] = {static_cast<Index>(t), static_cast<Index>(k)};
    }
    if (seen != 0xFF) refuse_other_than_cells();
    patches.nodes[at(cell)] = corners;
    patches.patch_tets.first[at(cell) + 1] = static_cast<Index>(each) * static_cast<Index>(cell + 1);
  });
  stage.moves(box.tets, patches.nodes, patches.node_counts, patches.tet_patch, patches.tet_slots,
              patches.patch_tets.first, patches.patch_tets.entries);
  return patches;
}

VolumePatches greedy_patches(const TetMesh& mesh) { return Greedy(mesh).run(); }

}  // namespace physgen::fem
