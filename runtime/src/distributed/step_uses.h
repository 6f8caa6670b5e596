// One use of a field by a kernel of a step.
#pragma once

#include <physgen/distributed/halo_steps.h>

#include <string>
#include <string_view>
#include <vector>

namespace physgen {

struct HaloSteps::Use {
  std::string kernel;
  Field field;      ///< of no array (-1): of one that all ranks keep, which the kernel may write
  bool is_known;    ///< whether the table has rows of this view
  bool is_written;  ///< may be, by the type of the view
  HaloAccess access;
  std::vector<std::string> through;
};

/// Whether a field is meant by a name: "points.x" means that of all entries, "points[0].x".
inline bool is_named(std::string_view field, std::string_view name) {
  while (!field.empty() && !name.empty() && field.front() == name.front()) {
    field.remove_prefix(1);
    name.remove_prefix(1);
    if (field.starts_with('[')) field.remove_prefix(field.find(']') + 1);
  }
  return field.empty() && name.empty();
}

}  // namespace physgen
