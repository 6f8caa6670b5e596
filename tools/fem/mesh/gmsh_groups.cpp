// In version 4.1 elements belong to entities and these to groups; before, elements belong to groups.
#include <fem/mesh/gmsh_groups.h>
#include <fem/mesh/gmsh_kinds.h>

#include <algorithm>
#include <optional>

namespace physgen::fem {

namespace {

constexpr int gmsh_line = 1, gmsh_triangle = 2;

const GmshKind& kind_of(const GmshSections::Run& run) {
  return *std::ranges::find(gmsh_kinds, run.type, &GmshKind::type);
}

void add(const GmshSections& file, const GmshSections::Run& run, GmshGroup& group) {
  if (run.type == gmsh_tet) {
    const auto first = file.tet_tags.begin() + static_cast<std::ptrdiff_t>(run.first);
    group.tets.insert(group.tets.end(), first, first + static_cast<std::ptrdiff_t>(run.count));
    return;
  }
  const std::size_t corners = kind_of(run).nodes;
  for (std::size_t e = 0; e < run.count; ++e) {
    const auto node = [&](std::size_t c) { return file.others[run.first + e * corners + c].node; };
    if (run.type == gmsh_line) {
      group.lines.push_back({node(0), node(1)});
    } else if (run.type == gmsh_triangle) {
      group.faces.push_back({node(0), node(1), node(2)});
    } else {
      for (std::size_t c = 0; c < corners; ++c) group.nodes.push_back(node(c));
    }
  }
}

// The number under which a tag stands; nothing for one that the mesh has not.
std::optional<Index> number_of(std::span<const std::size_t> tags, std::uint64_t tag) {
  const auto found = std::ranges::lower_bound(tags, tag);
  if (found == tags.end() || *found != tag) return std::nullopt;
  return static_cast<Index>(found - tags.begin());
}

template <std::size_t corners>
void number_each(std::span<const std::size_t> tags, const std::vector<std::array<std::uint64_t, corners>>& elements,
                 std::vector<std::array<Index, corners>>& to) {
  for (const auto& element : elements) {
    std::array<Index, corners> numbers{};
    bool all = true;
    for (std::size_t c = 0; c < corners; ++c) {
      const auto number = number_of(tags, element[c]);
      all = all && number.has_value();
      numbers[c] = number.value_or(0);
    }
    if (all) to.push_back(numbers);
  }
}

}  // namespace

std::vector<GmshGroup> gmsh_groups_of(const GmshSections& file) {
  std::vector<GmshGroup> groups;
  for (const GmshName& name : file.names) {
    auto group = std::ranges::find(groups, name.name, &GmshGroup::name);
    if (group == groups.end()) group = groups.insert(groups.end(), GmshGroup{name.name, {}, {}, {}, {}});
    std::vector<std::int64_t> owners;
    if (file.version < 4) owners.push_back(name.number);
    for (const GmshEntity& entity : file.entities) {
      const bool belongs = std::ranges::find(entity.groups, name.number) != entity.groups.end();
      if (belongs && entity.dimension == name.dimension) owners.push_back(entity.tag);
    }
    std::ranges::sort(owners);
    for (const GmshSections::Run& run : file.runs) {
      if (run.dimension == name.dimension && std::ranges::binary_search(owners, run.owner)) add(file, run, *group);
    }
  }
  return groups;
}

std::vector<MeshGroup> number_groups(const std::vector<GmshGroup>& groups, std::span<const std::size_t> node_tags,
                                     std::span<const std::size_t> tet_tags,
                                     std::span<const std::array<Index, 4>> tets) {
  std::vector<MeshGroup> numbered;
  for (const GmshGroup& group : groups) {
    MeshGroup& made = numbered.emplace_back();
    made.name = group.name;
    for (const std::uint64_t node : group.nodes) {
      if (const auto number = number_of(node_tags, node)) made.nodes.push_back(*number);
    }
    number_each(node_tags, group.lines, made.lines);
    number_each(node_tags, group.faces, made.faces);
    for (const std::uint64_t tet : group.tets) {
      if (const auto number = number_of(tet_tags, tet)) made.tets.push_back(*number);
    }
    complete(made, tets);
  }
  return numbered;
}

}  // namespace physgen::fem
