// Keeps what files have registered in the order of their places.
#include "measure/registry.h"

#include <algorithm>

namespace physgen::bench {

namespace {

template <class T>
bool insert(std::vector<T>& all, T one) {
  const auto after = [](const T& a, const T& b) { return a.place < b.place; };
  all.insert(std::upper_bound(all.begin(), all.end(), one, after), std::move(one));
  return true;
}

}  // namespace

Registry& registry() {
  static Registry all;  // made by the first file that registers
  return all;
}

bool add(Group group) { return insert(registry().groups, std::move(group)); }
bool add(Part part) { return insert(registry().parts, std::move(part)); }
bool add(ReplayWay way) { return insert(registry().replays, std::move(way)); }
bool add_device(std::function<DeviceFacts()> facts) {
  registry().device = std::move(facts);
  return true;
}
bool add_library(std::string name, std::function<std::string()> missing) {
  registry().libraries.emplace_back(std::move(name), std::move(missing));
  return true;
}

std::vector<Row> rows_of(const std::string& group, const Sizes& sizes) {
  std::vector<Row> rows;
  for (const char* space : {"host", "cuda"}) {
    for (const Part& part : registry().parts) {
      if (part.group == group && part.space == space) part.add(rows, sizes);
    }
  }
  return rows;
}

std::vector<Row> rows_of_kernel(const std::string& kernel, const std::string& space, const Sizes& sizes,
                                const std::vector<std::string>& wanted) {
  std::vector<Row> rows;
  for (const Part& part : registry().parts) {
    if (part.group == "kernels" && part.what == kernel && part.space == space) part.add(rows, sizes);
  }
  if (!wanted.empty()) {
    std::erase_if(rows, [&wanted](const Row& row) {
      return std::ranges::find(wanted, row.storage + "/" + row.layout) == wanted.end();
    });
  }
  return rows;
}

const DeviceFacts& device_facts() {
  static const DeviceFacts facts = [] {
    if (registry().device) return registry().device();
    DeviceFacts none;
    none.missing = "this program has no rows of the GPU: the preset `cuda` has (tools/dev gpu)";
    return none;
  }();
  return facts;
}

}  // namespace physgen::bench
