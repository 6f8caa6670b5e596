// The meaning of a field's formats: the power of two by which its numbers are scaled, the range of its steps, and the
// errors. A format is an encoding, the word of the schema, with these numbers.
#pragma once

#include <string>

#include "model/model.h"

namespace physgen::model {

/// The magnitude of the larger end of a range.
[[nodiscard]] double magnitude(const Range& range);

/// A value with so many digits, for people; `to`, std::ceil or std::floor, makes it a bound of positive values.
[[nodiscard]] std::string rounded(double value, int digits, double (*to)(double) = nullptr);

/// k of the power of two 2^k by which a format of Scaling::exponent scales: it brings the larger end of the field's
/// range just below the largest number of the encoding (of halves, into (16384, 32768]). 0 without a range, and for
/// rotations, whose entries end at 1.
[[nodiscard]] int scale_exponent(const Field& field, const EncodingFacts& encoding);

/// The range over which a format of Scaling::interval has its steps: the field's, but -1 to 1 for components of
/// quaternions and entries of rotations.
[[nodiscard]] Range steps_range(const Field& field);

/// How a format stores the field and what it loses, for people: "half, relative error up to ...", "16-bit steps over
/// [-1, 1], error up to ...", "unit quaternion of halves, ..."; empty: as it is computed.
[[nodiscard]] std::string describe_format(const Field& field, const Format& format);

}  // namespace physgen::model
