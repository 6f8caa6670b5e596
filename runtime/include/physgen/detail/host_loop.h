// A loop over single objects on several threads, for functions of the host that are templates: without SIMD, so that
// CUDA translation units can include it. Kernels are run by <physgen/parallel_for.h>.
#pragma once

#include <physgen/detail/launch.h>
#include <physgen/error.h>
#include <physgen/memory/space.h>

#include <atomic>
#include <exception>
#include <string>

namespace physgen::detail {

/// @throw Error when a range begins before the first object
inline void check_range_of_launch(index_t begin) {
  if (begin < 0) throw Error("a kernel over objects from " + std::to_string(begin) + " on: the first object is 0");
}

/// Keeps the first exception that is thrown in a loop's work, which it must not leave, and throws it behind the loop.
class RegionFailure {
 public:
  template <class Work>
  void guard(const Work& work) {
    try {
      work();
    } catch (...) {
      if (!failed_.exchange(true)) failure_ = std::current_exception();
    }
  }
  /// @pre the loop is done
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::atomic<bool> failed_ = false;
  std::exception_ptr failure_;
};

/// Calls work(i) for i = 0 .. size-1 on several threads, and returns when all are done.
/// @throw what a call throws (the first to be caught), after all other calls have been made
template <class Work>
void host_loop(index_t size, const Work& work) {
  RegionFailure failure;
  for_each_index(0, size, [&](index_t i) { failure.guard([&] { work(i); }); });
  failure.rethrow();
}

}  // namespace physgen::detail
