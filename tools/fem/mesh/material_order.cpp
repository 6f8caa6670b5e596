#include <fem/mesh/material_order.h>
#include <physgen/error.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace physgen::fem {

std::vector<Index> sort_by_material(ReadMesh& mesh, std::span<const std::string> groups) {
  const auto at = [](Index t) { return static_cast<std::size_t>(t); };
  std::vector<std::size_t> materials(mesh.tets.size(), 0);  // per tet: 0, or 1 + its group
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const MeshGroup& group = group_named(mesh.groups, groups[g]);
    if (group.tets.empty()) {
      throw Error("group '" + group.name + "' has no tets, and a material needs them; take a group of a volume");
    }
    for (const Index t : group.tets) {
      if (const std::size_t other = materials[at(t)]; other != 0) {
        throw Error("element " + std::to_string(mesh.tet_tags.empty() ? at(t) : mesh.tet_tags[at(t)]) +
                    " is in the groups '" + groups[other - 1] + "' and '" + group.name +
                    "', which have materials; give each tet one");
      }
      materials[at(t)] = g + 1;
    }
  }
  std::vector<Index> order(mesh.tets.size()), place(order.size()), ends(groups.size() + 1, 0);
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, {}, [&](Index t) { return materials[at(t)]; });
  const ReadMesh before = mesh;
  for (std::size_t t = 0; t < order.size(); ++t) {
    place[at(order[t])] = static_cast<Index>(t);
    mesh.tets[t] = before.tets[at(order[t])];
    if (!mesh.tet_tags.empty()) mesh.tet_tags[t] = before.tet_tags[at(order[t])];
    ++ends[materials[t]];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  for (MeshGroup& group : mesh.groups) {
    for (Index& t : group.tets) t = place[at(t)];
    std::ranges::sort(group.tets);
  }
  return ends;
}

}  // namespace physgen::fem
