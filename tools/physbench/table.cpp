// Formatting of the table.
#include "table.h"

#include <algorithm>

#include "format.h"

namespace physgen::bench {

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
    std::vector<std::string> storages;  // in the order of the rows
    for (const Row& row : rows_) {
      if (std::find(storages.begin(), storages.end(), row.storage) == storages.end()) storages.push_back(row.storage);
    }
    for (const std::string& storage : storages) print_block(space, storage);
  }
  std::ostream& out = GetOutputStream();
  print_errors_table(out, rows_, finished_);
  for (const auto& [name, message] : failed_) out << "FAILED " << name << ": " << message << "\n";
  for (const auto& [what, value] : machine_) out << format("%-10s ", what.c_str()) << value << "\n";
  out.flush();
}

void TableReporter::print_block(const std::string& space, const std::string& storage) {
  bool any = false;
  std::string kernel;
  for (const Row& row : rows_) {
    const auto found = finished_.find(row.name());
    if (row.errors_in_eps || row.space != space || row.storage != storage || found == finished_.end()) continue;
    if (!any) {
      GetOutputStream() << (space == "host" ? "CPU, " : "GPU, ") << storage << "\n"
                        << format("%-26s %9s %6s  %-10s %9s %8s %6s %7s  %8s %8s %8s\n", "kernel", "objects", "bytes",
                                  "layout", "ms", "GB/s", "/copy", "vs aos", "err p50", "p99", "max");
    }
    any = true;
    // AoS is the faster of its two ways on the CPU.
    double aos_ms = 0;
    for (const Row& other : rows_) {
      if (other.errors_in_eps || other.set != row.set || other.kernel != row.kernel || other.storage != storage ||
          other.space != space)
        continue;
      const auto aos = finished_.find(other.name());
      if (aos == finished_.end() || (other.layout != "aos" && other.layout != "aos_scalar")) continue;
      const double ms = aos->second.counters.at(counter::median_ms);
      aos_ms = aos_ms == 0 ? ms : std::min(aos_ms, ms);
    }
    print_row(row, found->second.counters, aos_ms, row.kernel + " " + row.set != kernel);
    kernel = row.kernel + " " + row.set;
  }
  if (any) GetOutputStream() << "\n";
}

void TableReporter::print_row(const Row& row, const Counters& counters, double aos_ms, bool first) {
  const double ms = counters.at(counter::median_ms);
  std::ostream& out = GetOutputStream();
  out << (first ? format("%-26s %9lld %6.0f", (row.kernel + (row.set.empty() ? "" : " " + row.set)).c_str(),
                         static_cast<long long>(row.objects), row.bytes_per_object)
                : format("%-26s %9s %6s", "", "", ""))
      << format("  %-10s %9.3f %8.1f %6.2f ", row.layout.c_str(), ms, counters.at(counter::gb_per_second),
                counters.at(counter::copy_fraction))
      << (aos_ms > 0 ? format("%6.2fx", aos_ms / ms) : format("%7s", "-"));
  if (counters.contains("err_p50")) {
    out << format("  %8.1e %8.1e %8.1e", counters.at("err_p50"), counters.at("err_p99"), counters.at("err_max"));
  }
  out << "\n";
}

}  // namespace physgen::bench
