// Each object is read with the list of its keys, so that none is passed over.
#include "case_file.h"

#include <fem/mesh/nearest_name.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "names.h"

namespace physgen::truthcube {

namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

/// A value and where it stands.
class Place {
 public:
  Place(const std::string& file, std::string name, const Json& json)
      : file_(&file), name_(std::move(name)), json_(&json) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw Error("case " + *file_ + ": " + (name_.empty() ? "" : name_ + ": ") + what);
  }

  /// An object. @throw Error for keys that it has not
  const Place& with_keys(const Words& keys) const {
    if (!json_->is_object()) refuse("this must be an object with " + joined(keys) + ", not " + shown());
    for (const auto& [key, value] : json_->items()) {
      if (std::ranges::find(keys, key) != keys.end()) continue;
      const std::string near = fem::nearest_name(key, keys);
      refuse("there is no key '" + key + "' here" + (near.empty() ? "; " : "; did you mean '" + near + "'? ") +
             "there are " + joined(keys));
    }
    return *this;
  }
  [[nodiscard]] bool has(const char* key) const { return json_->contains(key); }
  [[nodiscard]] Place at(const char* key) const {
    if (!has(key)) refuse(std::string("the key '") + key + "' is missing");
    return {*file_, name_.empty() ? key : name_ + "." + key, json_->at(key)};
  }
  [[nodiscard]] std::vector<Place> list() const {
    if (!json_->is_array()) refuse("this must be a list in brackets, not " + shown());
    std::vector<Place> all;
    for (std::size_t k = 0; k < json_->size(); ++k)
      all.emplace_back(*file_, name_ + "[" + std::to_string(k) + "]", (*json_)[k]);
    return all;
  }
  [[nodiscard]] double number() const {
    if (!json_->is_number()) refuse("this must be a number, not " + shown());
    return json_->get<double>();
  }
  /// @param holds what the value must be, as `what` says
  [[nodiscard]] double number(const char* what, bool (*holds)(double)) const {
    const double value = number();
    if (!holds(value)) refuse(truthcube::number(value) + " must be " + what);
    return value;
  }
  [[nodiscard]] std::string word() const {
    if (!json_->is_string() || json_->get<std::string>().empty())
      refuse("this must be a text in quotes, not " + shown());
    return json_->get<std::string>();
  }
  [[nodiscard]] fem::Point vector() const {
    const auto numbers = list();
    if (numbers.size() != 3) refuse("this must be 3 numbers, along x, y and z, not " + std::to_string(numbers.size()));
    return {numbers[0].number(), numbers[1].number(), numbers[2].number()};
  }

 private:
  [[nodiscard]] std::string shown() const { return json_->dump().substr(0, 40); }

  const std::string* file_;
  std::string name_;
  const Json* json_;
};

bool is_positive(double value) { return value > 0; }
bool is_ratio(double value) { return value > -1 && value < 0.5; }

std::optional<double>& component(fem::Displacement& displacement, const Place& place, const std::string& axis) {
  if (axis == "x") return displacement.x;
  if (axis == "y") return displacement.y;
  if (axis == "z") return displacement.z;
  place.refuse("there is no component '" + axis + "'; there are x, y, z");
}

fem::Support support_of(const Place& entry) {
  entry.with_keys({"group", "fixed", "displacement"});
  fem::Support support{entry.at("group").word()};
  if (!entry.has("fixed") && !entry.has("displacement")) return support;
  support.displacement = {};
  if (entry.has("displacement")) {
    const Place values = entry.at("displacement").with_keys({"x", "y", "z"});
    for (const char* axis : {"x", "y", "z"}) {
      if (values.has(axis)) component(support.displacement, values, axis) = values.at(axis).number();
    }
  }
  if (entry.has("fixed")) {
    for (const Place& axis : entry.at("fixed").list()) {
      auto& value = component(support.displacement, axis, axis.word());
      if (value) axis.refuse("component '" + axis.word() + "' is prescribed here twice; leave it in one place");
      value = 0.0;
    }
  }
  const auto& [x, y, z] = support.displacement;
  if (!x && !y && !z) entry.refuse("no component is prescribed; name some, or leave 'fixed' out to fix all");
  return support;
}

