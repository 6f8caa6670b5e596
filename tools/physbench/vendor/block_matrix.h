// The stiffness as libraries of vendors want it: all blocks of all rows, since block sparse rows have no symmetric
// form.
#pragma once

#include <fem/solver/assembled_stiffness.h>

#include <cstdint>
#include <span>
#include <vector>

namespace physgen::bench {

/// Block sparse rows (BSR) of 3x3 blocks in float: row r has the blocks begin[r] .. begin[r + 1] - 1, by ascending
/// columns. The rows and columns of prescribed components are 0.
struct BlockMatrix {
  std::vector<int> begin, columns;
  std::vector<float> blocks;  ///< nine scalars each
};

enum class BlockOrder { by_columns, by_rows };  ///< of the nine scalars

/// @param fixed per node: bit k is set where component k is prescribed
/// @throw Error when sizes differ, or there are more blocks than 32-bit numbers count
[[nodiscard]] BlockMatrix make_block_matrix(const fem::AssembledStiffness& stiffness,
                                            std::span<const std::uint8_t> fixed, BlockOrder order);

}  // namespace physgen::bench
