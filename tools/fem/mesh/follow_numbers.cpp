#include <fem/mesh/at.h>
#include <fem/mesh/follow_numbers.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace physgen::fem {

std::vector<Index> new_numbers(std::span<const Index> order) {
  std::vector<Index> numbers(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) numbers[at(order[i])] = static_cast<Index>(i);
  return numbers;
}

Renumbering refined_numbers(const Renumbering& coarse, std::span<const std::array<Index, 2>> parents) {
  const std::vector<Index> number = new_numbers(coarse.node_order);
  std::vector<std::pair<std::array<Index, 2>, Index>> keys;  // new parents, ascending, and the old number
  keys.reserve(parents.size());
  for (std::size_t n = 0; n < parents.size(); ++n) {
    const auto [low, high] = std::minmax(number[at(parents[n][0])], number[at(parents[n][1])]);
    keys.emplace_back(std::array{low, high}, static_cast<Index>(n));
  }
  std::ranges::sort(keys);
  Renumbering fine;
  fine.node_order.reserve(keys.size());
  for (const auto& [ends, old] : keys) fine.node_order.push_back(old);
  fine.tet_order.reserve(8 * coarse.tet_order.size());
  for (const Index t : coarse.tet_order) {
    for (Index k = 0; k < 8; ++k) fine.tet_order.push_back(8 * t + k);
  }
  return fine;
}

namespace {

/// The slots of a patch under new numbers.
struct Slots {
  std::array<Index, 8> nodes{};         // ascending; those that are not used repeat the first
  std::array<std::uint8_t, 8> moved{};  // per old slot, the new one
};

Slots slots_of(const std::array<Index, 8>& old_nodes, std::size_t used, std::span<const Index> new_node) {
  std::array<std::pair<Index, std::uint8_t>, 8> sorted{};  // new node, old slot
  for (std::size_t s = 0; s < 8; ++s) sorted[s] = {new_node[at(old_nodes[s])], static_cast<std::uint8_t>(s)};
  std::ranges::sort(std::span(sorted).first(used));
  Slots slots;
  for (std::size_t s = 0; s < 8; ++s) slots.nodes[s] = sorted[s < used ? s : 0].first;
  for (std::size_t s = 0; s < used; ++s) slots.moved[sorted[s].second] = static_cast<std::uint8_t>(s);
  return slots;
}

/// Per patch its tets, ascending, and their numbers in it.
IncidenceList tets_of_patches(std::span<const Index> tet_patch, std::size_t patches) {
  IncidenceList list;
  list.first.resize(patches + 1);
  std::ranges::fill(list.first, 0);
  for (const Index p : tet_patch) ++list.first[at(p) + 1];
  std::partial_sum(list.first.begin(), list.first.end(), list.first.begin());
  list.entries.resize(tet_patch.size());
  std::vector<Index> filled(patches, 0);
  for (std::size_t t = 0; t < tet_patch.size(); ++t) {
    const std::size_t p = at(tet_patch[t]);
    const Index k = filled[p]++;
    list.entries[at(list.first[p] + k)] = {static_cast<Index>(t), k};
  }
  return list;
}

}  // namespace

RenumberedPatches renumbered(const VolumePatches& patches, const Renumbering& numbers) {
  constexpr Index none = -1;
  const std::vector<Index> new_node = new_numbers(numbers.node_order);
  std::vector<Index> new_patch(patches.nodes.size(), none);
  std::vector<Slots> slots;  // per new patch
  RenumberedPatches result;
  VolumePatches& fresh = result.patches;
  for (const Index t : numbers.tet_order) {
    const Index old = patches.tet_patch[at(t)];
    Index& patch = new_patch[at(old)];
    if (patch == none) {
      patch = static_cast<Index>(result.order.size());
      result.order.push_back(old);
      slots.push_back(slots_of(patches.nodes[at(old)], at(patches.node_counts[at(old)]), new_node));
      fresh.nodes.push_back(slots.back().nodes);
      fresh.node_counts.push_back(patches.node_counts[at(old)]);
    }
    fresh.tet_patch.push_back(patch);
    std::array<std::uint8_t, 4> own{};
    for (std::size_t c = 0; c < 4; ++c) own[c] = slots[at(patch)].moved[patches.tet_slots[at(t)][c]];
    fresh.tet_slots.push_back(own);
  }
  fresh.patch_tets = tets_of_patches(fresh.tet_patch, result.order.size());
  return result;
}

MeshGroup renumbered(const MeshGroup& group, const TetMesh& mesh, const Renumbering& numbers) {
  const std::vector<Index> node = new_numbers(numbers.node_order), tet = new_numbers(numbers.tet_order);
  MeshGroup result = group;
  for (Index& n : result.nodes) n = node[at(n)];
  for (auto& line : result.lines) line = {node[at(line[0])], node[at(line[1])]};
  for (Face& face : result.faces) face = {node[at(face[0])], node[at(face[1])], node[at(face[2])]};
  for (Index& t : result.tets) t = tet[at(t)];
  complete(result, mesh.tets);
  return result;
}

}  // namespace physgen::fem
