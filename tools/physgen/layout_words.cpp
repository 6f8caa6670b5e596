// See layout_words.h.
#include "layout_words.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "model/text.h"
#include "model/validate.h"

namespace physgen::command {
namespace {

/// Index of element k of one entry, as the shape's value takes it.
std::string index_in_entry(const Accessor& accessor, int k) {
  const model::Field& field = accessor.field;
  if (accessor.format.quaternion) return {'.', "wxyz"[k]};
  if (field.shape == model::Shape::scalar) return "";
  const model::ShapeFacts& shape = model::facts(field.shape);
  const auto [row, column] = shape.entry(k, field.rows);
  return shape.column ? "[" + std::to_string(row) + "]"
                      : "(" + std::to_string(row) + "," + std::to_string(column) + ")";
}

std::string counted(long long count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// The layout that a word names. @param choices for the error
model::Layout read(const std::string& word, const std::string& choices) {
  for (const model::LayoutFacts& row : model::layouts()) {
    if (!row.tiled && word == row.word) return {row.key, 0};
    const std::string name(row.word), begin = name + "(";
    if (!row.tiled || !word.starts_with(begin) || !word.ends_with(')')) continue;
    const std::string tile = word.substr(begin.size(), word.size() - begin.size() - 1);
    const bool digits = !tile.empty() && tile.size() <= 4 &&
                        std::ranges::all_of(tile, [](unsigned char c) { return std::isdigit(c) != 0; });
    if (digits && std::stoi(tile) >= 2 && model::is_power_of_two_up_to(std::stoi(tile), model::max_tile))
      return {row.key, std::stoi(tile)};
    throw LayoutError("the tile of '" + word + "' is not a power of two from 2 to " + std::to_string(model::max_tile) +
                      "; write '" + model::layout_word({row.key, 16}) + "' or '" + model::layout_word({row.key, 32}) +
                      "'");
  }
  throw LayoutError("there is no layout '" + word + "'; write " + choices);
}

/// The layouts as they are written on a command line, the tile in quotes for the shell.
std::vector<std::string> words_of_layouts() {
  std::vector<std::string> words = model::layout_words("32");
  for (std::string& word : words)
    if (word.ends_with(')')) word.insert(0, 1, '\'').push_back('\'');
  return words;
}

}  // namespace

model::Layout read_layout(const std::string& word) { return read(word, layout_choices()); }

model::Layout read_layout(const std::string& word, model::Space space) {
  const model::Layout standard = model::facts(space).standard;
  if (model::facts(standard.kind).word == word) return standard;
  return read(word, layout_choices_of_a_space());
}

std::string layout_choices() {
  std::vector<std::string> words = words_of_layouts();
  words.emplace_back("all");
  return model::joined(words, " or ");
}

std::string layout_choices_of_a_space() {
  std::vector<std::string> words = words_of_layouts();
  for (const model::LayoutFacts& row : model::layouts())
    if (row.tiled) words.emplace_back(row.word);
  return model::joined(words, " or ");
}

std::string space_choices() {
  std::vector<std::string> words;
  for (const model::SpaceFacts& row : model::spaces()) words.emplace_back(row.word);
  words.emplace_back("both");
  return model::joined(words, " or ");
}

std::string space_words(const LayoutMap& map) {
  std::string words;
  for (const model::Space space : map.spaces) {
    if (!words.empty()) words += " and ";
    words += model::facts(space).word;
  }
  return words;
}

const char* precision_word(Precision precision) { return precision == Precision::with_float ? "float" : "double"; }

std::string format_word(const Accessor& accessor, Precision precision) {
  const model::EncodingFacts& encoding = model::facts(accessor.format.encoding);
  std::string word(encoding.scaling == model::Scaling::interval ? encoding.word : encoding.name);
  if (accessor.format.encoding == model::Encoding::native) word = model::facts(accessor.field.element).name;
  if (word.empty()) word = precision_word(precision);
  return accessor.format.quaternion ? "quaternion(" + word + ")" : word;
}

std::string element_index(const Accessor& accessor, int element) {
  const int in_run = element % accessor.run_elements;
  const int extent = accessor.field.array_extent;
  if (extent == 0) return index_in_entry(accessor, in_run);
  const int entry_elements = accessor.run_elements / extent;
  return "[" + std::to_string(in_run / entry_elements) + "]" + index_in_entry(accessor, in_run % entry_elements);
}

std::string element_name(const Accessor& accessor, int element) {
  return accessor.runs[static_cast<std::size_t>(element / accessor.run_elements)].name +
         element_index(accessor, element);
}

std::string run_name(const Accessor& accessor, int run) {
  std::string name = element_name(accessor, run * accessor.run_elements);
  if (accessor.run_elements == 1) return name;
  const std::string last = element_index(accessor, accessor.run_elements - 1);
  return name + ".." + (last.front() == '.' ? last.substr(1) : last);  // "R.w..z"
}

std::string sectors_words(const Sectors& sectors) {
  const std::string fewest = std::to_string(sectors.fewest);
  return sectors.fewest == sectors.most ? fewest : fewest + "-" + std::to_string(sectors.most);
}

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

double over_ideal(const Accessor& accessor) {
  return static_cast<double>(accessor.sectors.total) / (1.0 * accessor.elements() * accessor.sectors.ideal);
}

double used_per_sector(const Accessor& accessor) { return sector_bytes / over_ideal(accessor); }

std::string record_words(const LayoutMap& map) {
  std::string words = "records of " + counted(map.record_bytes, "byte");
  if (const int padding = map.padding_bytes(); padding > 0)
    words += ", " + std::to_string(padding) + " of them padding";
  if (map.has_tiles())
    words += "; tiles of " + std::to_string(map.pitch) + " objects, " + std::to_string(map.pitch * map.record_bytes) +
             " bytes";
  else if (!map.is_aos())
    words += "; pitch " + std::to_string(map.pitch) + " for " + std::to_string(assumed_objects) + " objects";
  return words;
}

std::string warp_words(const LayoutMap& map) {
  long long total = 0;
  long long ideal = 0;
  for (const Accessor& accessor : map.accessors) {
    total += accessor.sectors.total;
    ideal += 1LL * accessor.elements() * accessor.sectors.ideal;
  }
  return "all " + counted(map.elements(), "request") + ": " + counted(total, "sector") + ", " +
         fixed(static_cast<double>(total) / static_cast<double>(ideal), 2) + "x the ideal " + std::to_string(ideal) +
         "; " + std::to_string(sectors_of_warp(map)) + " different ones";
}

}  // namespace physgen::command
