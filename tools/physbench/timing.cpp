// The copy on the CPU.
#include "timing.h"

#include <omp.h>

#include <algorithm>
#include <cstring>

namespace physgen::bench {

TimedHostCase::TimedHostCase(double bytes)
    : from_(SpaceKind::host, static_cast<index_t>(bytes / 2), "the source of the copy"),
      to_(SpaceKind::host, static_cast<index_t>(bytes / 2), "the target of the copy") {}

double TimedHostCase::copy() {
  const Stopwatch watch;
#pragma omp parallel
  {
    constexpr index_t page = 4096;
    const index_t piece = align_up(from_.bytes() / omp_get_num_threads() + 1, page);
    const index_t begin = std::min(piece * omp_get_thread_num(), from_.bytes());
    const index_t end = std::min(begin + piece, from_.bytes());
    std::memcpy(to_.data() + begin, from_.data() + begin, static_cast<std::size_t>(end - begin));
  }
  return watch.seconds();
}

}  // namespace physgen::bench
