// Reads affinity and control groups.
#include "processors.h"

#include <physgen/launch/processors.h>
#include <sched.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace physgen {
namespace {

namespace fs = std::filesystem;

/// The processors that `quota` microseconds in each `period` are.
std::optional<int> processors(double quota, double period) {
  if (!(quota > 0) || !(period > 0)) return {};  // -1 is version 1's word for none
  return static_cast<int>(std::min(std::ceil(quota / period), 1e6));
}

/// What one group allows: version 2 has both numbers in a file, or "max"; version 1 has a file for each.
std::optional<int> quota_of(const fs::path& group, bool version_2) {
  double quota = 0, period = 0;
  if (version_2) {
    if (!(std::ifstream(group / "cpu.max") >> quota >> period)) return {};
  } else if (!(std::ifstream(group / "cpu.cfs_quota_us") >> quota) ||
             !(std::ifstream(group / "cpu.cfs_period_us") >> period)) {
    return {};
  }
  return processors(quota, period);
}

/// The smallest quota of a group and of those around it, as far as they can be seen under `mount`. In a container the
/// path may be that of the machine outside; then its parts do not exist, and `mount` itself is the process's group.
std::optional<int> quota_of_path(const fs::path& mount, const std::string& path, bool version_2) {
  std::optional<int> smallest = quota_of(mount, version_2);
  fs::path group = mount;
  for (const fs::path& part : fs::path(path).relative_path()) {
    group /= part;
    const std::optional<int> found = quota_of(group, version_2);
    if (found && (!smallest || *found < *smallest)) smallest = found;
  }
  return smallest;
}

}  // namespace

std::optional<int> detail::processors_of_quota(const fs::path& root) {
  const fs::path mounts = root / "sys/fs/cgroup";
  std::optional<int> smallest;
  const auto take = [&](std::optional<int> found) {
    if (found && (!smallest || *found < *smallest)) smallest = found;
  };
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {  // number:controllers:path
    const std::size_t first = line.find(':'), second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1), path = line.substr(second + 1);
    if (controllers.empty()) {
      take(quota_of_path(mounts, path, true));
      take(quota_of_path(mounts / "unified", path, true));  // where version 1 has the processors, and 2 the rest
      continue;
    }
    std::istringstream words(controllers);
    for (std::string word; std::getline(words, word, ',');) {
      if (word != "cpu") continue;
      take(quota_of_path(mounts / controllers, path, false));
      take(quota_of_path(mounts / word, path, false));
    }
  }
  return smallest;
}

int detail::processors_of_affinity() {
  // The system refuses a set that is smaller than its own, which may have more processors than cpu_set_t.
  for (std::size_t count = CPU_SETSIZE; count <= std::size_t{1} << 20; count *= 2) {
    std::vector<cpu_set_t> set(CPU_ALLOC_SIZE(count) / sizeof(cpu_set_t) + 1);
    const std::size_t bytes = set.size() * sizeof(cpu_set_t);
    if (sched_getaffinity(0, bytes, set.data()) == 0) return std::max(CPU_COUNT_S(bytes, set.data()), 1);
    if (errno != EINVAL) break;
  }
  return std::max(static_cast<int>(std::thread::hardware_concurrency()), 1);
}

int allowed_processors() {
  const int affinity = detail::processors_of_affinity();
  return std::min(affinity, detail::processors_of_quota("/").value_or(affinity));
}

}  // namespace physgen
