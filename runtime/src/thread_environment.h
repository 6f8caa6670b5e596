// What the environment says of the number of threads: OpenMP's variables, which users know.
#pragma once

#include <string>

namespace physgen::detail {

inline constexpr int most_threads = 4096;

struct ThreadEnvironment {
  int count = 1;       ///< of threads, where the program asks for none
  int processors = 1;  ///< that the process may use
  std::string remark;  ///< what is wrong with the variables; empty where nothing is
};

/// @param number, limit OMP_NUM_THREADS and OMP_THREAD_LIMIT; null where they are not set
[[nodiscard]] ThreadEnvironment read_thread_environment(const char* number, const char* limit, int processors);

/// That of this process, read once.
[[nodiscard]] const ThreadEnvironment& thread_environment();

/// See remark_on_threads(). @param asked by the program, or 0 @param count the threads that there are
[[nodiscard]] std::string remark_on(const ThreadEnvironment& environment, int asked, int count);

}  // namespace physgen::detail
