#include "timings.h"

#include <physgen/detail/launch.h>
#include <physgen/memory/host_list.h>
#include <physgen/memory/memory_error.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>

namespace physgen::truthcube {

namespace {

/// Bytes that a copy on all threads reads and writes in a second, larger than caches; the best of some.
/// @throw MemoryError where there is no room for it beside the solver
double copy_rate() {
  constexpr index_t part = index_t{1} << 20, parts = 128;
  HostList<char> from(static_cast<std::size_t>(parts * part)), to(from.size());
  double best = 0;
  for (int k = 0; k < 4; ++k) {  // the first touches the memory
    const auto start = std::chrono::steady_clock::now();
    detail::for_each_index<part / 16>(0, parts, [&](index_t p) {
      if (k == 0) std::memset(from.data() + p * part, 1, static_cast<std::size_t>(part));
      std::memcpy(to.data() + p * part, from.data() + p * part, static_cast<std::size_t>(part));
    });
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    best = std::max(best, 2.0 * static_cast<double>(from.size()) / took.count());
  }
  return best;
}

}  // namespace

std::vector<StageRecord> records_of(const fem::Stages& stages, double seconds) {
  std::vector<StageRecord> records;
  double other = seconds;
  for (const auto& [name, took, bytes] : stages.all()) {
    records.push_back({name, took, bytes});
    other -= took;
  }
  records.push_back({"other", std::max(other, 0.0), 0});
  return records;
}

void print_timings(const std::vector<StageRecord>& stages, const Terminal& terminal) {
  double rate = 0;
  try {
    rate = copy_rate();
  } catch (const MemoryError&) {  // what was to be measured is done
  }
  terminal.line("  %-26s %10s %10s %10s   of a copy's rate", "stage of the set-up", "seconds", "MB", "GB/s");
  for (const StageRecord& stage : stages) {
    const auto bytes = static_cast<double>(stage.bytes);
    std::array<char, 16> part{};
    if (rate > 0) std::snprintf(part.data(), part.size(), "   %.2f", bytes / stage.seconds / rate);
    if (stage.bytes == 0) {
      terminal.line("  %-26s %10.4f", stage.name.c_str(), stage.seconds);
    } else {
      terminal.line("  %-26s %10.4f %10.1f %10.2f%s", stage.name.c_str(), stage.seconds, bytes / 1e6,
                    bytes / 1e9 / stage.seconds, part.data());
    }
  }
  if (rate > 0) {
    terminal.line("  a copy of memory reads and writes %.2f GB/s", rate / 1e9);
  } else {
    terminal.line("  the memory has no room for a copy beside the solver, so its rate was not measured");
  }
}

}  // namespace physgen::truthcube
