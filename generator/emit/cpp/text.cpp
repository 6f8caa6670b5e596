// See text.h.
#include "emit/cpp/text.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "model/formats.h"
#include "model/text.h"

namespace physgen::emit::cpp {
namespace {

using model::number;

// "Symmetric, 6 stored."
std::string structure(const model::Field& field) {
  std::string text(model::facts(field.shape).phrase);
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + ", " + std::to_string(model::element_count(field)) + " stored.";
}

std::string values(const model::Field& field) {
  std::string text;
  if (field.range) text = "Range [" + number(field.range->low) + ", " + number(field.range->high) + "]";
  if (field.initial) text += (text.empty() ? "Initially " : "; initially ") + number(*field.initial);
  if (field.initial && !initial_in_value(field)) text += " in a new array";
  return text.empty() ? text : text + ".";
}

std::string encoded_type(const model::Field& field, const model::EncodingFacts& encoding) {
  const std::string prefix = "physgen::format::";
  std::string type = prefix + std::string(encoding.type);
  switch (encoding.scaling) {
    case model::Scaling::none:
      break;
    case model::Scaling::exponent: {
      const int exponent = model::scale_exponent(field, encoding);
      return type + "<" + (exponent == 0 ? "" : std::to_string(exponent)) + ">";
    }
    case model::Scaling::interval: {
      const model::Range range = model::steps_range(field);
      return type + "<" + prefix + "Interval{" + real(range.low) + ", " + real(range.high) + "}>";
    }
  }
  return type;
}

// "Stored as half, ...", where the schema says how.
std::string storage(const model::Field& field) {
  if (field.shape == model::Shape::object) return {};
  const std::string host = model::describe_format(field, field.host_format),
                    cuda = model::describe_format(field, field.cuda_format);
  if (host.empty() && cuda.empty()) return {};
  if (host == cuda) return "Stored as " + host + ".";
  std::string text;
  if (!host.empty()) text = "Stored on the host as " + host;
  if (!cuda.empty()) text += (text.empty() ? "Stored on CUDA as " : "; on CUDA as ") + cuda;
  return text + ".";
}

}  // namespace

bool initial_in_value(const model::Field& field) {
  return field.initial && field.array_extent == 0 && model::facts(field.shape).uniform;
}

std::string real(double value) {
  const std::string text = number(value);
  return text + (text.find_first_of(".e") == std::string::npos ? ".0" : "");
}

std::string stored_type(model::Element element) { return std::string(model::facts(element).type); }

std::string value_type(model::Element element) {
  const std::string stored = stored_type(element);
  return element == model::Element::real ? stored : "physgen::same_lanes_t<Real, " + stored + ">";
}

std::string format_type(const model::Field& field, model::Space space) {
  const auto& [kind, quaternion] = field.format(space);
  const model::EncodingFacts& encoding = model::facts(kind);
  std::string name = encoded_type(field, encoding);
  if (!quaternion) return name;
  if (!encoding.quaternion.empty()) return "physgen::format::" + std::string(encoding.quaternion);
  return "physgen::format::Quaternion<" + (kind == model::Encoding::native ? "" : name) + ">";
}

std::string layout_type(const model::Layout& layout) {
  const model::LayoutFacts& row = model::facts(layout.kind);
  return "physgen::" + std::string(row.type) + (row.tiled ? "<" + std::to_string(layout.tile) + ">" : "");
}

std::string nested_type_name(const model::Field& field, const char* ending, const model::Object& user) {
  const auto colons = field.object.rfind("::");
  const bool global = colons == std::string::npos;
  if ((global ? "" : field.object.substr(0, colons)) == user.scope)
    return (global ? field.object : field.object.substr(colons + 2)) + ending;
  return "::" + field.object + ending;
}

std::string field_comment(const model::Field& field) {
  std::string text = field.doc;
  bool ended = text.empty() || std::string_view(".!?:").find(text.back()) != std::string_view::npos;
  if (!field.unit.empty()) {
    ended = ended && !text.empty();
    text += (text.empty() ? "[" : " [") + field.unit + "]";
  }
  for (const std::string& sentence : {structure(field), values(field), storage(field)}) {
    if (sentence.empty()) continue;
    text += (text.empty() ? "" : ended ? " " : ". ") + sentence;
    ended = true;
  }
  return text;
}

std::string local_name(const char* name, const model::Object& object) {
  const bool taken = std::any_of(object.fields.begin(), object.fields.end(),
                                 [&](const model::Field& field) { return field.name == name; });
  return taken ? std::string(name) + "_" : name;
}

}  // namespace physgen::emit::cpp
