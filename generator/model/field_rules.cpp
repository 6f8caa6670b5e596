// See field_rules.h. One small function per rule.
#include "model/field_rules.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "model/format_rules.h"
#include "model/limits.h"
#include "model/text.h"

namespace physgen::model {
namespace {

bool check_sizes(const Field& field, const FieldReport& report) {
  const auto wrong = [&](const std::string& instead) {
    report(Aspect::type, "field " + in_quotes(field.name) + " has the type " + schema_type(field) + ", " + instead);
    return false;
  };
  const std::string limits = "whose sizes must be from 1 to " + std::to_string(max_side);
  const int rows = field.rows, cols = field.cols;
  if (rows < 1 || cols < 1) return wrong("which stores nothing; " + std::string("sizes must be at least 1"));
  if (rows > max_side || cols > max_side) return wrong(limits + "; keep larger matrices in objects of blocks");
  const ShapeFacts& shape = facts(field.shape);
  const std::string side = std::to_string(shape.side);
  const ElementFacts& element = facts(field.element);
  if (!shape.integers && element.integer) return wrong("whose elements must be real");
  if (field.shape == Shape::skew && element.unsigned_bits > 0)
    return wrong("half of whose entries are the negatives of stored ones, which " + std::string(element.schema) +
                 " does not have; write a Matrix");
  switch (shape.sides) {
    case Sides::fixed:
      return (rows == shape.side && cols == shape.side) || wrong("but rows and cols are not " + side);
    case Sides::column:
      return cols == 1 || wrong("but cols is not 1");
    case Sides::square:
      if (rows < shape.side)
        return wrong("which stores nothing; a " + std::string(shape.phrase) + " matrix has at least size " + side);
      return rows == cols || wrong("but rows and cols differ");
    case Sides::any:
      return true;
  }
  return true;
}

void check_unit(const std::string& unit, const FieldReport& report) {
  const auto unprintable = [](unsigned char c) { return c < 0x20 || c == 0x7f || c == '"' || c == '\\'; };
  if (unit.size() > 64 || std::any_of(unit.begin(), unit.end(), unprintable))
    report(Aspect::unit,
           "a unit is at most 64 printable characters without quotes and backslashes; write one such as "
           "unit(\"N/m^2\")");
}

void check_range(const Range& range, const FieldReport& report) {
  if (!std::isfinite(range.low) || !std::isfinite(range.high))
    report(Aspect::range, "both ends of a range must be finite; write the largest meaningful value instead");
  else if (range.low > range.high)
    report(Aspect::range, "range(" + number(range.low) + ", " + number(range.high) +
                              ") is empty; write the lower end first, range(" + number(range.high) + ", " +
                              number(range.low) + ")");
}

void check_initial(const Field& field, const FieldReport& report) {
  const double value = *field.initial;
  const ElementFacts& element = facts(field.element);
  const int bits = element.unsigned_bits > 0 ? element.unsigned_bits : 8 * element.bytes_with_double - 1;
  const double end = std::ldexp(1, bits), low = element.unsigned_bits > 0 ? 0 : -end;  // of integers
  const bool is_float = !element.integer && element.bytes_with_float == 4;             // or can be
  const auto wrong = [&](const std::string& why) {
    report(Aspect::initial, "initial(" + number(value) + ") is " + why);
  };
  const std::string elements = ", as the elements of " + in_quotes(field.name) + " are";
  if (!std::isfinite(value))
    report(Aspect::initial, "an initial value must be finite; leave initial() out for 0");
  else if (field.shape == Shape::rotation)
    report(Aspect::initial, "a matrix of equal elements is not a rotation; leave initial() out");
  else if (element.integer && (value != std::floor(value) || value < low || value >= end))
    wrong("not " + std::string(element.kind) + elements + "; write one");
  else if (is_float && std::abs(value) > FLT_MAX)
    wrong("not a float" + elements + " or can be; write a value from -" + number(FLT_MAX) + " to " + number(FLT_MAX) +
          ", or declare it double");
  else if (is_float && value != 0 && static_cast<float>(value) == 0)
    wrong("0 as a float" + elements + " or can be; write 0 or a size from 1.5e-45 on, or declare it double");
  else if (field.range && (value < field.range->low || value > field.range->high))
    wrong("outside range(" + number(field.range->low) + ", " + number(field.range->high) + "); change one of them");
}

void check_options(const Field& field, const FieldReport& report) {
  if (field.shape == Shape::object) {
    const std::string advice = " has no meaning for nested object " + in_quotes(field.name) +
                               "; write it at the fields of " + in_quotes(field.object);
    if (!field.unit.empty()) report(Aspect::unit, "unit()" + advice);
    if (field.range) report(Aspect::range, "range()" + advice);
    if (field.initial) report(Aspect::initial, "initial()" + advice);
    if (field.host_format != Format{}) report(Aspect::host_format, "format()" + advice);
    if (field.cuda_format != Format{}) report(Aspect::cuda_format, "format()" + advice);
    return;
  }
  check_unit(field.unit, report);
  if (field.range) check_range(*field.range, report);
  if (field.initial) check_initial(field, report);
  check_format(Aspect::host_format, field, field.host_format, report);
  check_format(Aspect::cuda_format, field, field.cuda_format, report);
}

}  // namespace

bool check_field(const Field& field, const FieldReport& report) {
  check_options(field, report);
  return field.shape != Shape::object && check_sizes(field, report);
}

}  // namespace physgen::model
