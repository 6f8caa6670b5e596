// Tables and plans that lack something, which a test of random graphs must miss.
#pragma once

#include <physgen/distributed/arrays.h>

#include <set>
#include <utility>
#include <vector>

#include "graph_table.h"

namespace graphs {

/// The middle one of some objects is taken away. @return its number, or -1
inline index_t drop_one(ObjectRuns& objects) {
  ObjectRuns others;
  index_t dropped = -1, at = 0;
  for (const auto& [first, count] : objects.runs) {
    for (index_t i = first; i < first + count; ++i, ++at) {
      if (at == objects.count / 2)
        dropped = i;
      else
        others.add(i);
    }
  }
  objects = std::move(others);
  return dropped;
}

/// Need `number` of each set lacks an object of each message, on both ranks, and so does what is known of its ghosts.
/// @param lack_it the sets of which it does already
inline void drop_objects(const DistributedArrays& arrays, int number, std::set<int>& lack_it) {
  for (std::size_t s = 0; s < arrays.sets().size(); ++s) {
    const DistributedSet& set = arrays.sets()[s];
    const auto n = static_cast<std::size_t>(number);
    if (n >= set.needs.size() || !lack_it.insert(static_cast<int>(s)).second) continue;
    auto& need = const_cast<HaloNeed&>(set.needs[n]);  // no program can
    for (HaloPlan::Peer& peer : need.plan.peers) {
      drop_one(peer.sent);
      if (const index_t ghost = drop_one(peer.received); ghost >= 0) need.has[set.local->ghost_number(ghost)] = 0;
    }
  }
}

/// The table without a row: a view that would have none then has one that says that nothing is used.
inline std::vector<HaloUse> without(std::size_t row) {
  std::vector<HaloUse> rows(std::begin(table), std::end(table));
  const HaloUse removed = rows.at(row);
  rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(row));
  for (const HaloUse& other : rows) {
    if (other.kernel == removed.kernel && other.view == removed.view) return rows;
  }
  rows.push_back({removed.kernel, removed.view, "", {}, {}});
  return rows;
}

}  // namespace graphs