void read_load(const Place& entry, fem::LoadCase& load_case) {
  const Words kinds{"force", "traction", "pressure", "gravity"};
  entry.with_keys({"group", "force", "traction", "pressure", "gravity"});
  const auto given = std::ranges::count_if(kinds, [&](const std::string& kind) { return entry.has(kind.c_str()); });
  if (given != 1)
    entry.refuse("a load has one of " + joined(kinds) + ", not " + std::to_string(given) + "; write a load for each");
  if (entry.has("gravity")) {
    if (entry.has("group")) entry.refuse("gravity acts on all of the body; remove 'group'");
    const fem::Point more = entry.at("gravity").vector();
    for (std::size_t k = 0; k < 3; ++k) load_case.gravity[k] += more[k];
    return;
  }
  const std::string group = entry.at("group").word();
  if (entry.has("force")) load_case.forces.push_back({group, entry.at("force").vector()});
  if (entry.has("traction")) load_case.tractions.push_back({group, entry.at("traction").vector()});
  if (entry.has("pressure")) load_case.pressures.push_back({group, entry.at("pressure").number()});
}

std::vector<double> steps_of(const Place& steps) {
  std::vector<double> loads;
  for (const Place& step : steps.list()) {
    const double load = step.number();
    if (load == (loads.empty() ? 0.0 : loads.back())) {
      step.refuse("the load " + number(load) + (loads.empty() ? " is that at rest" : " is that of the step before") +
                  ", so that nothing is left to solve for; remove it");
    }
    loads.push_back(load);
  }
  if (loads.empty()) steps.refuse("there are no steps; write the factors of the loads, such as [0.5, 1]");
  return loads;
}

void read_probes(const Place& list, Case& result) {
  for (const Place& entry : list.list()) {
    entry.with_keys({"name", "at"});
    const std::string name = entry.at("name").word();
    if (std::ranges::find(result.probes, name, &Probe::name) != result.probes.end()) {
      entry.refuse("there are two probes '" + name + "'; give each a name of its own");
    }
    result.probes.push_back({name, entry.at("at").vector()});
  }
}

Json parsed(const std::string& name, std::istream& stream) {
  std::vector<std::set<std::string>> keys;  // of the objects that are open
  std::string repeated;
  const auto see = [&](int /*depth*/, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second) {
      repeated = value.get<std::string>();
    }
    return true;
  };
  Json json;
  try {
    json = Json::parse(stream, see, true, true);
  } catch (const Json::exception& error) {
    std::string said = error.what();
    said = said.substr(said.find("] ") == said.npos ? 0 : said.find("] ") + 2);
    std::ranges::replace_if(said, [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
    throw Error("case " + name + ": this is not JSON: " + said);
  }
  if (!repeated.empty())
    throw Error("case " + name + ": the key '" + repeated + "' stands twice in one object; remove one");
  return json;
}

}  // namespace

Case read_case(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file))
    throw Error("case " + name + ": cannot be read; check its name and your rights");
  const Json json = parsed(name, stream);
  const Place all(name, "", json);
  all.with_keys({"mesh", "scale", "material", "supports", "loads", "steps", "probes"});
  Case result;
  result.text = json.dump();
  result.mesh = all.at("mesh").word();
  if (result.mesh.is_relative()) result.mesh = file.parent_path() / result.mesh;
  if (all.has("scale"))
    result.scale = all.at("scale").number("positive: metres of the mesh's unit of length", is_positive);
  const Place material = all.at("material").with_keys({"law", "young", "poisson", "density"});
  if (material.has("law")) {
    result.law = material.at("law").word();
    const Words& laws = fem::material_names();
    if (std::ranges::find(laws, result.law) == laws.end()) {
      material.at("law").refuse(unknown("material", result.law, laws) + " This build has " + joined(laws));
    }
  }
  result.young = material.at("young").number("positive: Young's modulus [Pa]", is_positive);
  result.poisson = material.at("poisson").number("above -1 and below 0.5: Poisson's ratio", is_ratio);
  for (const Place& entry : all.at("supports").list()) result.load_case.supports.push_back(support_of(entry));
  if (all.has("loads")) {
    for (const Place& entry : all.at("loads").list()) read_load(entry, result.load_case);
  }
  if (material.has("density")) {
    result.load_case.density = material.at("density").number("positive: the density [kg/m^3]", is_positive);
  } else if (result.load_case.gravity != fem::Point{}) {
    material.refuse("gravity needs the key 'density' [kg/m^3] here");
  }
  if (all.has("steps")) result.steps = steps_of(all.at("steps"));
  if (all.has("probes")) read_probes(all.at("probes"), result);
  return result;
}

}  // namespace physgen::truthcube
