// physbench: the benchmark of the paper's kernels over every layout. See README.md for what the columns mean.
#include <malloc.h>
#include <omp.h>
#include <physgen/error.h>

#include <algorithm>
#include <deque>
#include <iostream>
#include <iterator>
#include <limits>
#include <sstream>

#include "accuracy/cusolver.h"
#include "accuracy/replay.h"
#include "dataset.h"
#include "groups.h"
#include "kernel_list.h"
#include "table.h"

namespace physgen::bench {
namespace {

// Rows of the Truth Cube.
void add_cube_rows(std::vector<Row>& rows, Dataset& host, [[maybe_unused]] Dataset& cuda) {
  AllKernels::for_each([&]<class Kernel>() { HostKernel<Kernel>::add_rows(rows, host); });
#ifdef PHYSGEN_BENCH_CUDA
  if (find_gpu().missing.empty()) {
    AllKernels::for_each([&]<class Kernel>() { CudaKernel<Kernel>::add_rows(rows, cuda); });
  }
#endif
}

// Rows of the sets of inputs.
void add_set_rows(std::vector<Row>& rows, InputSets& sets) {
  AllVariants::for_each([&]<class Variant>() {
    HostVariant<Variant, float>::add_rows(rows, sets);
    HostVariant<Variant, double>::add_rows(rows, sets);
  });
#ifdef PHYSGEN_BENCH_CUDA
  if (!find_gpu().missing.empty()) return;
  if (cusolver_missing().empty()) add_cusolver_rows(rows, sets);
  AllVariants::for_each([&]<class Variant>() {
    CudaVariant<Variant, float>::add_rows(rows, sets);
    CudaVariant<Variant, double>::add_rows(rows, sets);
  });
#endif
}

// dP from dF over ever more objects, each number with data of its own.
void add_growth_rows(std::vector<Row>& rows, std::deque<Dataset>& sizes) {
  constexpr int smallest = 10, largest = 24, largest_host = 22;
  for (int power = smallest; power <= largest; ++power) {
    Dataset& data = sizes.emplace_back(index_t{1} << power);
    std::vector<Row> all;
    if (power <= largest_host) HostKernel<DpFromDf>::add_rows(all, data);
#ifdef PHYSGEN_BENCH_CUDA
    if (find_gpu().missing.empty()) CudaKernel<DpFromDf>::add_rows(all, data);
#endif
    std::copy_if(all.begin(), all.end(), std::back_inserter(rows),
                 [](const Row& row) { return row.storage == "float" && row.layout != "eigen"; });
  }
}

void add_rows(std::vector<Row>& rows, Group group, Dataset& host, Dataset& cuda, std::deque<Dataset>& sizes) {
  [[maybe_unused]] const bool gpu = find_gpu().missing.empty();
  if (group == Group::storage) add_host_storage_rows(rows, host);
  if (group == Group::conversions) add_host_conversion_rows(rows, host.count(Domain::tets, Domain::tets));
  if (group == Group::gathers) add_host_gather_rows(rows, host);
  if (group == Group::forces) add_host_force_rows(rows, host);
  if (group == Group::growth) add_growth_rows(rows, sizes);
  if (group == Group::reduce) add_host_dot_rows(rows);
#ifdef PHYSGEN_BENCH_CUDA
  if (!gpu) return;
  if (group == Group::storage) add_cuda_storage_rows(rows, cuda);
  if (group == Group::conversions) add_cuda_conversion_rows(rows, cuda.count(Domain::tets, Domain::tets));
  if (group == Group::gathers) add_cuda_gather_rows(rows, cuda);
  if (group == Group::forces) add_cuda_force_rows(rows, cuda);
  if (group == Group::reduce) add_cuda_dot_rows(rows);
#else
  static_cast<void>(cuda);
#endif
}

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
  if (argc > 1 && std::string(argv[1]) == "replay") {
    std::cout << replay({argv + 2, argv + argc});
    return 0;
  }
  std::string command;
  for (int a = 0; a < argc; ++a) command.append(a == 0 ? "" : " ").append(argv[a]);
  Options options = parse(argc, argv);
  omp_set_num_threads(options.threads);
  keep_memory();
  for (const std::string& flag : options.benchmark_flags) {
    if (flag == "--help") std::cout << help_text << std::flush;
  }
  initialize_benchmark(argv[0], options);

  // The mesh on which products with the assembled stiffness are compared: 1,030,301 nodes.
  const bool whole_million = options.group == Group::forces && !options.objects_given;
  Dataset host(options.host_objects), cuda(whole_million ? 6000000 : options.cuda_objects);
  InputSets sets(options.set_objects);
  std::vector<Row> rows;
  std::deque<Dataset> sizes;
  if (options.group == Group::kernels) add_cube_rows(rows, host, cuda);
  if (options.group == Group::kernels || options.group == Group::errors) add_set_rows(rows, sets);
  add_rows(rows, options.group, host, cuda, sizes);
  Session session(std::move(rows), options.table);
  session.register_rows();
  if (options.list) {
    list(std::cout);
    return 0;
  }
  const Machine machine = describe_machine(options, command);
  for (const auto& [what, value] : machine) benchmark::AddCustomContext(what, value);

  std::unique_ptr<benchmark::BenchmarkReporter> display;
  if (options.table) {
    display = std::make_unique<TableReporter>(session.rows(), machine);
  } else if (options.json) {
    display = std::make_unique<PlainNames<benchmark::JSONReporter>>();
  } else {
    display = std::make_unique<PlainNames<benchmark::ConsoleReporter>>();
  }
  Watch watch(*display);
  PlainNames<benchmark::JSONReporter> file;
  const bool to_file = std::any_of(options.benchmark_flags.begin(), options.benchmark_flags.end(),
                                   [](const std::string& flag) { return flag.rfind("--benchmark_out=", 0) == 0; });
  const std::size_t ran = benchmark::RunSpecifiedBenchmarks(&watch, to_file ? &file : nullptr);
  return ran == 0 || watch.failed ? 1 : 0;
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
