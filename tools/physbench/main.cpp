// physbench: measures the kernels of the paper, and others, in every layout. See README.md for what the columns mean.
#include <fem/mesh/nearest_name.h>
#include <malloc.h>
#include <physgen/error.h>
#include <physgen/threads.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <limits>
#include <memory>
#include <sstream>

#include "measure/replay.h"
#include "options.h"
#include "report/progress.h"
#include "report/results_file.h"
#include "report/table.h"

namespace physgen::bench {
namespace {

// Memory of a row that is done goes to the next one instead of back to the system, which would have to clear it again:
// without this, a third of the run is page faults.
void keep_memory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
}

// Hands Google Benchmark its flags. @throw Error when it does not know one
void initialize_benchmark(char* program, Options& options) {
  std::vector<char*> arguments{program};
  for (std::string& flag : options.benchmark_flags) arguments.push_back(flag.data());
  arguments.push_back(nullptr);
  int count = static_cast<int>(arguments.size()) - 1;
  benchmark::Initialize(&count, arguments.data());
  if (count > 1) throw Error("there is no flag " + std::string(arguments[1]) + "; physbench --help lists them");
}

// The group's rows. Those of a GPU that is not there are listed, but not run.
std::vector<Row> rows_of_group(const Options& options) {
  std::vector<Row> rows = rows_of(options.group, options.sizes);
  for (const Group& group : registry().groups) {
    if (group.name != options.group || group.also.empty()) continue;
    auto more = rows_of(group.also, options.sizes);
    std::ranges::move(more, std::back_inserter(rows));
  }
  if (!options.list && !device_facts().missing.empty()) {
    std::erase_if(rows, [](const Row& row) { return row.space == "cuda"; });
  }
  return rows;
}

// Names as we write them: what Google Benchmark lists carries its suffix.
void list(std::ostream& out) {
  std::ostringstream names;
  benchmark::ConsoleReporter reporter;
  reporter.SetOutputStream(&names);
  benchmark::RunSpecifiedBenchmarks(&reporter);
  constexpr std::string_view suffix = "/manual_time";
  std::istringstream lines(names.str());
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with(suffix)) line.resize(line.size() - suffix.size());
    out << line << "\n";
  }
}

// Names of rows that the filter matches and this program was built without: in double, and of a GPU, kernels have the
// rows that they have in float on the CPU.
std::vector<std::string> left_out(const Options& options, const std::vector<Row>& rows) {
  std::vector<Row> others;
  for (Row row : rows) {
    if (options.group != "kernels" || row.storage != "float" || row.space != "host" || !row.set.empty()) continue;
    row.storage = "double";
    others.push_back(row);
    if (!registry().device || (row.layout != "aos" && row.layout != "soa")) continue;
    row.space = "cuda";
    row.objects = options.sizes.cuda;
    others.push_back(row);
    row.storage = "float";
    others.push_back(row);
  }
  std::vector<std::string> names;
  for (const Row& row : filtered(std::move(others), options.filter)) {
    const auto is_it = [&row](const Row& other) { return other.name() == row.name(); };
    if (std::ranges::none_of(rows, is_it)) names.push_back(row.name());
  }
  return names;
}

// That no row matched, with the name that the filter may have meant.
void say_none_matched(const Options& options, const std::vector<Row>& rows) {
  if (const std::vector<std::string> others = left_out(options, rows); !others.empty()) {
    std::cerr << "physbench: '" << options.filter << "' matches " << others.front();
    if (others.size() > 1) std::cerr << " and " << others.size() - 1 << " more";
    std::cerr << ", which this program was built without: configure with -DPHYSGEN_BENCHMARK_ALL_ROWS=ON, or write "
                 "tools/dev run --benchmark_filter=..., which builds the CPU's rows that its arguments name\n";
    return;
  }
  std::vector<std::string> names;
  std::ranges::transform(rows, std::back_inserter(names), [](const Row& row) { return row.name(); });
  std::string word = options.filter;
  std::erase_if(word, [](char c) { return std::string_view("^$.*()\\").find(c) != std::string_view::npos; });
  const std::string near = fem::nearest_name(word, names);
  std::cerr << "physbench: no row of the group '" << options.group << "' matches '" << options.filter << "'"
            << (near.empty() ? "" : "; the nearest name is " + near) << "; --benchmark_list_tests lists all\n";
  if (rows.empty())
    std::cerr << "physbench: this program has no rows of that group: tools/dev run builds one that has\n";
  if (!device_facts().missing.empty()) std::cerr << "physbench: " << device_facts().missing << "\n";
}

// Whether a row failed; passes everything on to the reporter of the display.
class Watch final : public benchmark::BenchmarkReporter {
 public:
  explicit Watch(benchmark::BenchmarkReporter& display) : display_(display) {}
  bool ReportContext(const Context& context) override { return display_.ReportContext(context); }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) failed = failed || run.error_occurred;
    display_.ReportRuns(runs);
  }
  void Finalize() override { display_.Finalize(); }
  bool failed = false;

 private:
  benchmark::BenchmarkReporter& display_;
};

int run(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!arguments.empty() && arguments[0] == "replay") {
    std::cout << replay({arguments.begin() + 1, arguments.end()});
    return 0;
  }
  std::string command = argv[0];
  for (const std::string& argument : arguments) command += " " + argument;
  Options options = parse(arguments);
  set_threads(options.threads);
  if (const std::string remark = remark_on_threads(); !remark.empty()) std::cerr << "physbench: " << remark << "\n";
  keep_memory();
  std::cout << options.help << std::flush;
  initialize_benchmark(argv[0], options);

  const std::vector<Row> all = rows_of_group(options);
  std::vector<Row> chosen = filtered(all, options.filter);
  if (options.table) chosen = in_table_order(std::move(chosen));
  Session session(std::move(chosen), find_limits(), options.table);
  session.register_rows();
  if (options.list) {
    list(std::cout);
    return 0;
  }
  if (session.rows().empty()) {
    say_none_matched(options, all);
    return 1;
  }
  const Facts facts = describe_machine(threads(), command);
  for (const auto& [what, value] : facts) benchmark::AddCustomContext(what, value);

  std::unique_ptr<benchmark::BenchmarkReporter> display;
  if (options.table) {
    display = std::make_unique<TableReporter>(session.rows(), facts);
  } else if (options.json) {
    display = std::make_unique<PlainNames<ResultsReporter>>(options.group);
  } else {
    display = std::make_unique<PlainNames<benchmark::ConsoleReporter>>();
  }
  if (options.table) std::cout << announcement(session.rows(), threads()) << std::flush;
  Watch watch(*display);
  PlainNames<ResultsReporter> file(options.group);
  benchmark::RunSpecifiedBenchmarks(&watch, options.to_file ? &file : nullptr);
  return watch.failed ? 1 : 0;
}

}  // namespace
}  // namespace physgen::bench

int main(int argc, char** argv) {
  try {
    return physgen::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "physbench: " << error.what() << "\n";
    return 2;
  }
}
