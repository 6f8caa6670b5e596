// A loop over single objects on all OpenMP threads, for functions of the host that are templates: without SIMD, so that
// CUDA translation units can include it. Kernels are run by <physgen/parallel_for.h>.
#pragma once

#include <physgen/error.h>
#include <physgen/space.h>

#include <exception>
#include <string>

namespace physgen::detail {

/// @throw Error when a range begins before the first object
inline void check_range_of_launch(index_t begin) {
  if (begin < 0) throw Error("a kernel over objects from " + std::to_string(begin) + " on: the first object is 0");
}

/// Fewer objects than this are done before other threads have woken up.
inline constexpr index_t worth_threads = 8192;

/// Keeps the first exception that is thrown in an OpenMP region, which it must not leave, and throws it behind it.
class RegionFailure {
 public:
  template <class Work>
  void guard(const Work& work) {
    try {
      work();
    } catch (...) {
#pragma omp critical(physgen_region_failure)
      if (!failure_) failure_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::exception_ptr failure_;
};

/// Calls work(i) for i = 0 .. size-1 on all OpenMP threads, and returns when all are done.
/// @throw what a call throws (the first to be caught), after all other calls have been made
template <class Work>
void host_loop(index_t size, const Work& work) {
  RegionFailure failure;
#pragma omp parallel for schedule(static) if (size >= worth_threads)
  for (index_t i = 0; i < size; ++i) {
    failure.guard([&] { work(i); });
  }
  failure.rethrow();
}

}  // namespace physgen::detail
