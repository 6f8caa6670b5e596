// Which objects of a set cross between ranks: who sends what to whom, and where it lands.
#pragma once

#include <physgen/distributed/local_set.h>
#include <physgen/distributed/transport.h>

#include <vector>

namespace physgen {

/// Objects by local numbers, ascending, as runs of numbers that follow each other.
struct ObjectRuns {
  struct Run {
    index_t first, count;
  };
  std::vector<Run> runs;
  index_t count = 0;  ///< of all

  /// @pre the number is above those that are there
  void add(index_t object) {
    if (runs.empty() || runs.back().first + runs.back().count != object) runs.push_back({object, 0});
    ++runs.back().count;
    ++count;
  }
};

/// For each rank with which this one shares objects, in ascending order.
struct HaloPlan {
  struct Peer {
    int rank;
    ObjectRuns sent;      ///< owned objects that it has as ghosts
    ObjectRuns received;  ///< ghosts that it owns, in the order in which it sends them
  };
  std::vector<Peer> peers;
};

/// Of all ghosts. Made by all ranks together, from the ghosts that each has.
[[nodiscard]] HaloPlan make_halo_plan(const LocalSet& set, Transport& transport);

/// Of some of them. Made by all ranks together.
/// @param all make_halo_plan() of the set
/// @param is_needed of each ghost of this rank, in the order of LocalSet::ghosts()
[[nodiscard]] HaloPlan make_halo_plan(const LocalSet& set, Transport& transport, const HaloPlan& all,
                                      const std::vector<char>& is_needed);

}  // namespace physgen
