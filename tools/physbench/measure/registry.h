// The parts that this program was linked from: groups of rows, the files that add rows to them, and the ways to replay
// a kernel. A file makes itself known by a static variable, so that neither main() nor the options know any.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "measure/row.h"

namespace CLI {
class App;
}

namespace physgen::bench {

/// The numbers of objects that rows have.
struct Sizes {
  index_t host = 1048576;  ///< tets of the CPU's rows
  index_t cuda = 8388608;  ///< tets of the GPU's rows
  index_t sets = 1048576;  ///< objects of the rows of sets, on both
  bool given = false;      ///< by the user
};

/// A first word of the command line.
struct Group {
  std::string name;          ///< "kernels" is what there is without a word
  std::string help;          ///< one line, or several
  int place;                 ///< in the list of groups
  std::string filter = ".";  ///< which rows run with --all
  std::string first = {};    ///< which run where the user asks for nothing else; empty: all. NOLINT: g++ wants it said
  std::string also = {};     ///< the group whose rows belong to this one, too. NOLINT: g++ wants it said
  std::function<void(CLI::App&)> add_flags = {};  ///< those of this group alone. NOLINT: as above
};

/// The rows that one file adds to a group.
struct Part {
  std::string group;
  int place;         ///< among the parts of the group
  std::string what;  ///< the kernel, where it is one
  std::string space;
  std::function<void(std::vector<Row>&, const Sizes&)> add;
};

/// A way to run a kernel on one input. @see measure/replay.h
struct ReplayWay {
  std::string kernel, storage;
  int place;
  std::function<std::string(const std::vector<std::string>& words)> run;
};

/// A machine's device, described by the file that can ask it.
struct DeviceFacts {
  std::string name, missing;     ///< missing: why its rows cannot run; empty if they can
  double memory = 0, cache = 0;  ///< [bytes], the last-level cache
};

/// Each is sorted by place.
struct Registry {
  std::vector<Group> groups;
  std::vector<Part> parts;
  std::vector<ReplayWay> replays;
  std::function<DeviceFacts()> device;  ///< empty: this program has no rows of a GPU
  /// A vendor's library: its name, and why its rows are left out, or nothing.
  std::vector<std::pair<std::string, std::function<std::string()>>> libraries;
};
Registry& registry();

/// For static variables: `const bool registered = add(Group{...});`
bool add(Group group);
bool add(Part part);
bool add(ReplayWay way);
bool add_device(std::function<DeviceFacts()> facts);
bool add_library(std::string name, std::function<std::string()> missing);

/// All rows of a group; those of a GPU whether or not there is one.
[[nodiscard]] std::vector<Row> rows_of(const std::string& group, const Sizes& sizes);
/// Rows of one kernel in one space, for groups that set others beside them.
/// @param wanted such as "float/aos"; all rows where there is none
[[nodiscard]] std::vector<Row> rows_of_kernel(const std::string& kernel, const std::string& space, const Sizes& sizes,
                                              const std::vector<std::string>& wanted = {});

/// The device, once asked.
[[nodiscard]] const DeviceFacts& device_facts();

}  // namespace physgen::bench
