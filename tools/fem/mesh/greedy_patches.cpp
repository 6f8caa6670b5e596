// Patches grow one after the other, each by tets across faces of its own: a free tet there has three nodes in the
// patch, so its fourth decides whether it fits. What the growth asks of a tet lies side by side in memory.
#include <fem/mesh/at.h>
#include <fem/mesh/faces.h>
#include <fem/mesh/patches.h>
#include <fem/mesh/stages.h>
#include <physgen/error.h>

#include <algorithm>
#include <span>
#include <string>
#include <tuple>

namespace physgen::fem {

namespace {

constexpr Index none = -1;

// Of one tet: the tet across each face, opposite each corner, and that one's fourth node; none at the boundary.
struct alignas(32) Beside {
  std::array<Index, 4> tets{none, none, none, none};
  std::array<Index, 4> nodes{none, none, none, none};
};

HostList<Beside> find_neighbours(const TetMesh& mesh, std::span<const Index> material_ends) {
  const auto material_of = [&](Index tet) { return std::ranges::upper_bound(material_ends, tet); };
  HostList<Beside> beside(mesh.tets.size());
  physgen::detail::for_each_index<4>(0, static_cast<index_t>(beside.size()), [&](index_t t) { beside[at(t)] = {}; });
  each_face(mesh.nodes, mesh.tets, tets_of_nodes(mesh), [&](Index node, std::span<const FaceUse> uses) {
    if (uses.size() > 2) {
      throw Error("patches: " + std::to_string(uses.size()) + " tets have the face of nodes " + std::to_string(node) +
                  ", " + std::to_string(uses[0].second()) + ", " + std::to_string(uses[0].third()) +
                  ", among them tets " + std::to_string(uses[0].tet()) + " and " + std::to_string(uses[1].tet()) +
                  "; at most two tets may share a face");
    }
    if (uses.size() < 2 || material_of(uses[0].tet()) != material_of(uses[1].tet())) return;
    for (std::size_t k = 0; k < 2; ++k) {
      const FaceUse &own = uses[k], &other = uses[1 - k];
      beside[at(own.tet())].tets[at(own.corner())] = other.tet();
      beside[at(own.tet())].nodes[at(own.corner())] = other.opposite();
    }
  });
  return beside;
}

// The nodes of a patch, in any order.
class NodeSet {
 public:
  explicit NodeSet(const std::array<Index, 4>& tet) { std::ranges::copy(tet, nodes_.begin()); }

  [[nodiscard]] std::span<const Index> nodes() const { return std::span(nodes_).first(count_); }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] bool has(Index node) const {
    bool found = false;
    for (const Index other : nodes_) found |= other == node;  // of all slots: without branches
    return found;
  }
  [[nodiscard]] std::size_t count_with(const NodeSet& others) const {
    return count_ + static_cast<std::size_t>(std::ranges::count_if(others.nodes(), [&](Index n) { return !has(n); }));
  }
  /// @pre count() < 8 where the node is new
  void add(Index node) {
    if (!has(node)) nodes_.at(count_++) = node;
  }
  /// All slots, ascending; those that are not used repeat the first.
  [[nodiscard]] std::array<Index, 8> slots() const {
    std::array<Index, 8> sorted{};
    for (std::size_t k = 0; k < count_; ++k) {
      std::size_t slot = k;
      for (; slot > 0 && sorted.at(slot - 1) > nodes_.at(k); --slot) sorted.at(slot) = sorted.at(slot - 1);
      sorted.at(slot) = nodes_.at(k);
    }
    for (std::size_t k = count_; k < sorted.size(); ++k) sorted.at(k) = sorted[0];
    return sorted;
  }

 private:
  std::array<Index, VolumePatches::max_nodes> nodes_{none, none, none, none, none, none, none, none};
  std::size_t count_ = 4;
};

constexpr std::size_t least_tets = 3, most_tets = 6;

struct Patch {
  NodeSet nodes;
  std::array<Index, least_tets - 1> first_tets;  // all of a patch that is to join another
  std::size_t tets;                              // 0 when it has joined another

