// Chooses the arrays that `physgen layout` draws. See layout_request.h.
#include "layout_request.h"

#include <algorithm>
#include <cctype>

#include "model/limits.h"
#include "model/text.h"

namespace physgen::command {
namespace {

using model::Space;
using plan::LayoutMap;
using plan::Precision;

/// The layout that a word names in a space. @param choices for the error
model::Layout read(const std::string& word, Space space, const std::string& choices) {
  for (const model::LayoutFacts& row : model::layouts()) {
    if (word == row.word) return {row.key, row.tiled ? model::facts(space).standard.tile : 0};
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

/// The layouts as they are written on a command line: with a tile, in quotes for the shell, and without one.
std::vector<std::string> words_of_layouts() {
  std::vector<std::string> words = model::layout_words("32");
  for (std::string& word : words)
    if (word.ends_with(')')) word.insert(0, 1, '\'').push_back('\'');
  for (const model::LayoutFacts& row : model::layouts())
    if (row.tiled) words.emplace_back(row.word);
  return words;
}

std::vector<Space> spaces_of(const std::string& word) {
  std::vector<Space> all;
  for (const model::SpaceFacts& row : model::spaces()) {
    if (word == row.word) return {row.key};
    all.push_back(row.key);
  }
  if (word == "both") return all;
  throw LayoutError("there is no space '" + word + "'; write " + space_choices());
}

Precision precision_of(const std::string& word) {
  if (word == "float") return Precision::with_float;
  if (word == "double") return Precision::with_double;
  throw LayoutError("Real cannot be '" + word + "'; write float or double");
}

std::vector<const model::Object*> objects_of(const model::Schema& schema, const std::vector<std::string>& names) {
  std::vector<const model::Object*> chosen;
  const auto choose = [&](const model::Object& object) {
    if (std::ranges::find(chosen, &object) == chosen.end()) chosen.push_back(&object);
  };
  for (const std::string& name : names) {
    bool found = false;
    for (const model::Object& object : schema.objects) {
      if (object.name != name && object.qualified_name() != name) continue;
      choose(object);
      found = true;
    }
    if (found) continue;
    std::string message = "there is no object '";
    message.append(name).append("' in ").append(schema.file).append("; it declares ");
    for (const model::Object& object : schema.objects)
      message.append(&object == &schema.objects.front() ? "" : ", ").append(object.name);
    throw LayoutError(message);
  }
  if (names.empty())
    for (const model::Object& object : schema.objects) choose(object);
  return chosen;
}

std::vector<model::Layout> layouts_of(const std::string& word, const model::Object& object, Space space) {
  const model::Layout own = object.layout(space);
  if (word.empty()) return {own};
  if (word != "all") return {read(word, space, layout_choices())};
  std::vector<model::Layout> all;
  const int tile = own.tile != 0 ? own.tile : model::facts(space).standard.tile;
  for (const model::LayoutFacts& row : model::layouts()) all.push_back({row.key, row.tiled ? tile : 0});
  // From whole records to whole arrays.
  std::ranges::stable_sort(all, {}, [](model::Layout layout) {
    return model::facts(layout.kind).pitch(plan::assumed_objects, layout.tile);
  });
  return all;
}

/// Whether two maps differ in nothing but their spaces.
bool same_but_for_space(const LayoutMap& a, const LayoutMap& b) {
  return a.object == b.object && a.layout == b.layout && a.record_bytes == b.record_bytes && a.accessors == b.accessors;
}

}  // namespace

model::Layout read_layout(const std::string& word, model::Space space) {
  return read(word, space, layout_choices_of_a_space());
}

std::string layout_choices() {
  std::vector<std::string> words = words_of_layouts();
  words.emplace_back("all");
  return model::joined(words, " or ");
}

std::string layout_choices_of_a_space() { return model::joined(words_of_layouts(), " or "); }

std::string standard_layouts() {
  std::vector<std::string> words;
  for (const model::SpaceFacts& row : model::spaces())
    words.push_back(model::layout_word(row.standard) + " " + std::string(row.place));
  return model::joined(words, " and ");
}

std::string space_choices() {
  std::vector<std::string> words;
  for (const model::SpaceFacts& row : model::spaces()) words.emplace_back(row.word);
  words.emplace_back("both");
  return model::joined(words, " or ");
}

std::vector<LayoutMap> layout_maps(const model::Schema& schema, const LayoutRequest& request) {
  const std::vector<Space> spaces = spaces_of(request.space);
  const Precision precision = precision_of(request.real);
  std::vector<LayoutMap> maps;
  for (const model::Object* object : objects_of(schema, request.objects)) {
    const std::size_t first = maps.size();
    for (const Space space : spaces) {
      const plan::Records records(schema, space);
      for (const model::Layout layout : layouts_of(request.layout, *object, space)) {
        LayoutMap map = map_layout(records.of(object->qualified_name()), layout, precision);
        const auto same = std::find_if(maps.begin() + static_cast<std::ptrdiff_t>(first), maps.end(),
                                       [&](const LayoutMap& other) { return same_but_for_space(other, map); });
        if (same == maps.end())
          maps.push_back(std::move(map));
        else
          same->spaces.push_back(space);
      }
    }
  }
  return maps;
}

}  // namespace physgen::command
