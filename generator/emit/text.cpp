// See text.h.
#include "emit/text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace physgen::emit {
namespace {

// To two digits, for people.
std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

// The same, but never less than the value: a bound.
std::string rounded_up(double value) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return rounded(std::ceil(value / digit) * digit);
}

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

// k of the power of two 2^k that brings the larger end of the range just below the largest number (of halves, into
// (16384, 32768]); 0 without a range, and for rotations, whose entries end at 1.
int scale_exponent(const model::Field& field, const model::EncodingFacts& encoding) {
  if (!field.range || field.shape == model::Shape::rotation) return 0;
  const double size = std::max(std::abs(field.range->low), std::abs(field.range->high));
  if (size == 0) return 0;
  int exponent = 0;
  const double mantissa = std::frexp(size, &exponent);  // size = mantissa * 2^exponent, mantissa in [0.5, 1)
  const int top = std::ilogb(encoding.largest);
  return std::clamp(exponent - (mantissa == 0.5 ? top + 1 : top), -model::max_exponent, model::max_exponent);
}

// Components of quaternions and entries of rotations lie between -1 and 1.
model::Range steps_range(const model::Field& field) {
  return field.shape == model::Shape::rotation || !field.range ? model::Range{-1, 1} : *field.range;
}

std::string encoded_type(const model::Field& field, const model::EncodingFacts& encoding) {
  const std::string prefix = "physgen::format::";
  std::string type = prefix + std::string(encoding.type);
  switch (encoding.scaling) {
    case model::Scaling::none:
      break;
    case model::Scaling::exponent: {
      const int exponent = scale_exponent(field, encoding);
      return type + "<" + (exponent == 0 ? "" : std::to_string(exponent)) + ">";
    }
    case model::Scaling::interval: {
      const model::Range range = steps_range(field);
      return type + "<" + prefix + "Interval{" + real(range.low) + ", " + real(range.high) + "}>";
    }
  }
  return type;
}

// "relative error up to 4.9e-4 for sizes from 6.1e-5 to 65504", "error up to 7.7e-6"
std::string describe_error(const model::Field& field, const model::EncodingFacts& encoding) {
  std::string relative = "relative error up to " + std::string(encoding.relative_error);
  switch (encoding.scaling) {
    case model::Scaling::none:
      break;
    case model::Scaling::exponent: {
      const double scale = std::ldexp(1.0, scale_exponent(field, encoding));
      return relative + " for sizes from " + rounded(encoding.least * scale) + " to " +
             rounded(encoding.largest * scale);
    }
    case model::Scaling::interval: {
      // Half a step, and the rounding of a float at the larger end, where it shows.
      const model::Range range = steps_range(field);
      const double half_step = range.high / (2.0 * encoding.steps) - range.low / (2.0 * encoding.steps);
      const double rounding = std::ldexp(std::max(std::abs(range.low), std::abs(range.high)), -23);
      return "error up to " + rounded_up(rounding < 0.02 * half_step ? half_step : half_step + rounding);
    }
  }
  return relative;
}

// "half, relative error up to ...", "16-bit steps over [-1, 1], error up to ...", "unit quaternion of halves, ..."
std::string describe_format(const model::Field& field, const model::Format& format) {
  const model::EncodingFacts& encoding = model::facts(format.encoding);
  if (format.quaternion) {
    const std::string of = encoding.components.empty() ? "" : " of " + std::string(encoding.components);
    return "unit quaternion" + of + ", error of an entry up to " + std::string(encoding.rotation_error);
  }
  if (encoding.name.empty()) return {};
  std::string text(encoding.name);
  if (encoding.scaling == model::Scaling::interval) {
    const model::Range range = steps_range(field);
    text += " over [" + number(range.low) + ", " + number(range.high) + "]";
  }
  return text + ", " + describe_error(field, encoding);
}

// "Stored as half, ...", where the schema says how.
std::string storage(const model::Field& field) {
  if (field.shape == model::Shape::object) return {};
  const std::string host = describe_format(field, field.host_format), cuda = describe_format(field, field.cuda_format);
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

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
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

std::string shape_type(const model::Field& field) {
  const model::ShapeFacts& shape = model::facts(field.shape);
  std::string type = "physgen::shape::" + std::string(shape.type);
  if (shape.sides == model::Sides::fixed) return type;
  const std::string columns = shape.sides == model::Sides::any ? ", " + std::to_string(field.cols) : "";
  return type + "<" + std::to_string(field.rows) + columns + ">";
}

std::string format_type(const model::Field& field, model::Space space) {
  const auto& [kind, quaternion] = field.format(space);
  const model::EncodingFacts& encoding = model::facts(kind);
  std::string name = encoded_type(field, encoding);
  if (!quaternion) return name;
  if (!encoding.quaternion.empty()) return "physgen::format::" + std::string(encoding.quaternion);
  return "physgen::format::Quaternion<" + (kind == model::Encoding::native ? "" : name) + ">";
}

std::string stored_as(const model::Field& field) {
  return shape_type(field) + ", typename Formats::" + field.name + ", " + stored_type(field.element);
}

std::string nested_type_name(const model::Field& field, const char* ending, const model::Object& user) {
  const auto colons = field.object.rfind("::");
  model::Object target;
  target.name = colons == std::string::npos ? field.object : field.object.substr(colons + 2);
  target.scope = colons == std::string::npos ? "" : field.object.substr(0, colons);
  return type_name(target, ending, user);
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

}  // namespace physgen::emit
