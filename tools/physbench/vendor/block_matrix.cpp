#include "vendor/block_matrix.h"

#include <physgen/error.h>

#include <limits>

namespace physgen::bench {

BlockMatrix make_block_matrix(const fem::AssembledStiffness& stiffness, std::span<const std::uint8_t> fixed,
                              BlockOrder order) {
  const std::size_t nodes = stiffness.nodes.size(), count = nodes + 2 * stiffness.edges.size();
  if (fixed.size() != nodes) {
    throw Error("prescribed components of " + std::to_string(fixed.size()) + " nodes for a stiffness of " +
                std::to_string(nodes));
  }
  if (count > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw Error("a block matrix of " + std::to_string(count) + " blocks is too large for 32-bit numbers");
  }
  const auto ends = [&](std::size_t edge) {
    return std::pair(static_cast<std::size_t>(stiffness.edges[edge][0]),
                     static_cast<std::size_t>(stiffness.edges[edge][1]));
  };
  std::vector<std::size_t> place(nodes + 1, 0);  // where the next block of each row goes
  for (std::size_t e = 0; e < stiffness.edges.size(); ++e) {
    const auto [m, n] = ends(e);
    ++place[m + 1];
    ++place[n + 1];
  }
  BlockMatrix matrix;
  matrix.begin.assign(1, 0);
  for (std::size_t r = 0; r < nodes; ++r) {
    place[r + 1] += place[r] + 1;
    matrix.begin.push_back(static_cast<int>(place[r + 1]));
  }
  matrix.columns.resize(count);
  matrix.blocks.resize(9 * count);
  const auto put = [&](std::size_t row, std::size_t column, const fem::AssembledStiffness::Block& block,
                       bool transposed) {
    const std::size_t at = place[row]++;
    matrix.columns[at] = static_cast<int>(column);
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        const bool is_free = (fixed[row] >> r & 1) == 0 && (fixed[column] >> c & 1) == 0;
        const double value = transposed ? block[3 * r + c] : block[3 * c + r];
        matrix.blocks[9 * at + (order == BlockOrder::by_rows ? 3 * r + c : 3 * c + r)] =
            is_free ? static_cast<float>(value) : 0.0F;
      }
    }
  };
  // Edges ascend, so columns do: first those below the row, then the row's own, then those above.
  for (std::size_t e = 0; e < stiffness.edges.size(); ++e) {
    const auto [m, n] = ends(e);
    put(n, m, stiffness.edge_blocks[e], true);
  }
  for (std::size_t r = 0; r < nodes; ++r) put(r, r, stiffness.nodes[r], false);
  for (std::size_t e = 0; e < stiffness.edges.size(); ++e) {
    const auto [m, n] = ends(e);
    put(m, n, stiffness.edge_blocks[e], false);
  }
  return matrix;
}

}  // namespace physgen::bench
