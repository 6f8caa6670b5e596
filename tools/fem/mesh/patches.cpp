// Patches of the cells of a box, by formula.
#include <fem/mesh/at.h>
#include <fem/mesh/patches.h>
#include <fem/mesh/stages.h>
#include <physgen/detail/host_loop.h>
#include <physgen/error.h>

#include <algorithm>
#include <span>

namespace physgen::fem {

namespace {

// The nodes of a patch, ascending.
class SortedNodes {
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

[[noreturn]] void refuse_other_than_cells() {
  throw Error(
      "cell patches: the tets are not those of the cells of a box, six after six, as make_box_mesh() numbers "
      "them; take greedy_patches() for other meshes");
}

// A box as make_box_mesh() numbers it.
struct CellBox {
  index_t row, layer, cells_x, cells_y, cells;  // row, layer: distances of neighbours in y and z

  // The box whose first cell has these tets. @throw Error when there is none
  static CellBox of(const TetMesh& mesh) {
    SortedNodes cell;
    for (std::size_t t = 0; t < tets_per_cell; ++t) {
      if (!cell.fits(mesh.tets[t])) refuse_other_than_cells();
      cell.add(mesh.tets[t]);
    }
    if (cell.nodes().size() < 8) refuse_other_than_cells();
    const index_t row = cell.nodes()[2], layer = cell.nodes()[4];
    if (row < 2 || layer < 2 * row || layer % row != 0 || mesh.nodes % layer != 0) refuse_other_than_cells();
    const CellBox box{row, layer, row - 1, layer / row - 1, static_cast<index_t>(mesh.tets.size() / tets_per_cell)};
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

  static constexpr std::size_t tets_per_cell = 6;
};

}  // namespace

VolumePatches cell_patches(const TetMesh& box) {
  constexpr std::size_t each = CellBox::tets_per_cell;
  if (box.tets.empty() || box.tets.size() % each != 0) refuse_other_than_cells();
  const CellBox cells = CellBox::of(box);
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

}  // namespace physgen::fem
