// See kernel_hashes.h.
#include "report/kernel_hashes.h"

#include <map>
#include <sstream>
#include <vector>

namespace physgen::bench {
namespace {

std::map<std::string, std::string>& hashes() {
  static std::map<std::string, std::string> hashes;
  return hashes;
}

}  // namespace

bool add_kernel_hashes(const std::string& lines) {
  std::istringstream in(lines);
  for (std::string key, hash; in >> key >> hash;) hashes()[key] = hash;
  return true;
}

std::string kernels_of(const std::string& group, const std::string& row) {
  std::vector<std::string> parts;  // kernel/layout/storage/space/objects[/set]
  std::istringstream in(row);
  for (std::string part; std::getline(in, part, '/');) parts.push_back(part);
  if (parts.size() < 5) return "";
  const std::string &kernel = parts[0], &storage = parts[2], &space = parts[3];
  std::string of_kernel = std::string(parts.size() > 5 ? "set/" : "scene/").append(space + "/" + kernel);
  if (hashes().contains(of_kernel + "/" + storage)) of_kernel += "/" + storage;  // which has a file of its own
  std::string found;
  for (const std::string& key : {std::string(group).append("/" + space), of_kernel})
    if (const auto at = hashes().find(key); at != hashes().end())
      found += (found.empty() ? "" : ", ") + key + " " + at->second;
  return found;
}

}  // namespace physgen::bench
