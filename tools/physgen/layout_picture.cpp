// Chooses the arrays that `physgen layout` draws. See layout_picture.h.
#include "layout_picture.h"

#include <algorithm>

namespace physgen::command {
namespace {

using model::Space;

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
  if (word != "all") return {read_layout(word)};
  std::vector<model::Layout> all;
  const int tile = own.tile != 0 ? own.tile : model::facts(space).standard.tile;
  for (const model::LayoutFacts& row : model::layouts()) all.push_back({row.key, row.tiled ? tile : 0});
  // From whole records to whole arrays.
  std::ranges::stable_sort(
      all, {}, [](model::Layout layout) { return model::facts(layout.kind).pitch(assumed_objects, layout.tile); });
  return all;
}

/// Whether two maps differ in nothing but their spaces.
bool same_but_for_space(const LayoutMap& a, const LayoutMap& b) {
  return a.object == b.object && a.layout == b.layout && a.record_bytes == b.record_bytes && a.accessors == b.accessors;
}

}  // namespace

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
