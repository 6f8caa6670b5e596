// Results as JSON in which a row is one line, as tools/report/result_lines.py describes.
#pragma once

#include <benchmark/benchmark.h>

#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

namespace physgen::bench {

/// Puts each object that begins a line of JSON, but the whole, into that line.
class RowsOnLines final : public std::streambuf {
 public:
  explicit RowsOnLines(std::ostream& out) : out_(out) {}

  /// The last key and value of the rows that begin behind this, as JSON; empty: none.
  void set_last(std::string last) { last_ = std::move(last); }

 protected:
  int overflow(int character) override;
  int sync() override;

 private:
  void end_line();

  std::ostream& out_;
  std::string line_, row_;          ///< that are not complete
  std::string last_, last_of_row_;  ///< of the next row, and of this one
  bool is_first_ = true;
};

/// Google Benchmark's reporter of JSON, over such lines, with the hashes of each row's compiled kernels.
class ResultsReporter : public benchmark::JSONReporter {
 public:
  explicit ResultsReporter(std::string group) : group_(std::move(group)) {}
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  std::string group_;
  std::optional<RowsOnLines> lines_;
  std::ostream stream_{nullptr};
};

}  // namespace physgen::bench
