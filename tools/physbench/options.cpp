// Reads the command line.
#include "options.h"

#include <omp.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace physgen::bench {

const char* const help_text = R"(physbench [GROUP] [FLAGS]
physbench replay KERNEL STORAGE NUMBERS...

Measures the kernels of tools/fem in every layout, storage and space. Without --benchmark_filter, runs all rows of the
Truth Cube in float and the paper's three kernels in double, and prints a table; with one, runs what it says (all:
--benchmark_filter=.) and prints what Google Benchmark prints. Names are kernel/layout/storage/space/objects, and those of
the sets of inputs end with /random, /near_rest or /hard.

GROUP is one of these, each with its own rows, all of which are run where no filter is given:
  errors         rows of the sets only, and the table of error against speed (the worst input of each at its end)
  storage        dP from dF in every storage scheme: speed against error
  conversions    copies between layouts and formats, and between host and device
  gathers        nodes gathered under an ordered, a random and a renumbered mesh, in every layout of the nodes
  forces         the product with the assembled stiffness: by gathers, by its symmetric half, by cuSPARSE
  growth         dP from dF from 2^10 to 2^24 objects (to 2^22 on the CPU)
  reduce         dot products of 2^18 to 2^24 vectors (to 2^22 on the CPU), beside a pass that only reads as much
and
  replay         runs a kernel on one input everywhere, and prints the results, the reference and the errors; numbers
                 are decimal, hexadecimal, nan or inf: replay svd float 1 0 0 0 0x1.8p+0 0 0 0 1

  --threads=N    OpenMP threads of the CPU's rows (default: all)
  --objects=N    tets (default: 1048576 on the CPU and for sets, 8388608 on the GPU); kernels over nodes and edges run
                 over all of the smallest cube with at least N tets
  --table        print the table in any case
  --json=FILE    also write all results and the machine to FILE; short for --benchmark_out=FILE
  --help         this text

Exit status: 0 done, 1 a row failed or none matched, 2 wrong use. The flags of Google Benchmark:

)";

namespace {

constexpr std::array<std::pair<std::string_view, Group>, 7> groups{{{"errors", Group::errors},
                                                                    {"storage", Group::storage},
                                                                    {"conversions", Group::conversions},
                                                                    {"gathers", Group::gathers},
                                                                    {"forces", Group::forces},
                                                                    {"growth", Group::growth},
                                                                    {"reduce", Group::reduce}}};

index_t number(std::string_view flag, std::string_view text, index_t largest) {
  index_t value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size() || value < 1 || value > largest) {
    throw Error(std::string(flag) + " takes a number from 1 to " + std::to_string(largest) + ", not '" +
                std::string(text) + "'");
  }
  return value;
}

// Of our names the suffix that Google Benchmark appends is no part, so a filter may end with the name's end.
std::string benchmark_flag(std::string argument) {
  constexpr std::string_view filter = "--benchmark_filter=";
  if (argument.rfind(filter, 0) == 0 && argument.back() == '$') {
    argument.pop_back();
    argument += "(/manual_time)?$";
  }
  return argument;
}

}  // namespace

Options parse(int argc, const char* const* argv) {
  Options options;
  bool filtered = false, min_time = false;
  for (int a = 1; a < argc; ++a) {
    const std::string argument = argv[a];
    if (a == 1) {
      const auto found = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == argument; });
      if (found != groups.end()) {
        options.group = found->second;
        continue;
      }
    }
    const std::size_t equals = argument.find('=');
    const std::string flag = argument.substr(0, equals);
    const auto value = [&] {
      if (equals != std::string::npos) return argument.substr(equals + 1);
      if (a + 1 == argc) throw Error(flag + " needs a value: " + flag + "=VALUE");
      return std::string(argv[++a]);
    };
    if (flag == "--threads") {
      options.threads = static_cast<int>(number(flag, value(), 4096));
    } else if (flag == "--objects") {
      options.host_objects = options.cuda_objects = options.set_objects = number(flag, value(), 100000000);
      options.objects_given = true;
    } else if (flag == "--json") {
      options.benchmark_flags.push_back("--benchmark_out=" + value());
    } else if (argument == "--table") {
      options.table = true;
    } else if (argument == "--help" || flag.rfind("--benchmark_", 0) == 0 || flag == "--v") {
      filtered = filtered || flag == "--benchmark_filter";
      min_time = min_time || flag == "--benchmark_min_time";
      options.list = options.list || (flag == "--benchmark_list_tests" && argument.find("=false") == std::string::npos);
      options.json = options.json || argument == "--benchmark_format=json" || argument == "--benchmark_format=csv";
      options.benchmark_flags.push_back(benchmark_flag(argument));
    } else {
      throw Error("there is no flag " + argument + "; physbench --help lists them");
    }
  }
  if (!filtered && !options.list) {
    // Names of the Truth Cube end with the number of objects; other groups have no others than their own.
    options.benchmark_flags.push_back(benchmark_flag(
        options.group != Group::kernels
            ? "--benchmark_filter=."
            : "--benchmark_filter=(/float/|^(dp_from_df|stress_derivative|add_force_differential)/).*[0-9]$"));
  }
  if (!min_time) options.benchmark_flags.emplace_back("--benchmark_min_time=0.06");
  options.table = options.table || ((options.group == Group::errors || !filtered) && !(options.json || options.list));
  if (options.threads == 0) options.threads = omp_get_max_threads();
  return options;
}

}  // namespace physgen::bench
