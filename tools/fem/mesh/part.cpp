// Tets are looked at in ascending order, and kept where they name an owned node.
#include <fem/mesh/at.h>
#include <fem/mesh/box_lists.h>
#include <fem/mesh/part.h>
#include <physgen/error.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

namespace physgen::fem {

namespace {

class PartBuilder {
 public:
  PartBuilder(const Runs& nodes, int rank) : nodes_(nodes), rank_(rank) {
    if (rank >= 0 && rank < nodes.ranks()) return;
    throw Error("part of a mesh: there is no rank " + std::to_string(rank) + " of " + std::to_string(nodes.ranks()) +
                "; name one of 0 .. " + std::to_string(nodes.ranks() - 1));
  }

  void look_at(Index tet, const std::array<Index, 4>& corners) {
    const auto is_own = [this](Index n) { return nodes_.owns(rank_, n); };
    if (std::ranges::none_of(corners, is_own)) return;
    numbers_.push_back(tet);
    corners_.push_back(corners);
    std::ranges::copy_if(corners, std::back_inserter(ghosts_), [&](Index n) { return !is_own(n); });
    if (ghosts_.size() > 2 * distinct_ + room) drop_repeated();
  }

  MeshPart part() && {
    drop_repeated();
    numbers_.shrink_to_fit();
    corners_.shrink_to_fit();
    return {LocalSet(nodes_, rank_, std::move(ghosts_)), std::move(numbers_), std::move(corners_)};
  }

 private:
  void drop_repeated() {
    std::ranges::sort(ghosts_);
    const auto repeated = std::ranges::unique(ghosts_);
    ghosts_.erase(repeated.begin(), repeated.end());
    distinct_ = ghosts_.size();
  }

  static constexpr std::size_t room = 4096;

  const Runs& nodes_;
  int rank_;
  std::vector<Index> numbers_;
  std::vector<std::array<Index, 4>> corners_;
  std::vector<index_t> ghosts_;
  std::size_t distinct_ = 0;  // of the ghosts when they were sorted last
};

}  // namespace

std::vector<std::array<Index, 4>> MeshPart::local_tets() const {
  std::vector<std::array<Index, 4>> local = tet_corners;
  for (auto& tet : local) {
    for (Index& n : tet) n = static_cast<Index>(nodes.local(n));
  }
  return local;
}

std::int64_t MeshPart::bytes() const {
  return static_cast<std::int64_t>(nodes.ghosts().size_bytes() + tet_numbers.size() * sizeof(Index) +
                                   tet_corners.size() * sizeof(tet_corners[0]));
}

MeshPart part_of(std::span<const std::array<Index, 4>> tets, const Runs& nodes, int rank) {
  PartBuilder builder(nodes, rank);
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const auto [low, high] = std::ranges::minmax(tets[t]);
    if (low < 0 || high >= nodes.size()) {
      throw Error("part of a mesh: tet " + std::to_string(t) + " names node " + std::to_string(low < 0 ? low : high) +
                  ", which is none of " + std::to_string(nodes.size()) + "; give the runs of this mesh's nodes");
    }
    builder.look_at(static_cast<Index>(t), tets[t]);
  }
  return std::move(builder).part();
}

MeshPart part_of_box(Index nx, Index ny, Index nz, const MirroredFrom& mirrored, const Runs& nodes, int rank) {
  const std::string cells =
      "part of a box: cells " + std::to_string(nx) + " x " + std::to_string(ny) + " x " + std::to_string(nz);
  if (nx < 1 || ny < 1 || nz < 1) throw Error(cells + "; each count must be at least 1");
  // In double first: the product of three 32-bit counts overflows 64 bits.
  if (6. * nx * ny * nz > std::numeric_limits<Index>::max()) throw Error(cells + ": tets do not fit a 32-bit index");
  const index_t row = nx + 1, layer = row * (ny + 1);
  if (nodes.size() != layer * (nz + 1)) {
    throw Error(cells + " have " + std::to_string(layer * (nz + 1)) + " nodes, and the runs are of " +
                std::to_string(nodes.size()) + "; give the runs of this box's nodes");
  }
  PartBuilder builder(nodes, rank);
  const index_t begin = nodes.begin(rank), end = nodes.end(rank);
  if (begin == end) return std::move(builder).part();
  // Layers of cells that touch an owned node, and in each the rows of cells.
  const index_t first_z = std::max<index_t>(begin / layer - 1, 0),
                last_z = std::min<index_t>((end - 1) / layer, nz - 1);
  for (index_t z = first_z; z <= last_z; ++z) {
    for (index_t y = 0; y < ny; ++y) {
      const index_t low = row * y + layer * z, high = low + row + layer + nx;  // nodes of that row's cells
      if (high < begin || low >= end) continue;
      for (index_t x = 0; x < nx; ++x) {
        const unsigned mirror = (x >= mirrored.x ? 1U : 0U) | (y >= mirrored.y ? 2U : 0U) | (z >= mirrored.z ? 4U : 0U);
        const index_t first_tet = 6 * (x + nx * (y + ny * z));
        const auto tets = detail::tets_of_cell(mirror);
        for (std::size_t t = 0; t < tets.size(); ++t) {
          std::array<Index, 4> corners{};
          for (std::size_t c = 0; c < 4; ++c) {
            const Index k = tets[t][c];
            corners[c] = static_cast<Index>(low + x + (k & 1) + row * (k >> 1 & 1) + layer * (k >> 2));
          }
          builder.look_at(static_cast<Index>(first_tet) + static_cast<Index>(t), corners);
        }
      }
    }
  }
  return std::move(builder).part();
}

}  // namespace physgen::fem
