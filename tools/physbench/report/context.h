// The machine that was measured on: for the end of the table and the context of the results' JSON.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace physgen::bench {

/// Pairs of a name and a value, in the order in which they are printed.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// @param command as it was given @param threads of the CPU's rows
[[nodiscard]] Facts describe_machine(int threads, const std::string& command);

/// Memory and last-level caches [bytes], of the CPU and of the GPU; 0 where there is none.
struct Limits {
  double host_memory = 0, host_cache = 0, device_memory = 0, device_cache = 0;
};
[[nodiscard]] Limits find_limits();

}  // namespace physgen::bench
