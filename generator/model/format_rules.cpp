// See format_rules.h.
#include "model/format_rules.h"

#include <algorithm>
#include <cmath>

#include "model/formats.h"
#include "model/text.h"

namespace physgen::model {
namespace {

// Stated values that the format would lose, be it scaled.
void check_magnitudes(Aspect aspect, const Field& field, const EncodingFacts& encoding, const FieldReport& report) {
  if (field.shape == Shape::rotation) return;
  if (encoding.scaling == Scaling::interval && facts(field.element).bytes_with_float == 8) return;  // in double
  const double end = field.range ? magnitude(*field.range) : 0;
  const double largest = std::max(end, std::abs(field.initial.value_or(0)));
  const bool scales = encoding.scaling == Scaling::exponent;
  const int top = scales ? std::ilogb(encoding.largest) : 0;  // of the largest power of two
  const double limit = scales ? std::ldexp(1, max_exponent + top) : encoding.largest;
  const double least = scales ? std::ldexp(1, top - 1 - max_exponent) : 0;
  const bool too_small = end > 0 && end < least;
  if (largest <= limit && !too_small) return;
  report(aspect, std::string(end > limit || too_small ? "the range" : "the initial value") + " of " +
                     in_quotes(field.name) + " is beyond what this format holds, " +
                     (too_small ? "ranges that end above " + rounded(least, 3, std::ceil)
                                : "sizes up to " + rounded(limit, 3, std::floor)) +
                     "; choose float64");
}

}  // namespace

void check_format(Aspect aspect, const Field& field, const Format& format, const FieldReport& report) {
  if (format == Format{}) return;
  const EncodingFacts& encoding = facts(format.encoding);
  const std::string word(encoding.word);
  const bool in_steps = encoding.scaling == Scaling::interval && field.shape != Shape::rotation;
  if (facts(field.element).integer)
    report(aspect, "the elements of " + in_quotes(field.name) + " are " +
                       (field.element == Element::boolean ? "bool, which has" : "integers, which have") +
                       " no other format; leave it out");
  else if (format.quaternion && field.shape != Shape::rotation)
    report(aspect,
           "only a Rotation can be stored as a quaternion; " + in_quotes(field.name) + " is a " + schema_type(field));
  else if (in_steps && !field.range)
    report(aspect, word + " has equal steps over a range, and " + in_quotes(field.name) +
                       " states none; add one, such as range(-1, 1)");
  else if (in_steps && !(field.range->low < field.range->high))
    report(aspect,
           word + " has equal steps over a range of more than one value; widen the range of " + in_quotes(field.name));
  else if (in_steps && !field.initial && (field.range->low > 0 || field.range->high < 0))
    report(aspect, "new objects hold 0 where no initial() is stated, which " + word + " over range(" +
                       number(field.range->low) + ", " + number(field.range->high) + ") does not hold; add initial(" +
                       number(field.range->low > 0 ? field.range->low : field.range->high) +
                       ") or another value of the range to " + in_quotes(field.name) + ", or widen the range to 0");
  else if (encoding.scaling == Scaling::exponent && field.initial && std::abs(*field.initial) > encoding.largest &&
           !field.range)
    report(aspect, "initial(" + number(*field.initial) + ") does not fit " + word + ", whose largest number is " +
                       number(encoding.largest) + "; add range(...) to " + in_quotes(field.name) +
                       ", so that it is scaled");
  else
    check_magnitudes(aspect, field, encoding, report);
}

}  // namespace physgen::model
