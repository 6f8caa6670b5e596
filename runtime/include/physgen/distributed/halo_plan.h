// Which objects of a set cross between ranks: who sends what to whom, and where it lands.
#pragma once

#include <physgen/distributed/local_set.h>
#include <physgen/distributed/transport.h>

#include <vector>

namespace physgen {

/// For each rank with which this one shares objects, in ascending order.
struct HaloPlan {
  struct Peer {
    int rank;
    std::vector<index_t> sent;  ///< local numbers of owned objects that it has as ghosts, ascending
    index_t first, last;        ///< its objects are the local ones first .. last-1
  };
  std::vector<Peer> peers;
};

/// Made by all ranks together, from the ghosts that each has.
[[nodiscard]] HaloPlan make_halo_plan(const LocalSet& set, Transport& transport);

}  // namespace physgen
