// Which objects of a set cross between ranks: who sends what to whom, and where it lands.
#pragma once

#include <physgen/distributed/local_set.h>
#include <physgen/distributed/transport.h>

#include <vector>

namespace physgen {

/// Objects by their numbers, ascending, as runs of numbers that follow each other.
struct ObjectRuns {
  struct Run {
    index_t first, count;
  };
  std::vector<Run> runs;
  index_t count = 0;  ///< of all

  /// @pre the number is above those that are there
  void add(index_t object) { add(object, 1); }
  /// The same of objects that follow each other. @param more how many, or none
  void add(index_t first, index_t more) {
    if (more <= 0) return;
    if (runs.empty() || runs.back().first + runs.back().count != first) runs.push_back({first, 0});
    runs.back().count += more;
    count += more;
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
