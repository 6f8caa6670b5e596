// What a scene says of its arrays on several ranks: sets, which of them follow others, and what names what. A header is
// written of it, relax.distributed.h, with a struct that has the arrays and knows all that (see
// <physgen/distributed/distributed_scene.h>).
#pragma once

#include <string>
#include <vector>

#include "scenes/needs.h"

namespace physgen::scenes {

struct Distribution {
  struct Set {
    std::string name;
    std::string follows;       ///< empty: none
    bool has_entries = false;  ///< of rows: its objects are where their rows are
    bool operator==(const Set&) const = default;
  };
  /// An index field that the program reads, and what it names.
  struct IndexField {
    std::string array, field, set;  ///< "body.edges", "nodes", "node"
    bool operator==(const IndexField&) const = default;
  };
  struct Rows {
    std::string ranges, entries;  ///< "body.ranges", "body.ends"
    std::string field, set;       ///< of the entries, and what it names
    int shift = 0;
    bool operator==(const Rows&) const = default;
  };
  std::vector<Set> sets;  ///< of all groups, in order of declaration, as are the others
  std::vector<IndexField> names;
  std::vector<Rows> rows;
  std::string refused;  ///< why there can be no such header, with the remedy; empty: there is one
  bool operator==(const Distribution&) const = default;
};

/// @pre needs.halos was found, and says that the scene states names
[[nodiscard]] Distribution find_distribution(const Scene& scene, const Needs& needs);

/// The header. @pre nothing is refused
[[nodiscard]] std::string distributed_header(const Scene& scene, const Needs& needs, const Distribution& distribution);

}  // namespace physgen::scenes
