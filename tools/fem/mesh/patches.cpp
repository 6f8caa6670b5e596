// Both ways number the patch of each tet; slots and lists follow from that number alone.
#include <fem/mesh/patches.h>
#include <physgen/error.h>

#include <algorithm>
#include <span>
#include <string>
#include <tuple>

namespace physgen::fem {

namespace {

constexpr Index none = -1;

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

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
    const std::size_t p = at(tet_patch[t]);
    const Index place = places[p]++;
    list.entries[at(list.first[p] + place)] = {static_cast<Index>(t), place};
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

// Whether the patches have the corners of the cells of a box, in the order of make_box_mesh().
bool are_cells_of_a_box(const VolumePatches& patches, Index nodes) {
  const std::int64_t row = patches.nodes[0][2], layer = patches.nodes[0][4];  // distances of neighbours in y and z
  if (row < 2 || layer < 2 * row || layer % row != 0 || nodes % layer != 0) return false;
  const std::int64_t nx = row - 1, ny = layer / row - 1, nz = nodes / layer - 1;
  if (nz < 1 || static_cast<std::int64_t>(patches.nodes.size()) != nx * ny * nz) return false;
  for (std::int64_t c = 0; c < nx * ny * nz; ++c) {
    const std::int64_t origin = c % nx + row * (c / nx % ny) + layer * (c / (nx * ny));
    const auto& slots = patches.nodes[static_cast<std::size_t>(c)];
    for (std::int64_t s = 0; s < 8; ++s) {
      if (slots[static_cast<std::size_t>(s)] != origin + (s & 1) + row * (s >> 1 & 1) + layer * (s >> 2)) return false;
    }
  }
  return true;
}

}  // namespace

VolumePatches cell_patches(const TetMesh& box) {
  constexpr std::size_t tets_per_cell = 6;
  if (box.tets.empty() || box.tets.size() % tets_per_cell != 0) refuse_other_than_cells();
  std::vector<Index> tet_patch(box.tets.size());
  NodeSet cell;
  for (std::size_t t = 0; t < tet_patch.size(); ++t) {
    tet_patch[t] = static_cast<Index>(t / tets_per_cell);
    if (t % tets_per_cell == 0) cell = {};
    if (!cell.fits(box.tets[t])) refuse_other_than_cells();
    cell.add(box.tets[t]);
  }
  VolumePatches patches = patches_of(box, std::move(tet_patch), box.tets.size() / tets_per_cell);
  if (!are_cells_of_a_box(patches, box.nodes)) refuse_other_than_cells();
  return patches;
}

}  // namespace physgen::fem
