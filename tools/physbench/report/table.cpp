// Formatting of the table.
#include "report/table.h"

#include <algorithm>
#include <tuple>

#include "report/format.h"

namespace physgen::bench {

namespace {

// The type that a row computes in; storage schemes compute in float.
std::string precision(const Row& row) { return row.storage == "double" ? "double" : "float"; }

// The layout, and the scheme where there is one.
std::string label(const Row& row) {
  return row.storage == precision(row) ? row.layout : row.layout + " " + row.storage;
}

bool is_aos(const Row& row) { return row.layout == "aos" || row.layout == "aos_scalar"; }

bool of_one_block(const Row& a, const Row& b) { return a.space == b.space && precision(a) == precision(b); }

// Whether one of them is said in multiples of the other.
bool are_compared(const Row& a, const Row& b) {
  return of_one_block(a, b) && !a.errors_in_eps && !b.errors_in_eps && a.set == b.set && a.kernel == b.kernel &&
         a.objects == b.objects;
}

}  // namespace

std::vector<Row> in_table_order(std::vector<Row> rows) {
  std::ranges::stable_sort(rows, {}, [](const Row& row) {
    return std::tuple(row.errors_in_eps, row.space == "cuda", precision(row) == "double");
  });
  for (auto begin = rows.begin(); begin != rows.end();) {
    const auto end = std::find_if_not(begin, rows.end(), [&](const Row& row) { return are_compared(*begin, row); });
    const auto next = end == begin ? begin + 1 : end;
    std::stable_partition(begin, next, is_aos);
    begin = next;
  }
  return rows;
}

TableReporter::TableReporter(const std::vector<Row>& rows, Facts facts) : rows_(rows), facts_(std::move(facts)) {
  for (const Row& row : rows_) {
    if (!row.errors_in_eps) waiting_.push_back(&row);
  }
}

std::string over_cache(const std::map<std::string, double>& counters) {
  const auto found = counters.find(counter::over_cache);
  return found == counters.end() ? format("%7s", "-") : format(" %6.*f", found->second < 9.95 ? 2 : 0, found->second);
}

void TableReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    const std::string& name = run.run_name.function_name;
    if (run.error_occurred) {
      failed_[name] = run.error_message;
    } else if (run.run_type == Run::RT_Iteration || run.aggregate_name == "median") {
      Finished& row = finished_[name];
      for (const auto& [key, value] : run.counters) row.counters[key] = value.value;
      row.label = run.report_label;
    }
  }
  print_ready(false);
}

void TableReporter::Finalize() {
  print_ready(true);
  std::ostream& out = GetOutputStream();
  if (above_ != nullptr) out << "\n";
  print_errors_table(out, rows_, finished_);
  for (const auto& [name, message] : failed_) out << "FAILED " << name << ": " << message << "\n";
  for (const auto& [what, value] : facts_) out << format("%-10s ", what.c_str()) << value << "\n";
  out.flush();
}

bool TableReporter::is_done(const Row& row) const {
  return finished_.contains(row.name()) || failed_.contains(row.name());
}

void TableReporter::print_ready(bool at_the_end) {
  while (!waiting_.empty()) {
    const Row& row = *waiting_.front();
    bool ready = is_done(row);
    double aos_ms = 0;  // of the faster of AoS's two ways on the CPU
    for (const Row& other : rows_) {
      if (!is_aos(other) || !are_compared(row, other)) continue;
      ready = ready && is_done(other);
      if (!finished_.contains(other.name())) continue;
      const double ms = finished_.at(other.name()).counters.at(counter::median_ms);
      aos_ms = aos_ms == 0 ? ms : std::min(aos_ms, ms);
    }
    if (!ready && !at_the_end) break;
    waiting_.erase(waiting_.begin());
    if (!finished_.contains(row.name())) continue;  // it failed, or did not run
    if (above_ == nullptr || !of_one_block(*above_, row)) print_head(row);
    print_row(row, above_ != nullptr && of_one_block(*above_, row) ? above_ : nullptr,
              finished_.at(row.name()).counters, aos_ms);
    above_ = &row;
  }
  GetOutputStream().flush();
}

void TableReporter::print_head(const Row& row) {
  std::size_t width = 10;
  for (const Row& other : rows_) {
    if (!other.errors_in_eps && of_one_block(row, other)) width = std::max(width, label(other).size());
  }
  width_ = static_cast<int>(width);
  GetOutputStream() << (above_ == nullptr ? "" : "\n") << (row.space == "host" ? "CPU, " : "GPU, ") << precision(row)
                    << "\n"
                    << format("%-26s %9s %6s  %-*s %9s %8s %6s %7s %6s  %8s %8s %8s\n", "kernel", "objects", "bytes",
                              width_, "layout", "ms", "GB/s", "/copy", "vs aos", "/LLC", "err p50", "p99", "max");
}

void TableReporter::print_row(const Row& row, const Row* before, const Numbers& counters, double aos_ms) {
  const double ms = counters.at(counter::median_ms);
  std::ostream& out = GetOutputStream();
  const bool first = before == nullptr || before->kernel != row.kernel || before->set != row.set;
  // A cell that equals the one of the row before stays empty.
  const double bytes = counters.at(counter::bytes_per_object);
  out << format("%-26s ", first ? (row.kernel + (row.set.empty() ? "" : " " + row.set)).c_str() : "")
      << (first || before->objects != row.objects ? format("%9lld ", static_cast<long long>(row.objects))
                                                  : format("%9s ", ""))
      << (first || bytes != finished_.at(before->name()).counters.at(counter::bytes_per_object) ? format("%6.0f", bytes)
                                                                                                : format("%6s", ""))
      << format("  %-*s %9.3f %8.1f %6.2f ", width_, label(row).c_str(), ms, counters.at(counter::gb_per_second),
                counters.at(counter::copy_fraction))
      << (aos_ms > 0 ? format("%6.2fx", aos_ms / ms) : format("%7s", "-")) << over_cache(counters);
  if (counters.contains("err_p50")) {
    out << format("  %8.1e %8.1e %8.1e", counters.at("err_p50"), counters.at("err_p99"), counters.at("err_max"));
  }
  const std::string& note = finished_.at(row.name()).label;
  out << (note.empty() ? "" : "  " + note) << "\n";
}

}  // namespace physgen::bench
