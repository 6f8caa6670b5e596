// Names are text in binary files, too; entities are not.
#include <fem/mesh/gmsh_names.h>

#include <array>
#include <charconv>
#include <optional>
#include <utility>

namespace physgen::fem {

namespace {

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

}  // namespace

std::uint64_t read_gmsh_names(GmshInput& input, std::string_view end, std::vector<GmshName>& to) {
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
    to.push_back({static_cast<int>(*dimension), *number, std::string(line.substr(0, line.size() - 1))});
  }
  return static_cast<std::uint64_t>(*count);
}

std::uint64_t read_gmsh_entities(GmshInput& input, std::string_view end, std::vector<GmshEntity>& to) {
  constexpr const char* section = "$Entities";
  if (!input.is_binary) require_row(input, end, section);
  std::array<std::uint64_t, 4> counts{};
  for (std::uint64_t& count : counts) count = input.natural<std::uint64_t>();
  input.end_row();
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::uint64_t left = counts.at(static_cast<std::size_t>(dimension)); left > 0; --left) {
      require_row(input, end, section);
      GmshEntity entity{dimension, input.integer(), {}};
      for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) input.real();  // its place, or its box
      for (auto groups = input.natural<std::uint64_t>(); groups > 0; --groups) {
        const std::int64_t group = input.integer();
        entity.groups.push_back(group < 0 ? -group : group);  // the sign is its sense
      }
      if (dimension > 0) {
        for (auto sides = input.natural<std::uint64_t>(); sides > 0; --sides) input.integer();
      }
      input.end_row();
      if (!entity.groups.empty()) to.push_back(std::move(entity));
    }
  }
  return 1 + counts[0] + counts[1] + counts[2] + counts[3];
}

}  // namespace physgen::fem
