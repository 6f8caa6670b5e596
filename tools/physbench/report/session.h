// Runs rows under Google Benchmark.
#pragma once

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "measure/row.h"
#include "report/context.h"
#include "report/progress.h"

namespace physgen::bench {

/// Counters of a finished row, by name. Times are medians over the iterations.
namespace counter {
inline constexpr const char* median_ms = "median_ms";
inline constexpr const char* min_ms = "min_ms";
inline constexpr const char* copy_ms = "copy_ms";  ///< a copy of the same bytes, run in turn with the kernel
inline constexpr const char* bytes_per_object = "bytes_per_object";
inline constexpr const char* gb_per_second = "GBps";
inline constexpr const char* copy_fraction = "copy_fraction";
inline constexpr const char* over_cache = "bytes_over_cache";  ///< those bytes over the last-level cache
// Errors: err_p50, err_eps_max and so on.
inline constexpr const char* err = "err_";            ///< relative, of rows of the Truth Cube
inline constexpr const char* err_eps = "err_eps_";    ///< in eps of the storage, of rows of a set
inline constexpr const char* orth_eps = "orth_eps_";  ///< of the rotations, in eps
inline constexpr const char* p50 = "p50";
inline constexpr const char* p99 = "p99";
inline constexpr const char* p9999 = "p9999";
inline constexpr const char* max = "max";
inline constexpr const char* failures = "failures";        ///< among the samples
inline constexpr const char* samples = "samples";          ///< different inputs of a set
inline constexpr const char* worst_index = "worst_index";  ///< of the sample with the largest error
}  // namespace counter

/// Holds the data of the row that runs; its rows must outlive all runs.
class Session {
 public:
  /// @param progress say on stderr which row runs
  Session(std::vector<Row> rows, const Limits& limits, bool progress)
      : rows_(std::move(rows)), limits_(limits), progress_(rows_.size(), progress) {}

  /// Makes Google Benchmark know all rows.
  void register_rows();
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  void run(const Row& row, benchmark::State& state);
  /// Counters of the errors of the prepared row; the worst input of a set is the label.
  void report(const Row& row, benchmark::State& state) const;
  /// One sample of the prepared row.
  void measure();
  /// Puts the data of a row in place, checks its result and warms up; nothing when it is the row of the last call.
  /// @throw Error before anything is allocated when it would take more memory than there is
  void prepare(const Row& row);

  std::vector<Row> rows_;
  Limits limits_;
  Progress progress_;
  const Row* prepared_ = nullptr;
  Case case_;
  Accuracy accuracy_;
  std::vector<double> times_, copies_;  // of the prepared row
};

/// Reporters of Google Benchmark, with our names: without the suffixes that it appends for the way of timing.
template <class Reporter>
class PlainNames final : public Reporter {
 public:
  using Reporter::Reporter;
  void ReportRuns(const std::vector<benchmark::BenchmarkReporter::Run>& runs) override {
    std::vector<benchmark::BenchmarkReporter::Run> named = runs;
    for (auto& run : named) {
      run.run_name.time_type.clear();
      run.run_name.min_time.clear();
    }
    Reporter::ReportRuns(named);
  }
};

}  // namespace physgen::bench
