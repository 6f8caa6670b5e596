// The lines of progress, and the estimate of the time.
#include "report/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "report/format.h"

namespace physgen::bench {

std::string announcement(const std::vector<Row>& rows, int threads) {
  // What took longest in a row of each space, where it was measured: the reference and the copies of a row of the CPU,
  // on all threads; the transfers of one of the GPU.
  constexpr double host_row = 0.4, host_object = 1.4e-6, device_object = 0.3e-6;
  double seconds = 0;
  for (const Row& row : rows) {
    const auto objects = static_cast<double>(row.objects);
    seconds += host_row + objects * (row.space == "host" ? host_object : device_object) / std::max(threads, 1);
  }
  return format("%zu rows; about %.0f s in all\n\n", rows.size(), std::ceil(seconds));
}

Progress::Progress(std::size_t rows, bool shown) : rows_(rows), shown_(shown), terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::begin(const Row& row) {
  const std::size_t done = begun_++;
  if (!shown_ || !(terminal_ || row.errors_in_eps)) return;
  std::string left;
  if (done > 0) {
    const std::chrono::duration<double> taken = Clock::now() - start_;
    left = format(", about %.0f s left",
                  std::ceil(taken.count() / static_cast<double>(done) * static_cast<double>(rows_ - done)));
  }
  std::fprintf(stderr, "%s%3zu/%zu %s%s%s", terminal_ ? "\r" : "", begun_, rows_, row.name().c_str(), left.c_str(),
               terminal_ ? "\033[K" : "\n");
}

void Progress::end() const {
  if (shown_ && terminal_) std::fputs("\r\033[K", stderr);
}

}  // namespace physgen::bench
