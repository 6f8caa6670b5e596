// See json.h. Every struct has one function that writes its members.
#include "model/json.h"

#include <nlohmann/json.hpp>

namespace physgen::model {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 2;  // of the JSON; counts up when an old reader would misread a new file

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
  write(json, "schema", object.schema);
  if (object.host_layout) json["host_layout"] = write(*object.host_layout);
  if (object.cuda_layout) json["cuda_layout"] = write(*object.cuda_layout);
  if (object.alignment != 0) json["alignment"] = object.alignment;
  if (object.location != Location{}) json["location"] = write(object.location);
  json["fields"] = Json::array();
  for (const Field& field : object.fields) json["fields"].push_back(write(field));
  return json;
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

}  // namespace physgen::model
