// See json.h. Every struct has one function that writes its members and one that reads them, in the same order.
#include "model/json.h"

#include <algorithm>
#include <climits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "model/validate.h"

namespace physgen::model {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;  // of the JSON; counts up when an old reader would misread a new file

void write(Json& json, const char* key, const std::string& value) {
  if (!value.empty()) json[key] = value;
}

Json write(const Location& location) {
  return {{"file", location.file}, {"line", location.line}, {"column", location.column}};
}

Json write(const Layout& layout) {
  Json json = {{"kind", facts(layout.kind).word}};
  if (layout.tile != 0) json["tile"] = layout.tile;
  return json;
}

Json write(const Format& format) {
  Json json = {{"encoding", facts(format.encoding).word}};
  if (format.quaternion) json["quaternion"] = true;
  return json;
}

Json write(const Field& field) {
  Json json;
  json["name"] = field.name;
  write(json, "doc", field.doc);
  json["shape"] = facts(field.shape).word;
  if (field.shape == Shape::object) {
    json["object"] = field.object;
  } else {
    json["element"] = facts(field.element).word;
  }
  if (field.rows != 1) json["rows"] = field.rows;
  if (field.cols != 1) json["cols"] = field.cols;
  if (field.array_extent != 0) json["array_extent"] = field.array_extent;
  write(json, "unit", field.unit);
  if (field.range) json["range"] = {field.range->low, field.range->high};
  if (field.initial) json["initial"] = *field.initial;
  if (field.host_format != Format{}) json["host_format"] = write(field.host_format);
  if (field.cuda_format != Format{}) json["cuda_format"] = write(field.cuda_format);
  if (field.location != Location{}) json["location"] = write(field.location);
  return json;
}

Json write(const Object& object) {
  Json json;
  json["name"] = object.name;
  write(json, "scope", object.scope);
  write(json, "doc", object.doc);
  write(json, "header", object.header);
  if (object.host_layout) json["host_layout"] = write(*object.host_layout);
  if (object.cuda_layout) json["cuda_layout"] = write(*object.cuda_layout);
  if (object.alignment != 0) json["alignment"] = object.alignment;
  if (object.location != Location{}) json["location"] = write(object.location);
  json["fields"] = Json::array();
  for (const Field& field : object.fields) json["fields"].push_back(write(field));
  return json;
}

/// One JSON value and where it stands; every read says its place when it fails.
class Reader {
 public:
  Reader(const Json& json, std::string place) : json_(json), place_(std::move(place)) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument((place_.empty() ? "model" : place_) + ": " + what);
  }

  /// Fails if the value is no object or has a member that is not in `known`: a misspelt key must not pass for a
  /// default.
  const Reader& members(std::initializer_list<std::string_view> known) const {
    if (!json_.is_object()) fail("must be an object { ... }, not " + std::string(json_.type_name()));
    for (const auto& [key, value] : json_.items())
      if (std::find(known.begin(), known.end(), key) == known.end()) fail("has an unknown member '" + key + "'");
    return *this;
  }

  [[nodiscard]] bool has(const char* key) const { return json_.contains(key); }

  [[nodiscard]] Reader at(const char* key) const {
    if (!has(key)) fail("has no member '" + std::string(key) + "'");
    return {json_.at(key), (place_.empty() ? "" : place_ + ".") + key};
  }

  [[nodiscard]] std::vector<Reader> items() const {
    if (!json_.is_array()) fail("must be an array [ ... ], not " + std::string(json_.type_name()));
    std::vector<Reader> items;
    for (std::size_t i = 0; i < json_.size(); ++i) items.emplace_back(json_[i], place_ + "[" + std::to_string(i) + "]");
    return items;
  }

  [[nodiscard]] std::string text() const {
    if (!json_.is_string()) fail("must be a string, not " + std::string(json_.type_name()));
    return json_.get<std::string>();
  }

  [[nodiscard]] int integer() const {
    if (!json_.is_number_integer()) fail("must be an integer, not " + json_.dump());
    const bool fits =
        json_.is_number_unsigned() ? json_.get<std::uint64_t>() <= INT_MAX : json_.get<std::int64_t>() >= INT_MIN;
    if (!fits) fail("must be a 32-bit integer, not " + json_.dump());
    return json_.get<int>();
  }

  [[nodiscard]] double number() const {
    if (!json_.is_number()) fail("must be a number, not " + std::string(json_.type_name()));
    return json_.get<double>();
  }

  [[nodiscard]] bool boolean() const {
    if (!json_.is_boolean()) fail("must be true or false, not " + json_.dump());
    return json_.get<bool>();
  }

