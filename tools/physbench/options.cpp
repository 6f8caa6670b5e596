// Reads the command line.
#include "options.h"

#include <fem/mesh/nearest_name.h>
#include <physgen/error.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <regex>

namespace physgen::bench {

namespace {

constexpr const char* about =
    R"(Measures the kernels of tools/fem in every layout, storage and space. Without --benchmark_filter it runs the rows
of the group and prints a table (of the group kernels: dP from dF, the stress derivative and the SVD in float; with --all
every kernel in float, and three in double). With a filter it runs the rows that match and prints the lines of Google
Benchmark. A row is named
kernel/layout/storage/space/objects; the name of a row of a set of inputs, or of a numbered mesh, ends with that of the
set or the numbering.

physbench replay KERNEL STORAGE NUMBERS... runs a kernel on one input everywhere, and prints the results, the
reference and the errors; numbers are decimal, hexadecimal, nan or inf: replay svd float 1 0 0 0 0x1.8p+0 0 0 0 1)";

constexpr const char* exit_status =
    "Exit status: 0 done, 1 a row failed or none matched, 2 wrong use. The flags of Google Benchmark:\n";

index_t number(const std::string& flag, const std::string& text, index_t largest) {
  index_t value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size() || value < 1 || value > largest) {
    throw Error(flag + " takes a number from 1 to " + std::to_string(largest) + ", not '" + text + "'");
  }
  return value;
}

std::string group_help() {
  std::string text = "A group selects its rows:";
  for (const Group& group : registry().groups) {
    std::string help = group.help;
    for (std::size_t at = 0; (at = help.find('\n', at)) != std::string::npos; at += 18) {
      help.replace(at, 1, "\n" + std::string(17, ' '));
    }
    text += "\n  " + group.name + std::string(15 - std::min<std::size_t>(14, group.name.size()), ' ') + help;
  }
  return text;
}

const Group& find_group(const std::string& name) {
  const auto& groups = registry().groups;
  const auto found = std::ranges::find(groups, name, &Group::name);
  if (found != groups.end()) return *found;
  std::vector<std::string> names;
  std::ranges::transform(groups, std::back_inserter(names), &Group::name);
  const std::string near = fem::nearest_name(name, names);
  throw Error("there is no group '" + name + "'" + (near.empty() ? ";" : "; did you mean '" + near + "'?") +
              " physbench --help lists them");
}

}  // namespace

std::vector<Row> filtered(std::vector<Row> rows, const std::string& filter) try {
  const bool excludes = filter.starts_with('-');
  const std::regex names(filter.substr(excludes ? 1 : 0));
  std::erase_if(rows, [&](const Row& row) { return std::regex_search(row.name(), names) == excludes; });
  return rows;
} catch (const std::regex_error& error) {
  throw Error("--benchmark_filter=" + filter + " is not a regular expression (" + error.what() +
              "); write a backslash before brackets and dots");
}

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  bool help = false, all = false;
  std::string json;
  CLI::App app(about, "physbench");
  app.set_help_flag();
  app.allow_extras();
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.footer(exit_status);
  app.add_option("GROUP", options.group, group_help());
  const auto on_number = [&app](const std::string& flag, index_t largest, const std::string& text, auto store) {
    app.add_option_function<std::string>(
           flag, [flag, largest, store](const std::string& word) { store(number(flag, word, largest)); }, text)
        ->type_name("N");
  };
  on_number("--threads", 4096,
            "threads of the CPU's rows (default: OMP_NUM_THREADS, or one for each processor that it may use)",
            [&](index_t n) { options.threads = static_cast<int>(n); });
  on_number("--objects", 100000000,
            "number of tets (default: 1048576 on the CPU and for sets, 8388608 on the GPU); kernels over nodes and "
            "edges run over all of the smallest cube with at least N tets",
            [&](index_t n) { options.sizes = {n, n, n, true}; });
  app.add_flag("--all", all, "run all rows of the group, not only the three kernels in float that are the default");
  app.add_flag("--table", options.table, "print the table in any case");
  app.add_option("--json", json, "also write all results and the machine to FILE; short for --benchmark_out=FILE")
      ->type_name("FILE");
  app.add_option("--benchmark_filter", options.filter, "the rows to run, as a regular expression")->type_name("REGEX");
  app.add_flag("--help", help, "this text");
  std::vector<std::pair<std::string, CLI::App*>> own;  // flags that one group has
  for (const Group& group : registry().groups) {
    if (!group.add_flags) continue;
    own.emplace_back(group.name, app.add_option_group("Flags of the group " + group.name));
    group.add_flags(*own.back().second);
  }
  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // as CLI11 wants them
    app.parse(std::move(reversed));
  } catch (const CLI::ParseError& error) {
    throw Error(std::string(error.what()) + "; physbench --help lists the flags");
  }

  bool min_time = false;
  for (const std::string& flag : app.remaining()) {
    if (!flag.starts_with("--benchmark_") && !flag.starts_with("--v=")) {
      std::vector<std::string> flags{"--threads", "--objects", "--all", "--table", "--json"};
      for (const auto& [name, group] : own) {
        for (const CLI::Option* option : group->get_options()) flags.push_back("--" + option->get_lnames().front());
      }
      const std::string near = fem::nearest_name(flag.substr(0, flag.find('=')), flags);
      throw Error("there is no flag " + flag + (near.empty() ? ";" : "; did you mean " + near + "?") +
                  " physbench --help lists them");
    }
    min_time = min_time || flag.starts_with("--benchmark_min_time");
    options.list = options.list || (flag.starts_with("--benchmark_list_tests") && !flag.ends_with("=false"));
    options.json = options.json || flag == "--benchmark_format=json" || flag == "--benchmark_format=csv";
    options.to_file = options.to_file || flag.starts_with("--benchmark_out=");
    options.benchmark_flags.push_back(flag);
  }
  const Group& group = find_group(options.group);
  for (const auto& [name, flags] : own) {
    if (name == options.group) continue;
    for (const CLI::Option* option : flags->get_options()) {
      if (option->count() == 0) continue;
      throw Error(option->get_name() + " is a flag of the group " + name + ": write physbench " + name + " " +
                  option->get_name());
    }
  }
  options.filtered = !options.filter.empty();
  if (options.filtered && all) throw Error("--all cannot be combined with --benchmark_filter; remove one of them");
  if (!options.filtered) options.filter = options.list ? "" : all || group.first.empty() ? group.filter : group.first;
  if (!json.empty()) options.benchmark_flags.push_back("--benchmark_out=" + json), options.to_file = true;
  if (!min_time) options.benchmark_flags.emplace_back("--benchmark_min_time=0.06");
  if (help) options.help = app.help(), options.benchmark_flags.emplace_back("--help");
  options.table =
      options.table || ((options.group == "errors" || !options.filtered) && !(options.json || options.list));
  return options;
}

}  // namespace physgen::bench
