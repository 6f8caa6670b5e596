// Words to numbers and back, and the search for the kernel.
#include "measure/replay.h"

#include <physgen/error.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "measure/registry.h"

namespace physgen::bench {

namespace {

template <class Number>
std::string printed(const char* pattern, Number number) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, number);
  return text;
}

// strtof and strtod round once, and know hexadecimal digits, nan and inf.
template <class Real>
Real read_number(const std::string& word, const std::string& expected) {
  char* end = nullptr;
  Real value = 0;
  if constexpr (sizeof(Real) == sizeof(float)) {
    value = std::strtof(word.c_str(), &end);
  } else {
    value = std::strtod(word.c_str(), &end);
  }
  const bool wanted_infinity = word.find_first_of("iI") != std::string::npos;
  if (end == word.c_str() || *end != '\0') throw Error(expected + "; '" + word + "' is not a number");
  if (std::isinf(value) && !wanted_infinity) {
    throw Error(expected + "; " + word + " is out of the range of " + storage_name<Real>());
  }
  return value;
}

}  // namespace

std::string replay(const std::vector<std::string>& arguments) {
  std::string kernels;
  for (const ReplayWay& way : registry().replays) {
    const std::string word = " " + way.kernel;
    if ((kernels + " ").find(word + " ") == std::string::npos) kernels += word;
  }
  if (kernels.empty()) throw Error("this program cannot replay kernels; use physbench_errors or physbench");
  if (arguments.size() < 2) {
    throw Error("replay takes KERNEL STORAGE NUMBERS...; KERNEL is one of" + kernels + ", STORAGE float or double");
  }
  const std::string &kernel = arguments[0], &storage = arguments[1];
  if (storage != "float" && storage != "double") {
    throw Error("replay: the storage is float or double, not '" + storage + "'");
  }
  if ((kernels + " ").find(" " + kernel + " ") == std::string::npos) {
    throw Error("replay: there is no kernel '" + kernel + "'; there are" + kernels);
  }
  const std::vector<std::string> words(arguments.begin() + 2, arguments.end());
  std::string text;
  for (const ReplayWay& way : registry().replays) {
    if (way.kernel == kernel && way.storage == storage) text += way.run(words);
  }
  return text;
}

template <class Real>
std::string replay_command(const char* kernel, const std::vector<Real>& numbers) {
  std::string command = std::string("physbench replay ") + kernel + " " + storage_name<Real>();
  for (const Real number : numbers) command += printed(" %a", static_cast<double>(number));
  return command;
}

template <class Real>
std::vector<Real> read_numbers(const char* kernel, const std::vector<std::string>& words, std::size_t count,
                               const char* expected) {
  const std::string message = "replay " + std::string(kernel) + " takes " + expected;
  if (words.size() != count) throw Error(message + ", not " + std::to_string(words.size()));
  std::vector<Real> numbers;
  numbers.reserve(count);
  for (const std::string& word : words) numbers.push_back(read_number<Real>(word, message));
  return numbers;
}

template <class Real>
std::string replay_line(const std::string& name, const std::vector<Real>& numbers) {
  std::string line = "  " + name + std::string(name.size() < 6 ? 6 - name.size() : 1, ' ');
  for (const Real number : numbers) {
    const bool single = sizeof(Real) == sizeof(float);
    line += std::isnan(number) ? " nan" : printed(single ? " %.9g" : " %.17g", static_cast<double>(number));
  }
  return line + "\n";
}

std::string replay_number(double number) { return std::isnan(number) ? "nan" : printed("%.4g", number); }

template std::string replay_command(const char*, const std::vector<float>&);
template std::string replay_command(const char*, const std::vector<double>&);
template std::vector<float> read_numbers(const char*, const std::vector<std::string>&, std::size_t, const char*);
template std::vector<double> read_numbers(const char*, const std::vector<std::string>&, std::size_t, const char*);
template std::string replay_line(const std::string&, const std::vector<float>&);
template std::string replay_line(const std::string&, const std::vector<double>&);

}  // namespace physgen::bench
