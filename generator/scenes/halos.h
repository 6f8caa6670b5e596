// Halos of a scene that states which sets its index fields name: which fields each kernel reads of other objects than
// its own, so that ranks among which the objects are divided know what must cross before which step. A use of which the
// analysis does not know whose objects are meant counts as one of others.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scenes/issue.h"

namespace physgen::scenes {

/// A row of the table: a kernel's use of a field through one of its views, over all its steps.
struct HaloRow {
  std::string kernel;  ///< "physgen::fem::ComputeSvd"
  int view = 0;        ///< number of the view among the kernel's
  std::string field;   ///< empty: the kernel uses no field of the view
  bool reads_own = false, reads_others = false, writes_own = false, writes_others = false;
  std::vector<std::string> through;  ///< the index fields that name the others: "body.tets.nodes"; none: not known
  bool operator==(const HaloRow&) const = default;
};

/// A field that a step reads of other objects.
struct HaloRead {
  std::string step;                  ///< "physgen::fem::ComputeSvd(body.gradients, body.svds)"
  std::string kernel;                ///< of the step: "physgen::fem::ComputeSvd"; of other code the step's name
  std::string array, field;          ///< "body.positions", "x"
  std::vector<std::string> through;  ///< none: by numbers that the kernel forms, or that scenes do not see
  std::string local;                 ///< why it is there without an exchange: "tet follows node"; empty: it crosses
  bool operator==(const HaloRead&) const = default;
};

/// Uses of a kernel of which types do not tell whose objects are meant.
struct UnknownHalo {
  std::string step;
  std::vector<std::string> fields;  ///< "body.positions.x"; one at least
  std::string reason;
  bool operator==(const UnknownHalo&) const = default;
};

struct Halos {
  bool stated = false;          ///< the scene states names; else all of the rest is empty
  std::vector<HaloRow> table;   ///< by kernel, view and field, in ascending order
  std::vector<HaloRead> reads;  ///< in the order of the steps
  std::vector<UnknownHalo> unknown;
  std::vector<std::pair<std::string, std::string>>
      rows;               ///< arrays of ranges and of entries, "body.ranges", "body.ends"
  std::string outside;    ///< what code outside of steps uses of objects of which ranks have parts; empty: nothing
  std::string no_arrays;  ///< why no header of arrays for several ranks is written: see distribution.h
  bool operator==(const Halos&) const = default;
};

/// @param usage of the scene's program
/// @param errors gets: a read of others by an index field that does not say whose they are; a write to others
[[nodiscard]] Halos find_halos(const Scene& scene, const usage::Usage& usage, std::vector<Issue>& errors);

/// The header with the table, in the form of <physgen/distributed/halo_uses.h>.
[[nodiscard]] std::string halos_header(const Scene& scene, const Halos& halos);

}  // namespace physgen::scenes
