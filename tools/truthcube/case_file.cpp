// Each object is read with the list of its keys, so that none is passed over.
#include "case_file.h"

#include <fem/mesh/nearest_name.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <utility>

#include "json_place.h"
#include "names.h"

namespace physgen::truthcube {

namespace {

using Words = std::vector<std::string>;

/// What an error says, without its beginning.
std::string plain(const Error& error) {
  const std::string said = error.what();
  return said.starts_with("physgen: ") ? said.substr(9) : said;
}

bool is_positive(double value) { return value > 0; }
bool is_ratio(double value) { return value > -1 && value < 0.5; }

std::optional<double>& component(fem::Displacement& displacement, const Place& place, const std::string& axis) {
  if (axis == "x") return displacement.x;
  if (axis == "y") return displacement.y;
  if (axis == "z") return displacement.z;
  place.refuse("there is no component '" + axis + "'; there are x, y, z");
}

std::string curve_of(const Place& entry) { return entry.has("curve") ? entry.at("curve").word() : ""; }

fem::SupportAxis axis_of(const Place& entry) {
  if (entry.has("fixed")) entry.at("fixed").refuse("a support with an axis holds along it; write another for x, y, z");
  fem::SupportAxis result;
  const Place axis = entry.at("axis");
  if (axis.is_word()) {
    result.is_normal = axis.word() == "normal";
    if (!result.is_normal) axis.refuse("an axis is three numbers, such as [1, 1, 0], or \"normal\"");
  } else {
    result.direction = axis.vector();
    if (result.direction == fem::Point{}) axis.refuse("[0, 0, 0] has no direction; give three numbers, not all 0");
  }
  if (entry.has("displacement")) result.displacement = entry.at("displacement").number();
  return result;
}

fem::Support support_of(const Place& entry) {
  entry.with_keys({"group", "fixed", "axis", "displacement", "curve"});
  fem::Support support{entry.at("group").word()};
  support.curve = curve_of(entry);
  if (entry.has("axis")) {
    support.axis = axis_of(entry);
    return support;
  }
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
  entry.with_keys({"group", "force", "traction", "pressure", "gravity", "follows", "curve"});
  const auto given = std::ranges::count_if(kinds, [&](const std::string& kind) { return entry.has(kind.c_str()); });
  if (given != 1)
    entry.refuse("a load has one of " + joined(kinds) + ", not " + std::to_string(given) + "; write a load for each");
  const std::string curve = curve_of(entry);
  if (entry.has("follows") && !entry.has("pressure")) entry.at("follows").refuse("only a pressure follows the surface");
  if (entry.has("gravity")) {
    if (entry.has("group")) entry.refuse("gravity acts on all of the body; remove 'group'");
    if (load_case.gravity != fem::Point{} && curve != load_case.gravity_curve) {
      entry.refuse("gravity has another curve than before; write one gravity, with one curve");
    }
    load_case.gravity_curve = curve;
    const fem::Point more = entry.at("gravity").vector();
    for (std::size_t k = 0; k < 3; ++k) load_case.gravity[k] += more[k];
    return;
  }
  const std::string group = entry.at("group").word();
  if (entry.has("force")) load_case.forces.push_back({group, entry.at("force").vector(), curve});
  if (entry.has("traction")) load_case.tractions.push_back({group, entry.at("traction").vector(), curve});
  if (!entry.has("pressure")) return;
  const bool follows = entry.has("follows") && entry.at("follows").truth();
  load_case.pressures.push_back({group, entry.at("pressure").number(), follows, curve});
}

void read_curves(const Place& curves, fem::LoadCase& load_case) {
  for (const auto& [name, points] : curves.members()) {
    fem::LoadCurve curve{name, {}};
    for (const Place& point : points.list()) {
      const auto numbers = point.list();
      if (numbers.size() != 2)
        point.refuse("this must be a step and a factor, not " + std::to_string(numbers.size()) + " numbers");
      curve.points.push_back({numbers[0].number(), numbers[1].number()});
    }
    try {
      fem::require_curve(curve);
    } catch (const Error& error) {
      points.refuse(plain(error));
    }
    load_case.curves.push_back(std::move(curve));
  }
}

/// The curves that loads and supports name are there, and each is named.
void check_curves(const Place& all, const fem::LoadCase& load_case) {
  std::vector<std::pair<std::string, std::string>> named{{"loads", load_case.gravity_curve}};
  for (const auto& support : load_case.supports) named.emplace_back("supports", support.curve);
  for (const auto& load : load_case.forces) named.emplace_back("loads", load.curve);
  for (const auto& load : load_case.tractions) named.emplace_back("loads", load.curve);
  for (const auto& load : load_case.pressures) named.emplace_back("loads", load.curve);
  Words curves;
  for (const fem::LoadCurve& curve : load_case.curves) curves.push_back(curve.name);
  for (const auto& [where, curve] : named) {
    if (curve.empty() || std::ranges::find(curves, curve) != curves.end()) continue;
    const std::string near = fem::nearest_name(curve, curves);
    all.at(where.c_str())
        .refuse("there is no curve '" + curve + "'" + (near.empty() ? "" : "; did you mean '" + near + "'?") +
                (curves.empty() ? "; add it under the key 'curves'" : ""));
  }
  for (const std::string& curve : curves) {
    if (std::ranges::find(named, curve, &std::pair<std::string, std::string>::second) == named.end()) {
      all.at("curves").refuse("no load names the curve '" + curve + "'; remove it, or name it in a load or support");
    }
  }
}

/// @param starts whether something may act at a load of 0
std::vector<double> steps_of(const Place& steps, bool starts) {
  std::vector<double> loads;
  for (const Place& step : steps.list()) {
    const double load = step.number();
    if (load == (loads.empty() ? 0.0 : loads.back()) && !(loads.empty() && starts)) {
      step.refuse("the load " + number(load) + (loads.empty() ? " is that at rest" : " is that of the step before") +
                  ", so that nothing is left to solve for; remove it");
    }
    loads.push_back(load);
  }
  if (loads.empty()) steps.refuse("there are no steps; write the factors of the loads, such as [0.5, 1]");
  return loads;
}

void read_constants(const Place& place, double& young, double& poisson) {
  young = place.at("young").number("positive: Young's modulus [Pa]", is_positive);
  poisson = place.at("poisson").number("above -1 and below 0.5: Poisson's ratio", is_ratio);
}

double density_of(const Place& place) {
  return place.at("density").number("positive: the density [kg/m^3]", is_positive);
}

void read_materials(const Place& list, Case& result) {
  for (const Place& entry : list.list()) {
    if (entry.has("law")) {
      entry.at("law").refuse(
          "all of a body has one law, which stands in 'material'; remove the key, and give the group constants");
    }
    entry.with_keys({"group", "young", "poisson", "density"});
    const std::string group = entry.at("group").word();
    if (std::ranges::find(result.material_groups, group) != result.material_groups.end()) {
      entry.refuse("there are two materials of group '" + group + "'; remove one");
    }
    result.material_groups.push_back(group);
    fem::ElasticConstants& constants = result.of_groups.emplace_back();
    read_constants(entry, constants.youngs_modulus, constants.poissons_ratio);
    if (entry.has("density")) result.load_case.densities.push_back({group, density_of(entry)});
  }
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

/// @throw Error naming the file and the line, or a key that stands twice
Json parsed_json(const std::string& file, std::istream& stream) {
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
    throw Error("case " + file + ": this is not JSON: " + said);
  }
  if (!repeated.empty())
    throw Error("case " + file + ": the key '" + repeated + "' stands twice in one object; remove one");
  return json;
}

}  // namespace

Case read_case(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file))
    throw Error("case " + name + ": cannot be read; check its name and your rights");
  const Json json = parsed_json(name, stream);
  const Place all(name, "", json);
  all.with_keys({"mesh", "scale", "material", "supports", "loads", "curves", "steps", "probes", "output"});
  Case result;
  result.text = json.dump();
  result.mesh = all.at("mesh").word();
  if (result.mesh.is_relative()) result.mesh = file.parent_path() / result.mesh;
  if (all.has("scale"))
    result.scale = all.at("scale").number("positive: metres of the mesh's unit of length", is_positive);
  const Place material = all.at("material").with_keys({"law", "young", "poisson", "density", "groups"});
  if (material.has("law")) {
    result.law = material.at("law").word();
    const Words& laws = fem::material_names();
    if (std::ranges::find(laws, result.law) == laws.end()) {
      material.at("law").refuse(unknown("material", result.law, laws) + " This build has " + joined(laws));
    }
  }
  read_constants(material, result.young, result.poisson);
  if (material.has("groups")) read_materials(material.at("groups"), result);
  for (const Place& entry : all.at("supports").list()) result.load_case.supports.push_back(support_of(entry));
  if (all.has("loads")) {
    for (const Place& entry : all.at("loads").list()) read_load(entry, result.load_case);
  }
  if (material.has("density")) {
    result.load_case.density = density_of(material);
  } else if (result.load_case.gravity != fem::Point{}) {
    material.refuse("gravity needs the key 'density' [kg/m^3] here");
  }
  if (all.has("curves")) read_curves(all.at("curves"), result.load_case);
  check_curves(all, result.load_case);
  if (all.has("steps")) result.steps = steps_of(all.at("steps"), all.has("curves"));
  if (all.has("output")) result.output = all.at("output").word();
  if (all.has("probes")) read_probes(all.at("probes"), result);
  return result;
}

}  // namespace physgen::truthcube
