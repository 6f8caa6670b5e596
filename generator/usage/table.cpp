// See table.h.
#include "usage/table.h"

#include <algorithm>
#include <array>
#include <vector>

namespace physgen::usage {
namespace {

constexpr std::size_t columns = 4;
using Row = std::array<std::string, columns>;

/// "force_differential.h:27:53, :34:55": the file's name once.
std::string text_of(const FieldUse& use) {
  std::string result, file;
  for (const Place& place : use.places) {
    const std::string text = short_text(place);
    if (!result.empty()) result += ", ";
    result += place.file == file ? text.substr(text.find(':')) : text;
    file = place.file;
    if (std::ranges::find(use.whole_places, place) != use.whole_places.end()) result += " (all fields)";
  }
  return result;
}

Row row_of(const FieldUse& use) {
  std::string access = use.read ? "R" : " ";
  access += use.written ? "W" : " ";
  access += use.address_taken ? "&" : " ";
  return {use.array, use.field, access, text_of(use)};
}

std::string rows(const std::vector<FieldUse>& uses) {
  std::vector<Row> rows = {{"array", "field", "RW&", "places"}};
  for (const FieldUse& use : uses) rows.push_back(row_of(use));
  std::array<std::size_t, columns> widths{};
  for (const Row& row : rows)
    for (std::size_t c = 0; c < columns; ++c) widths[c] = std::max(widths[c], row[c].size());
  std::string text;
  for (const Row& row : rows) {
    std::string line = "   ";
    for (std::size_t c = 0; c < columns; ++c) {
      line += ' ' + row[c];
      line.append(widths[c] - row[c].size() + 1, ' ');
    }
    text += line.erase(line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

}  // namespace

std::string table(const Program& program) {
  std::string text = program.name + "\n";
  for (const StepUse& step : program.usage.steps) {
    text += "\n  " + name_of(step) + (step.place == Place{} ? "" : "  " + usage::text_of(step.place));
    text += step.root ? "  (always wanted)\n" : "\n";
    text += step.fields.empty() ? "    no field of an array\n" : rows(step.fields);
  }
  if (!program.usage.unattributed.empty())
    text += "\n  outside of all steps (always wanted)\n" + rows(program.usage.unattributed);
  if (!program.usage.unknown.empty()) text += "\n  in ways that cannot be followed\n";
  for (const UnknownUse& use : program.usage.unknown)
    text += "    " + use.array + "  " + use.what + "  " + short_text(use.place) + '\n';
  return text + "\n  all of " + program.name + "\n" + rows(all_fields(program.usage));
}

}  // namespace physgen::usage