  template <class Facts>
  [[nodiscard]] auto one_of(std::span<const Facts> rows) const {
    const std::string value = text();
    if (const Facts* row = find_word(rows, value)) return row->key;
    std::vector<std::string> choices;
    for (const Facts& row : rows) choices.emplace_back(row.word);
    fail("must be one of " + joined(choices) + ", not '" + value + "'");
  }

  [[nodiscard]] std::string text_or_empty(const char* key) const { return has(key) ? at(key).text() : std::string(); }
  [[nodiscard]] int integer_or(const char* key, int otherwise) const {
    return has(key) ? at(key).integer() : otherwise;
  }

 private:
  const Json& json_;
  std::string place_;
};

Location read_location(const Reader& reader) {
  if (!reader.has("location")) return {};
  const Reader json = reader.at("location").members({"file", "line", "column"});
  return {json.at("file").text(), json.at("line").integer(), json.at("column").integer()};
}

std::optional<Layout> read_layout(const Reader& reader, const char* key) {
  if (!reader.has(key)) return std::nullopt;
  const Reader json = reader.at(key).members({"kind", "tile"});
  return Layout{json.at("kind").one_of(layouts()), json.integer_or("tile", 0)};
}

Format read_format(const Reader& reader, const char* key) {
  if (!reader.has(key)) return {};
  const Reader json = reader.at(key).members({"encoding", "quaternion"});
  return {json.at("encoding").one_of(encodings()), json.has("quaternion") && json.at("quaternion").boolean()};
}

Field read_field(const Reader& json) {
  json.members({"name", "doc", "shape", "object", "element", "rows", "cols", "array_extent", "unit", "range", "initial",
                "host_format", "cuda_format", "location"});
  Field field;
  field.name = json.at("name").text();
  field.doc = json.text_or_empty("doc");
  field.shape = json.at("shape").one_of(shapes());
  if (field.shape == Shape::object) {
    field.object = json.at("object").text();
  } else {
    field.element = json.at("element").one_of(elements());
  }
  field.rows = json.integer_or("rows", 1);
  field.cols = json.integer_or("cols", 1);
  field.array_extent = json.integer_or("array_extent", 0);
  field.unit = json.text_or_empty("unit");
  if (json.has("range")) {
    const auto ends = json.at("range").items();
    if (ends.size() != 2) json.at("range").fail("must be [low, high]");
    field.range = Range{ends[0].number(), ends[1].number()};
  }
  if (json.has("initial")) field.initial = json.at("initial").number();
  field.host_format = read_format(json, "host_format");
  field.cuda_format = read_format(json, "cuda_format");
  field.location = read_location(json);
  return field;
}

Object read_object(const Reader& json) {
  json.members({"name", "scope", "doc", "header", "host_layout", "cuda_layout", "alignment", "location", "fields"});
  Object object;
  object.name = json.at("name").text();
  object.scope = json.text_or_empty("scope");
  object.doc = json.text_or_empty("doc");
  object.header = json.text_or_empty("header");
  object.host_layout = read_layout(json, "host_layout");
  object.cuda_layout = read_layout(json, "cuda_layout");
  object.alignment = json.integer_or("alignment", 0);
  object.location = read_location(json);
  for (const Reader& field : json.at("fields").items()) object.fields.push_back(read_field(field));
  return object;
}

void require_sound(const Schema& schema) {
  std::string problems;
  for (const Issue& issue : validate(schema)) {
    problems += problems.empty() ? "" : "\n";
    if (issue.place.object >= 0) {
      problems +=
          std::string(issue.place.imported ? "imported" : "objects") + "[" + std::to_string(issue.place.object) + "]";
      if (issue.place.field >= 0) problems += ".fields[" + std::to_string(issue.place.field) + "]";
      problems += ": ";
    }
    problems += issue.message;
  }
  if (!problems.empty()) throw std::invalid_argument(problems);
}

}  // namespace

std::string to_json(const Schema& schema) {
  Json json;
  json["physgen_model"] = format;
  json["file"] = schema.file;
  json["imported"] = Json::array();
  for (const Object& object : schema.imported) json["imported"].push_back(write(object));
  json["objects"] = Json::array();
  for (const Object& object : schema.objects) json["objects"].push_back(write(object));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Schema from_json(const std::string& text) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw std::invalid_argument(std::string("model: not JSON: ") + error.what());
  }
  const Reader model(json, "");
  model.members({"physgen_model", "file", "imported", "objects"});
  if (const int found = model.at("physgen_model").integer(); found != format)
    model.at("physgen_model")
        .fail("format " + std::to_string(found) + " is not the format " + std::to_string(format) +
              " that this physgen reads");
  Schema schema;
  schema.file = model.at("file").text();
  for (const Reader& object : model.at("imported").items()) schema.imported.push_back(read_object(object));
  for (const Reader& object : model.at("objects").items()) schema.objects.push_back(read_object(object));
  require_sound(schema);
  return schema;
}

}  // namespace physgen::model
