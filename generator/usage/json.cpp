// See json.h. Every struct has one function that writes its members and one that reads them, in the same order. What is
// false or empty is not written.
#include "usage/json.h"

#include <nlohmann/json.hpp>
#include <set>

namespace physgen::usage {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;  // counts up when an old reader would misread a new file

void write(Json& json, const char* key, bool value) {
  if (value) json[key] = true;
}

void write(Json& json, const char* key, const std::vector<Place>& places) {
  for (const Place& place : places) json[key].push_back(text_of(place));
}

Json write(const std::vector<FieldUse>& uses) {
  Json list = Json::array();
  for (const FieldUse& use : uses) {
    Json json = {{"array", use.array}, {"field", use.field}};
    write(json, "read", use.read);
    write(json, "written", use.written);
    write(json, "address_taken", use.address_taken);
    write(json, "own", use.own);
    write(json, "gathered", use.gathered);
    write(json, "added", use.added);
    write(json, "whole_object", use.whole_object);
    write(json, "places", use.places);
    write(json, "whole_places", use.whole_places);
    list.push_back(std::move(json));
  }
  return list;
}

Json write(const StepUse& step) {
  Json json = {{"kernel", step.kernel}, {"place", text_of(step.place)}, {"arrays", step.arrays}};
  write(json, "root", step.root);
  json["fields"] = write(step.fields);
  return json;
}

Json write(const UnknownUse& use) { return {{"array", use.array}, {"what", use.what}, {"place", text_of(use.place)}}; }

Json write(const Program& program) {
  Json json = {{"name", program.name}, {"steps", Json::array()}};
  for (const StepUse& step : program.usage.steps) json["steps"].push_back(write(step));
  json["unattributed"] = write(program.usage.unattributed);
  json["unknown"] = Json::array();
  for (const UnknownUse& use : program.usage.unknown) json["unknown"].push_back(write(use));
  return json;
}

/// An object of a file, all of whose keys must be read.
class JsonReader {
 public:
  JsonReader(const Json& json, std::string where) : json_(json), where_(std::move(where)) {
    if (!json.is_object()) fail("is not an object");
  }
  JsonReader(const JsonReader&) = delete;
  JsonReader& operator=(const JsonReader&) = delete;

  template <class T>
  T get(const char* key) {
    keys_.insert(key);
    if (!json_.contains(key)) fail("has no '" + std::string(key) + "'");
    try {
      return json_.at(key).template get<T>();
    } catch (const Json::exception&) {
      fail("has a '" + std::string(key) + "' of another type");
    }
  }
  bool flag(const char* key) { return json_.contains(key) && get<bool>(key); }
  std::vector<Place> places(const char* key) {
    std::vector<Place> result;
    if (!json_.contains(key)) return result;
    for (const auto& text : get<std::vector<std::string>>(key)) result.push_back(place_of(text));
    return result;
  }
  Place place(const char* key) { return place_of(get<std::string>(key)); }
  template <class Read>
  void each(const char* key, const Read& read) {
    const Json list = get<Json>(key);
    if (!list.is_array()) fail("has a '" + std::string(key) + "' that is not a list");
    for (std::size_t i = 0; i < list.size(); ++i) {
      JsonReader reader(list[i], where_ + "/" + key + "[" + std::to_string(i) + "]");
      read(reader);
      reader.finish();
    }
  }
  void finish() const {
    for (const auto& [key, value] : json_.items())
      if (keys_.count(key) == 0) fail("has a '" + key + "', which this physgen does not know");
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw JsonError((where_.empty() ? "it" : where_.substr(1)) + " " + what);
  }

 private:
  [[nodiscard]] Place place_of(const std::string& text) const {
    const auto column = text.rfind(':'), line = text.rfind(':', column == 0 ? 0 : column - 1);
    try {
      if (line == std::string::npos || line == column) throw std::invalid_argument("");
      return {text.substr(0, line), std::stoi(text.substr(line + 1)), std::stoi(text.substr(column + 1))};
    } catch (const std::logic_error&) {  // of std::stoi
      fail("has the place '" + text + "', which is not file:line:column");
    }
  }

  const Json& json_;
  std::string where_;
  std::set<std::string> keys_;
};

FieldUse read_field(JsonReader& json) {
  FieldUse use;
  use.array = json.get<std::string>("array");
  use.field = json.get<std::string>("field");
  use.read = json.flag("read");
  use.written = json.flag("written");
  use.address_taken = json.flag("address_taken");
  use.own = json.flag("own");
  use.gathered = json.flag("gathered");
  use.added = json.flag("added");
  use.whole_object = json.flag("whole_object");
  use.places = json.places("places");
  use.whole_places = json.places("whole_places");
  return use;
}

StepUse read_step(JsonReader& json) {
  StepUse step;
  step.kernel = json.get<std::string>("kernel");
  step.place = json.place("place");
  step.arrays = json.get<std::vector<std::string>>("arrays");
  step.root = json.flag("root");
  json.each("fields", [&](JsonReader& field) { step.fields.push_back(read_field(field)); });
  return step;
}

Program read_program(JsonReader& json) {
  Program program;
  program.name = json.get<std::string>("name");
  json.each("steps", [&](JsonReader& step) { program.usage.steps.push_back(read_step(step)); });
  json.each("unattributed", [&](JsonReader& field) { program.usage.unattributed.push_back(read_field(field)); });
  json.each("unknown", [&](JsonReader& use) {
    program.usage.unknown.push_back({use.get<std::string>("array"), use.get<std::string>("what"), use.place("place")});
  });
  return program;
}

}  // namespace

std::string to_json(const std::vector<Program>& programs) {
  Json json = {{"format", format}, {"programs", Json::array()}};
  for (const Program& program : programs) json["programs"].push_back(write(program));
  return json.dump(1) + "\n";
}

std::vector<Program> from_json(const std::string& text) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::exception& error) {
    throw JsonError(std::string("this is not JSON: ") + error.what());
  }
  JsonReader reader(json, "");
  if (const int found = reader.get<int>("format"); found != format)
    reader.fail("has format " + std::to_string(found) + "; this physgen reads " + std::to_string(format));
  std::vector<Program> programs;
  reader.each("programs", [&](JsonReader& program) { programs.push_back(read_program(program)); });
  reader.finish();
  return programs;
}

}  // namespace physgen::usage
