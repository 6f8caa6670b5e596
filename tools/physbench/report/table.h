// The table: rows side by side, in the form of table 1 of the 2010 paper (README.md says which).
#pragma once

#include <map>
#include <string>

#include "report/errors_table.h"
#include "report/session.h"

namespace physgen::bench {

/// Rows as the table has them: by space and precision, each kernel's AoS before what is compared with it.
[[nodiscard]] std::vector<Row> in_table_order(std::vector<Row> rows);

/// Prints the line of each row as soon as that row and the AoS of its kernel are measured, and at the end the table of
/// error against speed, what failed, and the machine.
class TableReporter final : public benchmark::BenchmarkReporter {
 public:
  /// @param rows in the order of in_table_order(); they must outlive this
  TableReporter(const std::vector<Row>& rows, Facts facts);
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  using Numbers = std::map<std::string, double>;
  /// Prints the rows that are next, up to one that waits for itself or its AoS; at the end no row waits.
  void print_ready(bool at_the_end);
  void print_head(const Row& row);
  /// @param before the row above it; null at the top
  void print_row(const Row& row, const Row* before, const Numbers& counters, double aos_ms);
  [[nodiscard]] bool is_done(const Row& row) const;

  const std::vector<Row>& rows_;
  Facts facts_;
  std::vector<const Row*> waiting_;  ///< rows of the table that are not printed, in its order
  const Row* above_ = nullptr;       ///< the row that was printed last
  int width_ = 0;                    ///< of its block's layouts
  std::map<std::string, Finished> finished_;
  std::map<std::string, std::string> failed_;
};

}  // namespace physgen::bench
