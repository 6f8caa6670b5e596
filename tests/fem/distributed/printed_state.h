// What programs print of solvers on several ranks: digests of what they hand out, and what has crossed.
#pragma once

#include <fem/solver/solvers/solver_on_ranks.h>
#include <physgen/distributed/ranks.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include "digest.h"

namespace physgen::fem {

/// The word behind an option of the command line.
inline std::string asked_word(int argc, char** argv, const std::string& option, const std::string& otherwise) {
  for (int a = 1; a + 1 < argc; a += 2) {
    if (argv[a] == option) return argv[a + 1];
  }
  return otherwise;
}

template <std::size_t kCount>
[[nodiscard]] std::string digest_of(const std::vector<std::array<double, kCount>>& objects) {
  Digest digest;
  for (const auto& object : objects) {
    for (const double number : object) digest.add(number);
  }
  return std::to_string(objects.size()) + " " + digest.text();
}

inline void print_traffic(const Ranks& ranks, const char* what, const Traffic& traffic) {
  if (!ranks.is_first()) return;
  std::printf("traffic of %s: exchanges %lld messages %lld bytes %lld gathers %lld gathered %lld\n", what,
              static_cast<long long>(traffic.exchanges), static_cast<long long>(traffic.messages),
              static_cast<long long>(traffic.bytes), static_cast<long long>(traffic.gathers),
              static_cast<long long>(traffic.gathered_bytes));
}

/// A line for each kernel that the table lacks.
inline void print_unknown(const Ranks& ranks, const RankReport& solver) {
  if (!ranks.is_first()) return;
  for (const std::string& kernel : solver.unknown_kernels()) std::printf("unknown %s\n", kernel.c_str());
}

}  // namespace physgen::fem
