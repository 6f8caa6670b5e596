// See text.h.
#include "emit/text.h"

#include <algorithm>
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

// k of the power of two 2^k that brings the larger end of the range into (16384, 32768]; 0 without a range, and for
// rotations, whose entries end at 1.
int half_exponent(const model::Field& field) {
  if (!field.range || field.shape == model::Shape::rotation) return 0;
  const double size = std::max(std::abs(field.range->low), std::abs(field.range->high));
  if (size == 0) return 0;
  int exponent = 0;
  const double mantissa = std::frexp(size, &exponent);  // size = mantissa * 2^exponent, mantissa in [0.5, 1)
  return std::clamp(exponent - (mantissa == 0.5 ? 16 : 15), -100, 100);
}

// Components of quaternions and entries of rotations lie between -1 and 1.
model::Range steps_range(const model::Field& field) {
  return field.shape == model::Shape::rotation || !field.range ? model::Range{-1, 1} : *field.range;
}

std::string encoded_type(const model::Field& field, model::Encoding encoding) {
  const std::string prefix = "physgen::format::";
  switch (encoding) {
    case model::Encoding::native:
      return prefix + "Native";
    case model::Encoding::float32:
      return prefix + "Float32";
    case model::Encoding::float64:
      return prefix + "Float64";
    case model::Encoding::bfloat16:
      return prefix + "Bfloat16";
    case model::Encoding::half: {
      const int exponent = half_exponent(field);
      return prefix + "Half<" + (exponent == 0 ? "" : std::to_string(exponent)) + ">";
    }
    case model::Encoding::snorm16:
      break;
  }
  const model::Range range = steps_range(field);
  return prefix + "Snorm16<" + prefix + "Interval{" + real(range.low) + ", " + real(range.high) + "}>";
}

// "half, relative error up to 4.9e-4 (up to 32768 and from 6.1e-5 on)"
std::string describe_format(const model::Field& field, const model::Format& format) {
  std::string text = format.quaternion ? "unit quaternion" : "";
  const auto say = [&](const std::string& plain, const char* component, const char* matrix_error) {
    if (format.quaternion) return text + component + ", error of an entry up to " + matrix_error;
    return plain;
  };
  switch (format.encoding) {
    case model::Encoding::native:
      return say("", "", "10 eps");
    case model::Encoding::float32:
      return say("float, relative error up to 6e-8", " of floats", "1.2e-6");
    case model::Encoding::float64:
      return say("double, relative error up to 1.2e-16", " of doubles", "10 eps");
    case model::Encoding::bfloat16:
      return say("bfloat16, relative error up to 3.9e-3", " of bfloat16", "1.6e-2");
    case model::Encoding::half: {
      const double scale = std::ldexp(1.0, half_exponent(field));
      return say("half, relative error up to 4.9e-4 for sizes from " + rounded(6.104e-5 * scale) + " to " +
                     rounded(65504 * scale),
                 " of halves", "2e-3");
    }
    case model::Encoding::snorm16:
      break;
  }
  const model::Range range = steps_range(field);
  // Half a step, and the rounding of a float at the larger end, where it shows.
  const double half_step = range.high / 131068 - range.low / 131068;
  const double rounding = std::ldexp(std::max(std::abs(range.low), std::abs(range.high)), -23);
  return say("16-bit steps over [" + number(range.low) + ", " + number(range.high) + "], error up to " +
                 rounded_up(rounding < 0.02 * half_step ? half_step : half_step + rounding),
             " of 16-bit steps", "9e-5");
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
  return field.initial && field.array_extent == 0 && field.shape != model::Shape::skew;
}

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string real(double value) {
  const std::string text = number(value);
  return text + (text.find_first_of(".e") == std::string::npos ? ".0" : "");
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

bool has_format(const model::Field& field) {
  return field.shape == model::Shape::object ||
         (field.element != model::Element::index && field.element != model::Element::int32);
}

std::string format_type(const model::Field& field, model::Space space) {
  const auto& [encoding, quaternion] = field.format(space);
  const std::string name = encoded_type(field, encoding);
  if (!quaternion) return name;
  if (encoding == model::Encoding::snorm16) return "physgen::format::Quaternion16";
  return "physgen::format::Quaternion<" + (encoding == model::Encoding::native ? "" : name) + ">";
}

std::string stored_as(const model::Field& field) {
  const std::string format = has_format(field) ? "typename Formats::" + field.name : "physgen::format::Native";
  return shape_type(field) + ", " + format + ", " + stored_type(field.element);
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
