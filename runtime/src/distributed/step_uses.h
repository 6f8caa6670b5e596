// One use of a field by a kernel of a step.
#pragma once

#include <physgen/distributed/halo_steps.h>

#include <string>
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

}  // namespace physgen
