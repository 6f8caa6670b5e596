// What was measured on: for the end of the table and the context of the JSON.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "options.h"

namespace physgen::bench {

/// Pairs of a name and a value, in the order in which they are printed.
using Machine = std::vector<std::pair<std::string, std::string>>;

/// @param command as it was given
[[nodiscard]] Machine describe_machine(const Options& options, const std::string& command);

/// The GPU's name and driver; what is missing, when there is none. Empty `missing`: rows of the GPU can run.
struct Gpu {
  std::string name, missing;
};
[[nodiscard]] Gpu find_gpu();

}  // namespace physgen::bench
