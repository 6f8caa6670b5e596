// port_cloth [NODES [STEPS [ROUNDS]]]: a sheet of NODES^2 nodes by plain loops and by kernels, in turn. A line for each
// way: a hash of the positions, their sum, and the shortest times of all rounds. Exit status 1 where the sums differ by
// more than rounding (the plain loops add scalar products over all nodes in another order), or pinned nodes have moved.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "../report.h"
#include "runs.h"

int main(int count, char** words) {
  using namespace sheet;
  const auto number = [&](int k, int otherwise) { return count > k ? std::atoi(words[k]) : otherwise; };
  const int side = number(1, 40), steps = number(2, 3), rounds = number(3, 1);
  const Setting setting = make_setting(side);
  struct Way {
    const char* name;
    std::uint64_t hash = 0;
    double sum = 0;
    int iterations = 0;
    double springs = std::numeric_limits<double>::max(), search = springs, whole = springs;
    bool pinned = true;
  } ways[]{{"plain"}, {"kernels"}};
  for (int round = 0; round < rounds; ++round) {
    for (Way& way : ways) {
      const Result result = &way == ways ? run_plain(setting, steps) : run_kernels(side, steps);
      way.hash = ports::hash_of(std::span<const double>(result.positions.front().data(), 3 * result.positions.size()));
      way.sum = 0;
      for (const Point& x : result.positions) way.sum += x[0] + 2 * x[1] + 3 * x[2];
      for (std::size_t i = 0; i < result.positions.size(); ++i) {
        way.pinned = way.pinned && (setting.free[i] != 0 || result.positions[i] == setting.positions[i]);
      }
      way.iterations = result.iterations;
      way.springs = std::min(way.springs, result.spring_seconds);
      way.search = std::min(way.search, result.search_seconds);
      way.whole = std::min(way.whole, result.spring_seconds + result.search_seconds);
    }
  }
  std::printf("%zu nodes, %zu springs, %d steps, %d rounds\n", setting.positions.size(), setting.springs.size(), steps,
              rounds);
  std::printf("%-11s %-17s %-22s %10s %11s %10s %9s\n", "way", "positions", "sum", "iterations", "springs [s]",
              "search [s]", "whole [s]");
  for (const Way& way : ways) {
    std::printf("%-11s %016llx  %-22.16g %10d %11.4f %10.4f %9.4f\n", way.name,
                static_cast<unsigned long long>(way.hash), way.sum, way.iterations, way.springs, way.search, way.whole);
  }
  const bool same = std::abs(ways[0].sum - ways[1].sum) <= 1e-9 * std::abs(ways[0].sum);
  return same && std::ranges::all_of(ways, &Way::pinned) ? 0 : 1;
}
