// See formats.h.
#include "model/formats.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/text.h"

namespace physgen::model {
namespace {

// "relative error up to 4.9e-4 for sizes from 6.1e-5 to 65504", "error up to 7.7e-6"
std::string describe_error(const Field& field, const EncodingFacts& encoding) {
  std::string relative = "relative error up to " + std::string(encoding.relative_error);
  switch (encoding.scaling) {
    case Scaling::none:
      break;
    case Scaling::exponent: {
      const double scale = std::ldexp(1.0, scale_exponent(field, encoding));
      return relative + " for sizes from " + rounded(encoding.least * scale, 2) + " to " +
             rounded(encoding.largest * scale, 2);
    }
    case Scaling::interval: {
      // Half a step, and the rounding of a float at the larger end, where it shows.
      const Range range = steps_range(field);
      const double half_step = range.high / (2.0 * encoding.steps) - range.low / (2.0 * encoding.steps);
      const double rounding = std::ldexp(magnitude(range), -23);
      return "error up to " + rounded(rounding < 0.02 * half_step ? half_step : half_step + rounding, 2, std::ceil);
    }
  }
  return relative;
}

}  // namespace

double magnitude(const Range& range) { return std::max(std::abs(range.low), std::abs(range.high)); }

std::string rounded(double value, int digits, double (*to)(double)) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)) + 1 - digits);
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, to == nullptr ? value : to(value / digit) * digit);
  return text;
}

int scale_exponent(const Field& field, const EncodingFacts& encoding) {
  if (!field.range || field.shape == Shape::rotation) return 0;
  const double end = magnitude(*field.range);
  if (end == 0) return 0;
  int exponent = 0;
  const double mantissa = std::frexp(end, &exponent);  // end = mantissa * 2^exponent, mantissa in [0.5, 1)
  const int top = std::ilogb(encoding.largest);
  return std::clamp(exponent - (mantissa == 0.5 ? top + 1 : top), -max_exponent, max_exponent);
}

Range steps_range(const Field& field) {
  return field.shape == Shape::rotation || !field.range ? Range{-1, 1} : *field.range;
}

std::string describe_format(const Field& field, const Format& format) {
  const EncodingFacts& encoding = facts(format.encoding);
  if (format.quaternion) {
    const std::string of = encoding.components.empty() ? "" : " of " + std::string(encoding.components);
    return "unit quaternion" + of + ", error of an entry up to " + std::string(encoding.rotation_error);
  }
  if (encoding.name.empty()) return {};
  std::string text(encoding.name);
  if (encoding.scaling == Scaling::interval) {
    const Range range = steps_range(field);
    text += " over [" + number(range.low) + ", " + number(range.high) + "]";
  }
  return text + ", " + describe_error(field, encoding);
}

}  // namespace physgen::model
