// See text.h.
#include "emit/text.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace physgen::emit {
namespace {

std::string structure(const model::Field& field) {
  const auto stored = [&](const char* what) {
    return std::string(what) + ", " + std::to_string(model::element_count(field)) + " stored.";
  };
  switch (field.shape) {
    case model::Shape::symmetric:
      return stored("Symmetric");
    case model::Shape::diagonal:
      return stored("Diagonal");
    case model::Shape::skew:
      return stored("Skew-symmetric");
    case model::Shape::rotation:
      return stored("Rotation");
    default:
      return {};
  }
}

std::string values(const model::Field& field) {
  std::string text;
  if (field.range) text = "Range [" + number(field.range->low) + ", " + number(field.range->high) + "]";
  if (field.initial) text += (text.empty() ? "Initially " : "; initially ") + number(*field.initial);
  if (field.initial && !initial_in_value(field)) text += " in a new array";
  return text.empty() ? text : text + ".";
}

}  // namespace

bool initial_in_value(const model::Field& field) {
  return field.initial && field.array_extent == 0 && field.shape != model::Shape::skew;
}

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string bytes(plan::Bytes value) {
  if (value.with_float == value.with_double) return std::to_string(value.with_float);
  if (value.with_float % 4 == 0 && value.with_double == 2 * value.with_float) {
    return value.with_float == 4 ? "sizeof(Real)" : std::to_string(value.with_float / 4) + " * sizeof(Real)";
  }
  return "physgen::by_precision<Real>(" + std::to_string(value.with_float) + ", " + std::to_string(value.with_double) +
         ")";
}

std::string bytes_as_int(plan::Bytes value) {
  const std::string text = bytes(value);
  return text.find("sizeof") == std::string::npos ? text : "int{" + text + "}";
}

std::string stored_type(model::Element element) {
  switch (element) {
    case model::Element::real:
      return "Real";
    case model::Element::float32:
      return "float";
    case model::Element::float64:
      return "double";
    case model::Element::index:
    case model::Element::int32:
      break;
  }
  return "std::int32_t";
}

std::string value_type(model::Element element) {
  const std::string stored = stored_type(element);
  return element == model::Element::real ? stored : "physgen::same_lanes_t<Real, " + stored + ">";
}

std::string shape_type(const model::Field& field) {
  const std::string n = std::to_string(field.rows);
  const std::string shape = "physgen::shape::";
  switch (field.shape) {
    case model::Shape::vector:
      return shape + "Vector<" + n + ">";
    case model::Shape::matrix:
      return shape + "Matrix<" + n + ", " + std::to_string(field.cols) + ">";
    case model::Shape::symmetric:
      return shape + "Symmetric<" + n + ">";
    case model::Shape::diagonal:
      return shape + "Diagonal<" + n + ">";
    case model::Shape::skew:
      return shape + "Skew<" + n + ">";
    case model::Shape::rotation:
      return shape + "Rotation";
    case model::Shape::scalar:
    case model::Shape::object:
      break;
  }
  return shape + "Scalar";
}

std::string type_name(const model::Object& target, const char* ending, const model::Object& user) {
  const std::string name = target.name + ending;
  if (target.scope == user.scope) return name;
  return target.scope.empty() ? "::" + name : "::" + target.scope + "::" + name;
}

std::string field_comment(const model::Field& field) {
  std::string text = field.doc;
  bool ended = text.empty() || std::string_view(".!?:").find(text.back()) != std::string_view::npos;
  if (!field.unit.empty()) {
    ended = ended && !text.empty();
    text += (text.empty() ? "[" : " [") + field.unit + "]";
  }
  for (const std::string& sentence : {structure(field), values(field)}) {
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

}  // namespace physgen::emit
