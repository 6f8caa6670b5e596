// See thread_environment.h.
#include "thread_environment.h"

#include <physgen/launch/processors.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

namespace physgen::detail {

namespace {

/// The first number of a list such as "4,2", whose others are for loops within loops. @return 0 where it is none
int first_number(std::string_view words) {
  words = words.substr(0, words.find(','));
  const auto begin = words.find_first_not_of(" \t"), end = words.find_last_not_of(" \t");
  if (begin == std::string_view::npos) return 0;
  words = words.substr(begin, end - begin + 1);
  int number = 0;
  const auto [rest, error] = std::from_chars(words.data(), words.data() + words.size(), number);
  if (error != std::errc() || rest != words.data() + words.size() || number < 1) return 0;
  return std::min(number, most_threads);
}

/// The number of a variable, or 0 where it is not set, or no number, which is remarked.
int number_of(const char* variable, const char* value, std::string& remark) {
  if (value == nullptr || *value == '\0') return 0;
  const int number = first_number(value);
  if (number == 0) {
    if (!remark.empty()) remark += "; ";
    remark += std::string(variable) + "=" + value + " is not a number of threads and is ignored";
  }
  return number;
}

}  // namespace

ThreadEnvironment read_thread_environment(const char* number, const char* limit, int processors) {
  ThreadEnvironment made{.count = processors, .processors = processors, .remark = ""};
  const int wanted = number_of("OMP_NUM_THREADS", number, made.remark);
  const int most = number_of("OMP_THREAD_LIMIT", limit, made.remark);
  if (wanted > 0) made.count = wanted;
  if (most > 0 && most < made.count) {
    if (wanted > 0) {
      made.remark = "OMP_NUM_THREADS=" + std::to_string(wanted) +
                    " is more than OMP_THREAD_LIMIT=" + std::to_string(most) + ", which wins";
    }
    made.count = most;
  }
  return made;
}

const ThreadEnvironment& thread_environment() {
  static const ThreadEnvironment* const environment = new ThreadEnvironment(
      read_thread_environment(std::getenv("OMP_NUM_THREADS"), std::getenv("OMP_THREAD_LIMIT"), allowed_processors()));
  return *environment;
}

std::string remark_on(const ThreadEnvironment& environment, int asked, int count) {
  std::string remark = asked > 0 ? "" : environment.remark;
  if (count > environment.processors) {
    if (!remark.empty()) remark += "; ";
    const bool one = environment.processors == 1;
    remark += std::to_string(count) + " threads share the " + std::to_string(environment.processors) +
              (one ? " processor" : " processors") +
              " that this process may use (its affinity and its control groups say so): more threads are no faster";
  }
  return remark;
}

}  // namespace physgen::detail
