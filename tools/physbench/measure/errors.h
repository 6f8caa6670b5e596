// Checks of results: that everything was written, and how far it is from the reference.
#pragma once

#include <physgen/arrays/untyped_array.h>

#include <vector>

#include "measure/row.h"

namespace physgen::bench {

/// Fills an array in host memory, padding included, with ones in every bit: not a number as float and as double.
void poison(const UntypedArray& array);

/// @pre the array is in host memory, its elements float or double
/// @throw Error naming the first object that has an element which is not a number
void check_written(const UntypedArray& array);

/// The distribution of errors[i] / max(norms[i], 1e-3 rms(norms)): the floor keeps results that nearly cancel from
/// being measured against zero.
[[nodiscard]] Accuracy relative_errors(std::vector<double> errors, const std::vector<double>& norms);

/// The median, 0 of nothing.
[[nodiscard]] double median(const std::vector<double>& values);

}  // namespace physgen::bench
