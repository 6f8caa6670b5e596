// See report_groups.h.
#include "scenes/report_groups.h"

#include <nlohmann/json.hpp>

#include "scenes/local_arrays.h"

namespace physgen::scenes {
namespace {

using Json = nlohmann::ordered_json;

/// Bytes of one object, with the fields that are kept.
int bytes_of(const ArrayNeed& array) {
  int bytes = 0;
  for (const FieldNeed& field : array.fields) bytes += field.kept ? field.field.bytes : 0;
  return bytes;
}

}  // namespace

std::string groups_text(const Scene& scene, const Needs& needs) {
  std::string text;
  for (const StepGroup& group : needs.groups) {
    std::vector<std::string> locals;
    int bytes = 0;
    for (const std::string& local : group.locals) {
      bytes += bytes_of(needs.of(local));
      locals.push_back(local + " (" + std::to_string(bytes_of(needs.of(local))) + ")");
    }
    text += "  " + short_names(group.steps) + " are one step, at " + usage::text_of(group.places.back()) +
            "\n    local to them: " + model::joined(locals, " and ") + "; " + std::to_string(bytes) + " bytes " +
            set_of(*find(scene, group.locals.front())) + " are not stored\n";
  }
  for (const StepsApart& apart : needs.apart) {
    text += "  " + short_name(apart.first) + " and " + short_name(apart.second) + " are not joined, at " +
            usage::text_of(apart.place) + "\n";
    for (const std::string& reason : apart.why) text += "    " + reason + "\n";
    if (!apart.between.empty()) text += "    stored between them: " + model::joined(apart.between, " and ") + "\n";
  }
  for (const std::string& reason : needs.not_joined) text += "  " + reason + "\n";
  return text.empty() ? text : "\nGroups:\n" + text;
}

void add_groups(const Needs& needs, Json& json) {
  json["groups"] = Json::array();
  json["apart"] = Json::array();
  for (const StepGroup& group : needs.groups) {
    Json written = {{"steps", Json::array()}, {"locals", Json::array()}};
    for (std::size_t k = 0; k < group.steps.size(); ++k)
      written["steps"].push_back({{"step", group.steps[k]}, {"place", usage::text_of(group.places[k])}});
    for (const std::string& local : group.locals)
      written["locals"].push_back({{"array", local}, {"bytes", bytes_of(needs.of(local))}});
    json["groups"].push_back(std::move(written));
  }
  for (const StepsApart& apart : needs.apart)
    json["apart"].push_back({{"first", apart.first},
                             {"second", apart.second},
                             {"place", usage::text_of(apart.place)},
                             {"why", apart.why},
                             {"between", apart.between}});
  json["not_joined"] = needs.not_joined;
}

}  // namespace physgen::scenes
