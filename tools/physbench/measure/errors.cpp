// Poisoning, the search for unwritten elements, and percentiles.
#include "measure/errors.h"

#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace physgen::bench {

namespace {

template <class Real>
bool all_numbers(const std::byte* tile, index_t elements) {
  const auto* values = reinterpret_cast<const Real*>(tile);
  return std::none_of(values, values + elements, [](Real x) { return std::isnan(x); });
}

}  // namespace

void poison(const UntypedArray& array) { std::memset(array.base, 0xff, static_cast<std::size_t>(array.bytes())); }

void check_written(const UntypedArray& array) {
  for (const FieldInfo& field : array.fields) {
    if (!field.is_stored()) continue;
    const int size = element_bytes(field.type);
    for (index_t begin = 0; begin < array.size; begin += array.pitch) {
      const index_t lanes = std::min(array.pitch, array.size - begin);
      for (int k = 0; k < field.count; ++k) {
        const std::byte* row = array.address(begin, field.offset + k * size, size);
        if (size == 4 ? all_numbers<float>(row, lanes) : all_numbers<double>(row, lanes)) continue;
        throw Error(std::string(array.object) + "." + std::string(field.name) + ": element " + std::to_string(k) +
                    " was not written, or is not a number, in an object of " + std::to_string(begin) + " to " +
                    std::to_string(begin + lanes - 1));
      }
    }
  }
}

Accuracy relative_errors(std::vector<double> errors, const std::vector<double>& norms) {
  if (errors.empty()) return {};
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (std::isfinite(errors[i]) && std::isfinite(norms[i])) continue;
    throw Error("the error of object " + std::to_string(i) + " is not a number: the result or its reference is not");
  }
  double squares = 0;
  for (const double norm : norms) squares += norm * norm;
  const double floor = 1e-3 * std::sqrt(squares / static_cast<double>(norms.size()));
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double scale = std::max(norms[i], floor);
    if (scale > 0) errors[i] /= scale;
  }
  fem::reference::ErrorDistribution distribution;
  distribution.reserve(errors.size());
  for (const double error : errors) distribution.add(error);
  Accuracy accuracy;
  accuracy.errors = distribution.summary();
  return accuracy;
}

double median(const std::vector<double>& values) {
  fem::reference::ErrorDistribution distribution;
  for (const double value : values) distribution.add(value);
  return distribution.percentile(0.5);
}

}  // namespace physgen::bench
