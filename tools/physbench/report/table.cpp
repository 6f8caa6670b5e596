// Formatting of the table.
#include "report/table.h"

#include <algorithm>

#include "report/format.h"

namespace physgen::bench {

namespace {

// The type that a row computes in; storage schemes compute in float.
std::string precision(const Row& row) { return row.storage == "double" ? "double" : "float"; }

// The layout, and the scheme where there is one.
std::string label(const Row& row) {
  return row.storage == precision(row) ? row.layout : row.layout + " " + row.storage;
}

}  // namespace

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
}

void TableReporter::Finalize() {
  for (const char* space : {"host", "cuda"}) {
    for (const char* computed_in : {"float", "double"}) print_block(space, computed_in);
  }
  std::ostream& out = GetOutputStream();
  print_errors_table(out, rows_, finished_);
  for (const auto& [name, message] : failed_) out << "FAILED " << name << ": " << message << "\n";
  for (const auto& [what, value] : facts_) out << format("%-10s ", what.c_str()) << value << "\n";
  out.flush();
}

void TableReporter::print_block(const std::string& space, const std::string& computed_in) {
  std::vector<const Row*> block;
  std::size_t width = 10;
  for (const Row& row : rows_) {
    if (row.errors_in_eps || row.space != space || precision(row) != computed_in || !finished_.contains(row.name()))
      continue;
    block.push_back(&row);
    width = std::max(width, label(row).size());
  }
  if (block.empty()) return;
  const int label_width = static_cast<int>(width);
  GetOutputStream() << (space == "host" ? "CPU, " : "GPU, ") << computed_in << "\n"
                    << format("%-26s %9s %6s  %-*s %9s %8s %6s %7s %6s  %8s %8s %8s\n", "kernel", "objects", "bytes",
                              label_width, "layout", "ms", "GB/s", "/copy", "vs aos", "/LLC", "err p50", "p99", "max");
  const Row* before = nullptr;
  for (const Row* row : block) {
    // AoS is the faster of its two ways on the CPU.
    double aos_ms = 0;
    for (const Row* other : block) {
      if (other->set != row->set || other->kernel != row->kernel || other->objects != row->objects) continue;
      if (other->layout != "aos" && other->layout != "aos_scalar") continue;
      const double ms = finished_.at(other->name()).counters.at(counter::median_ms);
      aos_ms = aos_ms == 0 ? ms : std::min(aos_ms, ms);
    }
    print_row(*row, before, finished_.at(row->name()).counters, aos_ms, label_width);
    before = row;
  }
  GetOutputStream() << "\n";
}

void TableReporter::print_row(const Row& row, const Row* before, const Numbers& counters, double aos_ms, int width) {
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
      << format("  %-*s %9.3f %8.1f %6.2f ", width, label(row).c_str(), ms, counters.at(counter::gb_per_second),
                counters.at(counter::copy_fraction))
      << (aos_ms > 0 ? format("%6.2fx", aos_ms / ms) : format("%7s", "-")) << over_cache(counters);
  if (counters.contains("err_p50")) {
    out << format("  %8.1e %8.1e %8.1e", counters.at("err_p50"), counters.at("err_p99"), counters.at("err_max"));
  }
  const std::string& note = finished_.at(row.name()).label;
  out << (note.empty() ? "" : "  " + note) << "\n";
}

}  // namespace physgen::bench
