// The distribution of errors over many inputs: percentiles, the largest, and which input it came from. Never a mean
// alone: a method that fails once in a million is told from one that never fails by its tail only.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace physgen::fem::reference {

/// Percentiles of a distribution, in the unit of its errors. A NaN error counts as infinite.
struct ErrorSummary {
  double p50 = 0, p99 = 0, p9999 = 0, max = 0;
  std::int64_t count = 0;
  std::int64_t worst_index = -1;  ///< of the input with the largest error; -1 of nothing
};

class ErrorDistribution {
 public:
  void reserve(std::size_t count) { errors_.reserve(count); }

  /// @param index says which input it was; by default its place in the order of calls
  void add(double error, std::int64_t index = -1) {
    const double value = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
    if (index < 0) index = static_cast<std::int64_t>(errors_.size());
    if (worst_index_ < 0 || value > worst_) worst_ = value, worst_index_ = index;
    errors_.push_back(value);
  }

  /// The error that a fraction of all inputs does not exceed; 0 of nothing.
  [[nodiscard]] double percentile(double fraction) const {
    if (errors_.empty()) return 0;
    std::vector<double> values = errors_;
    const auto last = static_cast<double>(values.size() - 1);
    const auto k = static_cast<std::ptrdiff_t>(std::ceil(fraction * last));
    std::nth_element(values.begin(), values.begin() + k, values.end());
    return values[static_cast<std::size_t>(k)];
  }
  [[nodiscard]] double max() const { return worst_; }
  [[nodiscard]] std::int64_t worst_index() const { return worst_index_; }
  [[nodiscard]] ErrorSummary summary() const {
    return {percentile(0.5), percentile(0.99), percentile(0.9999), worst_, static_cast<std::int64_t>(errors_.size()),
            worst_index_};
  }

 private:
  std::vector<double> errors_;
  double worst_ = 0;
  std::int64_t worst_index_ = -1;
};

}  // namespace physgen::fem::reference
