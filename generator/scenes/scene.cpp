// See scene.h.
#include "scenes/scene.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace physgen::scenes {
namespace {

using Json = nlohmann::ordered_json;

Json write(const Selection& selection) {
  if (selection.all) return "all";
  return selection.names;
}

Json write(const Array& array) {
  Json json = {{"name", array.name}, {"object", array.object}, {"real", array.real}};
  if (!array.doc.empty()) json["doc"] = array.doc;
  if (array.set.empty())
    json["count"] = array.count;
  else
    json["per"] = array.set;
  if (array.input) json["input"] = write(*array.input);
  if (array.output) json["output"] = write(*array.output);
  if (array.uniform) json["uniform"] = true;
  for (const NamedObjects& named : array.names)
    json["names"].push_back({{"field", named.field}, {"set", named.set}, {"shift", named.shift}});
  if (!array.follows.empty()) json["follows"] = array.follows;
  json["fields"] = Json::array();
  for (const Field& field : array.fields) {
    Json written = {{"name", field.name}, {"type", field.type}, {"elements", field.elements}, {"bytes", field.bytes}};
    if (field.initial) written["initial"] = true;
    json["fields"].push_back(std::move(written));
  }
  return json;
}

}  // namespace

bool Selection::has(const std::string& field) const {
  return all || std::find(names.begin(), names.end(), field) != names.end();
}

std::vector<std::string> Group::sets() const {
  std::vector<std::string> sets;
  for (const Array& array : arrays)
    if (!array.set.empty() && std::find(sets.begin(), sets.end(), array.set) == sets.end()) sets.push_back(array.set);
  return sets;
}

bool states_names(const Scene& scene) {
  return std::ranges::any_of(scene.groups, [](const Group& group) {
    return std::ranges::any_of(group.arrays,
                               [](const Array& array) { return !array.names.empty() || !array.follows.empty(); });
  });
}

std::string set_of(const Array& array) {
  if (!array.set.empty()) return "per " + array.set;
  return std::to_string(array.count) + (array.count == 1 ? " object" : " objects");
}

const Array* find(const Scene& scene, const std::string& full_name) {
  for (const Group& group : scene.groups)
    for (const Array& array : group.arrays)
      if (group.full_name(array) == full_name) return &array;
  return nullptr;
}

std::string generated_name(const Array& array, const std::string& ending) { return array.object + ending; }

std::string to_json(const Scene& scene) {
  Json json = {{"name", scene.qualified_name()}, {"include", scene.include}};
  if (!scene.doc.empty()) json["doc"] = scene.doc;
  if (!scene.real.empty()) json["real"] = scene.real;
  json["groups"] = Json::array();
  for (const Group& group : scene.groups) {
    Json written = {{"name", group.name}, {"variable", group.variable}};
    if (!group.doc.empty()) written["doc"] = group.doc;
    written["arrays"] = Json::array();
    for (const Array& array : group.arrays) written["arrays"].push_back(write(array));
    json["groups"].push_back(std::move(written));
  }
  json["parameters"] = scene.parameters;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace physgen::scenes
