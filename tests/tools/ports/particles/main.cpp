// port_particles [SIDE [STEPS [ROUNDS]]]: smoothed particles, SIDE^3 of them, by plain loops and by kernels, in turn. A
// line for each way: a hash of the positions, and the shortest times of all rounds. Exit status 1 where the ways have
// other bits.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "../report.h"
#include "runs.h"

int main(int count, char** words) {
  using namespace fluid;
  const auto number = [&](int k, int otherwise) { return count > k ? std::atoi(words[k]) : otherwise; };
  const int side = number(1, 16), steps = number(2, 12), rounds = number(3, 1);
  struct Way {
    const char* name;
    std::uint64_t hash = 0;
    double rows = std::numeric_limits<double>::max(), kernels = rows, whole = rows;
  } ways[]{{"plain"}, {"kernels"}};
  std::size_t neighbours = 0;
  for (int round = 0; round < rounds; ++round) {
    for (Way& way : ways) {
      const Result result = &way == ways ? run_plain(side, steps) : run_kernels(side, steps);
      way.hash = ports::hash_of(std::span<const float>(result.positions.front().data(), 3 * result.positions.size()));
      way.rows = std::min(way.rows, result.row_seconds);
      way.kernels = std::min(way.kernels, result.kernel_seconds);
      way.whole = std::min(way.whole, result.row_seconds + result.kernel_seconds);
      neighbours = result.neighbours;
    }
  }
  std::printf("%d particles, %zu neighbours, %d steps, %d rounds\n", side * side * side, neighbours, steps, rounds);
  std::printf("%-11s %-17s %8s %11s %9s\n", "way", "positions", "rows [s]", "kernels [s]", "whole [s]");
  for (const Way& way : ways) {
    std::printf("%-11s %016llx %9.4f %11.4f %9.4f\n", way.name, static_cast<unsigned long long>(way.hash), way.rows,
                way.kernels, way.whole);
  }
  return ways[0].hash == ways[1].hash ? 0 : 1;
}
