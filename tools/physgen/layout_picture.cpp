// Which arrays `physgen layout` draws. See layout_picture.h.
#include "layout_picture.h"

#include <algorithm>

namespace physgen::command {
namespace {

using model::LayoutKind;
using model::Space;

std::vector<Space> spaces_of(const std::string& word) {
  if (word == "host") return {Space::host};
  if (word == "cuda") return {Space::cuda};
  if (word == "both") return {Space::host, Space::cuda};
  throw LayoutError("there is no space '" + word + "'; write host, cuda or both");
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

/// The schema's layout of the object in a space, else the runtime's default.
model::Layout own_layout(const model::Object& object, Space space) {
  return space == Space::host ? object.host_layout.value_or(model::Layout{LayoutKind::aosoa, 16})
                              : object.cuda_layout.value_or(model::Layout{LayoutKind::aosoa, 32});
}

std::vector<model::Layout> layouts_of(const std::string& word, const model::Object& object, Space space) {
  const model::Layout own = own_layout(object, space);
  if (word.empty()) return {own};
  if (word != "all") return {read_layout(word)};
  const int tile = own.kind == LayoutKind::aosoa ? own.tile : space == Space::host ? 16 : 32;
  return {{LayoutKind::aos, 0}, {LayoutKind::aos_padded, 0}, {LayoutKind::aosoa, tile}, {LayoutKind::soa, 0}};
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
