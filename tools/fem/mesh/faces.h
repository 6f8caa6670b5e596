// The triangles of a list of tets, each once, with the tets that have it: what boundaries, neighbours and checks need.
#pragma once

#include <fem/mesh/mesh.h>
#include <physgen/fill_rows.h>

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace physgen::fem {

/// A face as one tet has it. Uses of one lowest node ascend by the face's other nodes, then by the node opposite, then
/// by the tet.
struct FaceUse {
  std::uint64_t others;        ///< the face's second node, and in the low half its third
  std::uint64_t opposite_use;  ///< the tet's fourth node, and in the low half 4 tet + its corner

  [[nodiscard]] Index second() const { return static_cast<Index>(others >> 32); }
  [[nodiscard]] Index third() const { return static_cast<Index>(others & 0xFFFFFFFF); }
  [[nodiscard]] Index opposite() const { return static_cast<Index>(opposite_use >> 32); }
  [[nodiscard]] Index tet() const { return static_cast<Index>((opposite_use & 0xFFFFFFFF) >> 2); }
  [[nodiscard]] Index corner() const { return static_cast<Index>(opposite_use & 3); }
  auto operator<=>(const FaceUse&) const = default;
};

/// Finds the faces of a node that have no lower one. A thread that does so for many nodes has one of these.
class FacesOfNode {
 public:
  /// Calls visit(std::span<const FaceUse>) once for each, ascending: all its uses, ascending.
  /// @param tets_of called as tets_of(act); calls act(tet) for all tets that have the node as one of their two lowest
  /// corners, and for others of the node or not
  /// @pre fewer than 2^30 tets
  template <class TetsOf, class Visit>
  void each(Index node, std::span<const std::array<Index, 4>> tets, const TetsOf& tets_of, const Visit& visit) {
    tets_.clear();
    tets_of([this](Index tet) { tets_.push_back(tet); });
    corners_.resize(tets_.size());  // apart, so that the memory's answers are awaited together
    for (std::size_t k = 0; k < tets_.size(); ++k) corners_[k] = tets[static_cast<std::size_t>(tets_[k])];
    uses_.clear();
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      const std::array<Index, 4>& corners = corners_[k];
      const int lower = (corners[0] < node) + (corners[1] < node) + (corners[2] < node) + (corners[3] < node);
      if (lower > 1) continue;
      const auto own = static_cast<std::size_t>(std::ranges::find(corners, node) - corners.begin());
      for (std::size_t step = 1; step < 4; ++step) {  // the face opposite each other corner; of a lower one alone
        const std::size_t c = (own + step) % 4;
        if (lower == 1 && corners[c] >= node) continue;
        const Index one = corners[(own + step % 3 + 1) % 4], other = corners[(own + (step + 1) % 3 + 1) % 4];
        uses_.push_back({std::uint64_t(std::min(one, other)) << 32 | std::uint64_t(std::max(one, other)),
                         std::uint64_t(corners[c]) << 32 | std::uint64_t(tets_[k]) << 2 | c});
      }
    }
    physgen::detail::sort_row(uses_.data(), uses_.data() + uses_.size());
    for (std::size_t begin = 0, end = 0; begin < uses_.size(); begin = end) {
      while (end < uses_.size() && uses_[end].others == uses_[begin].others) ++end;
      visit(std::span<const FaceUse>(uses_).subspan(begin, end - begin));
    }
  }

 private:
  std::vector<Index> tets_;
  std::vector<std::array<Index, 4>> corners_;
  std::vector<FaceUse> uses_;
};

/// Calls visit(node, std::span<const FaceUse>) for each face, on several threads: the face's lowest node, and all its
/// uses, ascending. Takes linear time where no node has very many tets.
/// @param tets_of called as tets_of(node, act); see FacesOfNode. @throw what a call throws
template <class TetsOf, class Visit>
void each_face(Index nodes, std::span<const std::array<Index, 4>> tets, const TetsOf& tets_of, const Visit& visit) {
  constexpr index_t block = 256;
  physgen::detail::Spares<FacesOfNode> spares;
  physgen::detail::RegionFailure failure;
  physgen::detail::for_each_index<16 * block>(0, (nodes + block - 1) / block, [&](index_t b) {
    failure.guard([&] {
      spares.lend([] { return FacesOfNode(); },
                  [&](FacesOfNode& faces) {
                    const auto end = static_cast<Index>(std::min<index_t>(nodes, (b + 1) * block));
                    for (auto node = static_cast<Index>(b * block); node < end; ++node) {
                      faces.each(
                          node, tets, [&](const auto& act) { tets_of(node, act); },
                          [&](std::span<const FaceUse> uses) { visit(node, uses); });
                    }
                  });
    });
  });
  failure.rethrow();
}

/// The tets of a node of a mesh, for each_face() and FacesOfNode.
[[nodiscard]] inline auto tets_of_nodes(const TetMesh& mesh) {
  return [&mesh](Index node, const auto& act) {
    const auto n = static_cast<std::size_t>(node);
    for (Index k = mesh.node_tets.first[n]; k < mesh.node_tets.first[n + 1]; ++k) {
      act(mesh.node_tets.entries[static_cast<std::size_t>(k)].element);
    }
  };
}

}  // namespace physgen::fem
