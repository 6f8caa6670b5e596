// The table: rows side by side in the form of the paper's table 1.
#pragma once

#include <map>
#include <string>

#include "report/errors_table.h"
#include "report/session.h"

namespace physgen::bench {

/// Collects finished rows and prints the table, and that of error against speed, at the end.
class TableReporter final : public benchmark::BenchmarkReporter {
 public:
  TableReporter(const std::vector<Row>& rows, Facts facts) : rows_(rows), facts_(std::move(facts)) {}
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  using Numbers = std::map<std::string, double>;
  /// The rows of a space that are computed in float or double.
  void print_block(const std::string& space, const std::string& computed_in);
  /// @param before the row above it; null at the top
  void print_row(const Row& row, const Row* before, const Numbers& counters, double aos_ms, int width);

  const std::vector<Row>& rows_;
  Facts facts_;
  std::map<std::string, Finished> finished_;
  std::map<std::string, std::string> failed_;
};

}  // namespace physgen::bench
