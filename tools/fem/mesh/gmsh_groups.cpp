// In version 4.1 elements belong to entities and these to groups; before, elements belong to groups.
#include <fem/mesh/gmsh_groups.h>
#include <fem/mesh/gmsh_kinds.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

namespace physgen::fem {

namespace {

constexpr int gmsh_line = 1, gmsh_triangle = 2;

// Takes a whole number off the front of a line.
std::optional<std::int64_t> take_number(std::string_view& line) {
  while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
  if (error != std::errc()) return std::nullopt;
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  return number;
}

void require_row(GmshInput& input, std::string_view end, const char* section) {
  const char* place = input.at();
  if (!input.row(end)) input.refuse_at(place, std::string(section) + " has fewer rows than it counts");
}

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

std::uint64_t read_gmsh_names(GmshInput& input, std::string_view end, GmshSections& file) {
  std::string_view line = input.line();
  const char* place = line.data();
  const auto count = take_number(line);
  if (!count || *count < 0) input.refuse_at(place, "$PhysicalNames must begin with the number of names");
  for (std::int64_t k = 0; k < *count; ++k) {
    line = input.line();
    place = line.data();
    if (line.empty() || line == end) input.refuse_at(place, "$PhysicalNames has fewer rows than it counts");
    const auto dimension = take_number(line), number = take_number(line);
    const auto quote = line.find('"');
    if (!dimension || !number || quote == line.npos || line.size() < quote + 3 || line.back() != '"') {
      input.refuse_at(place,
                      "a row of $PhysicalNames is a dimension, a number and a name in quotes, as in 2 7 \"top\"");
    }
    line = line.substr(quote + 1);
    file.names.push_back({static_cast<int>(*dimension), *number, std::string(line.substr(0, line.size() - 1))});
  }
  return static_cast<std::uint64_t>(*count);
}

std::uint64_t read_gmsh_entities(GmshInput& input, std::string_view end, GmshSections& file) {
  constexpr const char* section = "$Entities";
  if (!input.is_binary) require_row(input, end, section);
  std::array<std::uint64_t, 4> counts{};
  for (std::uint64_t& count : counts) count = input.natural<std::uint64_t>();
  input.end_row();
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::uint64_t left = counts.at(static_cast<std::size_t>(dimension)); left > 0; --left) {
      require_row(input, end, section);
      GmshSections::Entity entity{dimension, input.integer(), {}};
      for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) input.real();  // its place, or its box
      for (auto groups = input.natural<std::uint64_t>(); groups > 0; --groups) {
        const std::int64_t group = input.integer();
        entity.groups.push_back(group < 0 ? -group : group);  // the sign is its sense
      }
      if (dimension > 0) {
        for (auto sides = input.natural<std::uint64_t>(); sides > 0; --sides) input.integer();
      }
      input.end_row();
      if (!entity.groups.empty()) file.entities.push_back(std::move(entity));
    }
  }
  return 1 + counts[0] + counts[1] + counts[2] + counts[3];
}

std::vector<GmshGroup> gmsh_groups_of(const GmshSections& file) {
  std::vector<GmshGroup> groups;
  for (const GmshSections::Name& name : file.names) {
    auto group = std::ranges::find(groups, name.name, &GmshGroup::name);
    if (group == groups.end()) group = groups.insert(groups.end(), GmshGroup{name.name, {}, {}, {}, {}});
    std::vector<std::int64_t> owners;
    if (file.version < 4) owners.push_back(name.number);
    for (const GmshSections::Entity& entity : file.entities) {
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
