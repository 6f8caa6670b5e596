// Runs a kernel again on one input, such as the worst of a set: `physbench replay KERNEL STORAGE NUMBERS...`.
#pragma once

#include <string>
#include <vector>

namespace physgen::bench {

/// @param arguments after `replay`: kernel, storage, numbers
/// @return what to print: the input, the reference, and what each way of running the kernel makes of it
/// @throw Error saying what is expected, for a kernel or a storage that does not exist and for wrong numbers
[[nodiscard]] std::string replay(const std::vector<std::string>& arguments);

/// `physbench replay KERNEL STORAGE NUMBERS...`, the numbers in hexadecimal, so exact.
template <class Real>
[[nodiscard]] std::string replay_command(const char* kernel, const std::vector<Real>& numbers);

/// Decimal, hexadecimal, nan or inf, rounded to Real.
/// @param expected what the numbers mean, for the message
/// @throw Error when they are not `count` numbers of the range of Real
template <class Real>
[[nodiscard]] std::vector<Real> read_numbers(const char* kernel, const std::vector<std::string>& words,
                                             std::size_t count, const char* expected);

/// "  name  1.5 2.25 ...\n", decimal with all digits.
template <class Real>
[[nodiscard]] std::string replay_line(const std::string& name, const std::vector<Real>& numbers);
/// "1.234"
[[nodiscard]] std::string replay_number(double number);

}  // namespace physgen::bench