  void add(Index tet) {
    if (tets < first_tets.size()) first_tets.at(tets) = tet;
    ++tets;
  }
};

class Greedy {
 public:
  Greedy(const TetMesh& mesh, std::span<const Index> material_ends)
      : mesh_(mesh),
        beside_(find_neighbours(mesh, material_ends)),
        tet_patch_(mesh.tets.size(), none),
        free_(mesh.tets.size()) {
    physgen::detail::for_each_index(0, static_cast<index_t>(free_.size()), [&](index_t t) {
      free_[at(t)] = static_cast<std::uint8_t>(4 - std::ranges::count(beside_[at(t)].tets, none));
    });
    patches_.reserve(mesh.tets.size() / 5);
  }

  VolumePatches run() && {
    for (Index start = next_start(); start != none; start = next_start()) grow(start);
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      if (patches_[p].tets < least_tets) merge(static_cast<Index>(p));
    }
    return lists();
  }

 private:
  // A free tet with the fewest free neighbours of those beside a patch, so that no tets are left over between patches;
  // none when no tet is free.
  Index next_start() {
    for (std::size_t beside = 0; beside < waiting_.size(); ++beside) {
      Queue& waiting = waiting_.at(beside);
      while (waiting.next < waiting.tets.size()) {
        const Index tet = waiting.tets[waiting.next++];
        if (free_[at(tet)] == beside) return tet;
      }
    }
    while (first_free_ < free_.size() && !is_free(static_cast<Index>(first_free_))) ++first_free_;
    return first_free_ < free_.size() ? static_cast<Index>(first_free_) : none;
  }

