// How many bytes one of several ranks will take, before anything of it is allocated.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "solver_bytes.h"

namespace physgen::truthcube {

/// What several ranks of a run have.
struct RanksOfBytes {
  int count = 1;
  std::size_t cut = 0;      ///< the finest so many levels are cut: fem::levels_cut_by_solver()
  int cells = 0;            ///< of a side of the cube; 0: of another mesh
  bool has_layers = false;  ///< a rank makes lists of the cube's layers that it needs, and not of the whole
  /// Whether the first rank prints and writes states, by windows of so many bytes.
  std::optional<std::size_t> window = std::nullopt;
  bool sums_groups = false;  ///< as of a case, for which the first rank has some numbers of all nodes
};

/// Bytes of the rank that has most: of its arrays, to 10 % of what the solver says of a cube then, of its lists, and
/// of what the first has besides while it writes. Of another mesh nothing is known of ghosts, so that its arrays are
/// those of what a rank owns: it has more.
[[nodiscard]] RunBytes bytes_of_rank(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings,
                                     RunArrays arrays, const RanksOfBytes& ranks);

}  // namespace physgen::truthcube
