// What is said while rows run: how many there are and about how long they take, and on a terminal which one runs.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "measure/row.h"

namespace physgen::bench {

/// A line for the start: the number of rows, and a time that is estimated from their bytes.
[[nodiscard]] std::string announcement(const std::vector<Row>& rows, int threads);

/// Says on stderr which row runs: on a terminal in a line that the next one replaces, else in a line for each row that
/// the table at the end shows no sooner.
class Progress {
 public:
  /// @param rows how many will run @param shown whether to say anything
  Progress(std::size_t rows, bool shown);
  void begin(const Row& row);
  /// Clears the line of a terminal, before anything else is printed there.
  void end() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::size_t rows_, begun_ = 0;
  bool shown_, terminal_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace physgen::bench
