// Formatting of the table of error against speed.
#include "report/errors_table.h"

#include "report/format.h"
#include "report/session.h"

namespace physgen::bench {

namespace {

// Three digits, in the width of a column.
std::string error(const Finished& finished, const std::string& name) {
  const auto found = finished.counters.find(name);
  if (found == finished.counters.end()) return format("%8s", "-");
  const double value = found->second;
  return value < 9999.5 ? format("%8.*f", value < 99.5 ? 2 : 0, value) : format("%8.1e", value);
}

void print_row(std::ostream& out, const Row& row, const Finished& finished, bool first) {
  const auto counter = [&finished](const char* name) { return finished.counters.at(name); };
  const double ms = counter(counter::median_ms);
  out << (first ? format("%-26s %-8s %5.0f", row.kernel.c_str(), row.layout.c_str(), counter(counter::bytes_per_object))
                : format("%-26s %-8s %5s", "", "", ""))
      << format("  %-9s %9.3f %8.1f", row.set.c_str(), ms, static_cast<double>(row.objects) / ms * 1e-3)
      << over_cache(finished.counters) << format(" %6.2f ", counter(counter::copy_fraction));
  for (const char* part : {counter::p50, counter::p99, counter::p9999, counter::max}) {
    out << error(finished, std::string(counter::err_eps) + part);
  }
  out << " ";
  for (const char* part : {counter::p99, counter::max}) out << error(finished, std::string(counter::orth_eps) + part);
  out << format("%10.0f\n", counter(counter::failures));
}

bool print_block(std::ostream& out, const std::vector<Row>& rows, const std::map<std::string, Finished>& finished,
                 const std::string& space, const std::string& storage) {
  bool any = false;
  std::string last;
  for (const Row& row : rows) {
    const auto found = finished.find(row.name());
    if (!row.errors_in_eps || row.space != space || row.storage != storage || found == finished.end()) continue;
    if (!any) {
      out << (space == "host" ? "CPU, " : "GPU, ") << storage << ", " << row.objects
          << " objects: error against speed, "
          << "errors in eps\n"
          << format("%-26s %-8s %5s  %-9s %9s %8s %6s %6s %8s%8s%8s%8s %8s%8s%10s\n", "kernel", "layout", "bytes",
                    "set", "ms", "M/s", "/LLC", "/copy", "p50", "p99", "p99.99", "max", "U,V p99", "max", "failures");
    }
    any = true;
    print_row(out, row, found->second, row.kernel + row.layout != last);
    last = row.kernel + row.layout;
  }
  if (any) out << "\n";
  return any;
}

}  // namespace

void print_errors_table(std::ostream& out, const std::vector<Row>& rows,
                        const std::map<std::string, Finished>& finished) {
  bool any = false;
  for (const char* space : {"host", "cuda"}) {
    for (const char* storage : {"float", "double"}) any = print_block(out, rows, finished, space, storage) || any;
  }
  if (!any) return;
  out << "Worst inputs\n";
  for (const Row& row : rows) {
    const auto found = finished.find(row.name());
    if (!row.errors_in_eps || found == finished.end()) continue;
    out << row.name() << ", error " << error(found->second, std::string(counter::err_eps) + counter::max) << " eps:\n  "
        << found->second.label << "\n";
  }
  out << "\n";
}

}  // namespace physgen::bench
