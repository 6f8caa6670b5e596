// Which ghosts of a set steps read: a need for each way in which they find them.
#pragma once

#include <physgen/distributed/halo_plan.h>

#include <compare>
#include <cstdint>
#include <vector>

namespace physgen {

/// Bit n is need n of a set. Of fields of which all ghosts are fresh, all bits, also those of needs that come later.
using HaloNeedBits = std::uint32_t;
inline constexpr HaloNeedBits all_ghosts = ~HaloNeedBits{0};

/// Ghosts of a set, which cross together. Need 0 is all.
struct HaloNeed {
  HaloPlan plan;
  std::vector<char> has;  ///< of each ghost, in the order of LocalSet::ghosts(), whether it is one
  HaloNeedBits within;    ///< the needs that have none but these on any rank; itself is one
};

/// How a step finds objects of others: from those that it is called for it follows index fields.
struct HaloPath {
  int origin;                 ///< the set that the step runs over
  bool is_of_ghosts;          ///< whether it is called for ghosts, too
  std::vector<int> followed;  ///< connections (Partition::Naming), ascending
  std::vector<int> last;      ///< those of them that name what it reads, all of one set, ascending
  auto operator<=>(const HaloPath&) const = default;
};

}  // namespace physgen