  // Takes, again and again, the free neighbour of the patch that adds the fewest nodes (the fewest free neighbours,
  // then the lowest number among equals).
  void grow(Index start) {
    const auto number = static_cast<Index>(patches_.size());
    Patch patch{NodeSet(mesh_.tets[at(start)]), {}, 0};
    struct Candidate {
      Index tet, node;
    };
    std::array<Candidate, 4 * most_tets> candidates;  // free tets and their fourth nodes, some more than once
    std::size_t count = 0;
    for (Index tet = start;;) {
      patch.add(tet);
      tet_patch_[at(tet)] = number;
      free_[at(tet)] |= taken;
      const Beside& beside = beside_[at(tet)];
      for (std::size_t c = 0; c < 4; ++c) {
        const Index other = beside.tets[c];
        if (other == none) continue;
        --free_[at(other)];
        if (!is_free(other)) continue;
        waiting_.at(free_[at(other)]).tets.push_back(other);
        candidates.at(count++) = {other, beside.nodes[c]};
      }
      if (patch.tets == most_tets) break;
      std::tuple<bool, std::uint8_t, Index> best{true, taken, none};
      Index node = none;
      std::size_t kept = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const Candidate candidate = candidates.at(k);
        if (!is_free(candidate.tet)) continue;
        candidates.at(kept++) = candidate;
        const bool is_new = !patch.nodes.has(candidate.node);
        if (is_new && patch.nodes.count() == VolumePatches::max_nodes) continue;
        const std::tuple key{is_new, free_[at(candidate.tet)], candidate.tet};
        if (!(key < best)) continue;
        best = key;
        node = candidate.node;
      }
      count = kept;
      tet = std::get<2>(best);
      if (tet == none) break;
      patch.nodes.add(node);
    }
    patches_.push_back(patch);
  }

  void merge(Index number) {
    Patch& patch = patches_[at(number)];
    std::tuple<std::size_t, std::size_t, Index> best{0, 0, none};  // nodes together, tets, patch
    const auto tets = std::span(patch.first_tets).first(patch.tets);
    for (const Index tet : tets) {
      for (const Index neighbour : beside_[at(tet)].tets) {
        if (neighbour == none || tet_patch_[at(neighbour)] == number) continue;
        const Index other = tet_patch_[at(neighbour)];
        const Patch& candidate = patches_[at(other)];
        const std::tuple key{candidate.nodes.count_with(patch.nodes), candidate.tets, other};
        if (std::get<0>(key) > VolumePatches::max_nodes) continue;
        if (std::get<2>(best) == none || key < best) best = key;
      }
    }
    const Index other = std::get<2>(best);
    if (other == none) return;
    Patch& target = patches_[at(other)];
    for (const Index tet : tets) {
      tet_patch_[at(tet)] = other;
      target.add(tet);
    }
    for (const Index node : patch.nodes.nodes()) target.nodes.add(node);
    patch.tets = 0;
  }

  // Numbers the patches that are left, in their order.
  VolumePatches lists() {
    VolumePatches result;
    result.nodes.reserve(patches_.size());
    result.node_counts.reserve(patches_.size());
    std::vector<Index> numbers(patches_.size(), none);
    result.patch_tets.first.reserve(patches_.size() + 1);
    Index begin = 0;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      const Patch& patch = patches_[p];
      if (patch.tets == 0) continue;
      numbers[p] = static_cast<Index>(result.nodes.size());
      result.nodes.push_back(patch.nodes.slots());
      result.node_counts.push_back(static_cast<Index>(patch.nodes.count()));
      result.patch_tets.first.push_back(begin);
      begin += static_cast<Index>(patch.tets);
    }
    result.patch_tets.first.push_back(begin);
    result.tet_slots.resize(mesh_.tets.size());
    physgen::detail::for_each_index<8>(0, static_cast<index_t>(tet_patch_.size()), [&](index_t t) {
      Index& patch = tet_patch_[at(t)];
      patch = numbers[at(patch)];
      for (std::size_t c = 0; c < 4; ++c) {
        const auto& slots = result.nodes[at(patch)];
        result.tet_slots[at(t)][c] =
            static_cast<std::uint8_t>(std::ranges::find(slots, mesh_.tets[at(t)][c]) - slots.begin());
      }
    });
    result.patch_tets.entries.resize(tet_patch_.size());
    std::vector<Index> places(result.nodes.size());
    for (std::size_t t = 0; t < tet_patch_.size(); ++t) {
      const std::size_t p = at(tet_patch_[t]);
      const Index place = places[p]++;
      result.patch_tets.entries[at(result.patch_tets.first[p] + place)] = {static_cast<Index>(t), place};
    }
    result.tet_patch = std::move(tet_patch_);
    return result;
  }

  static constexpr std::uint8_t taken = 0x80;
  [[nodiscard]] bool is_free(Index tet) const { return free_[at(tet)] < taken; }

  struct Queue {
    std::vector<Index> tets;
    std::size_t next = 0;
  };

  const TetMesh& mesh_;
  HostList<Beside> beside_;
  std::vector<Index> tet_patch_;
  std::vector<std::uint8_t> free_;  // per tet: how many neighbours are free; with `taken` where it is in a patch
  // Tets by that number when they were put here; those taken or renumbered since are passed over.
  std::array<Queue, 4> waiting_;
  std::size_t first_free_ = 0;  // no tet before it is free
  std::vector<Patch> patches_;
};

}  // namespace

VolumePatches greedy_patches(const TetMesh& mesh, std::span<const Index> material_ends) {
  InStage stage("patches");
  VolumePatches patches = Greedy(mesh, material_ends).run();
  stage.moves(mesh.tets, mesh.node_tets.first, mesh.node_tets.entries, patches.nodes, patches.node_counts,
              patches.tet_patch, patches.tet_slots, patches.patch_tets.first, patches.patch_tets.entries);
  return patches;
}

}  // namespace physgen::fem
