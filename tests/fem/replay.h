// Numbers of a failed test as text and back: printed with every digit, and read from the environment to be run alone.
#pragma once

#include <fem/numerics/scalar.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

namespace physgen::fem {

/// "0x1.8p+0 0x1p+0 0x1p-1": every digit.
template <std::size_t count>
std::string hexadecimal(const std::array<double, count>& numbers) {
  std::string result;
  for (const double x : numbers) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%s%a", result.empty() ? "" : " ", x);
    result += text.data();
  }
  return result;
}

/// "physbench replay svd float 0x1p+0 ...": shows what every way to decompose A makes of it.
template <class Real>
std::string replay_command(const Matrix3<Real>& A) {
  std::array<double, 9> numbers{};
  std::copy_n(A.data(), 9, numbers.begin());
  return std::string("physbench replay svd ") + (sizeof(Real) == sizeof(float) ? "float " : "double ") +
         hexadecimal(numbers);
}

/// The numbers in an environment variable, as hexadecimal() prints them; nothing when it is not set.
template <std::size_t count>
std::optional<std::array<double, count>> replayed(const char* variable) {
  const char* given = std::getenv(variable);
  if (given == nullptr) return std::nullopt;
  std::array<double, count> numbers{};
  char* at = const_cast<char*>(given);  // strtod's end pointer; nothing is written
  for (double& x : numbers) x = std::strtod(at, &at);
  return numbers;
}

/// The largest error and the input it came from; a NaN error is the largest of all.
template <std::size_t count>
class WorstInput {
 public:
  void add(double error, const std::array<double, count>& input) {
    if (error <= error_ || error_ != error_) return;
    error_ = error;
    input_ = input;
  }
  [[nodiscard]] double error() const { return error_; }
  /// `NAME="0x1p+0 ..."`, to be put before the test's command.
  [[nodiscard]] std::string replay(const char* variable) const {
    return std::string(variable) + "=\"" + hexadecimal(input_) + "\"";
  }

 private:
  double error_ = -1;
  std::array<double, count> input_{};
};

}  // namespace physgen::fem
