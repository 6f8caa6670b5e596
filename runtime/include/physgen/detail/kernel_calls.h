// Calls kernels on the CPU: chooses the width of their packs and keeps what they throw.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/host_loop.h>
#include <physgen/simd_lanes.h>

#include <concepts>
#include <type_traits>

namespace physgen::detail {

/// Lanes of the packs that a kernel over numbers of type Real is called with: those of the widest register, where this
/// CPU has registers of as many 32-bit lanes, too, for integer fields and floats; else 1.
template <class Real>
constexpr int pack_lanes() {
  constexpr int lanes = native_lanes<Real>;
  using Integers = typename xsimd::make_sized_batch<std::int32_t, static_cast<std::size_t>(lanes)>::type;
  return std::is_void_v<Integers> ? 1 : lanes;
}

template <class Kernel>
constexpr int default_lanes() {
  static_assert(
      requires { typename Kernel::Scalar; },
      "parallel_for() and parallel_reduce() must know whether this kernel takes packs: give a function object a member "
      "type, "
      "`using Scalar = typename View::Precision;`; write over<float>(lambda) for a generic lambda; or "
      "parallel_for<1>(...), which calls it with one object at a time");
  if constexpr (requires { typename Kernel::Scalar; }) {
    constexpr int lanes = pack_lanes<typename Kernel::Scalar>();
    if constexpr (lanes > 1) {
      if constexpr (std::invocable<const Kernel&, Pack<lanes>>) return lanes;
    }
  }
  return 1;
}

/// kLanes, or where that is 0 the lanes that suit the kernel.
template <int kLanes, class Kernel>
constexpr int lanes_of_calls() {
  if constexpr (kLanes == 0) {
    return default_lanes<Kernel>();
  } else {
    return kLanes;
  }
}

/// In place of RunLanes where all lanes run.
struct AllLanes {
  explicit AllLanes(const RunningLanes& /*lanes*/) {}
};

#ifdef PHYSGEN_CHECKED
/// A launch's memory of its calls: the exception that they throw, and what the steps of a fused kernel do.
struct LaunchFailure : RegionFailure {
  FusedAccesses accesses;

  /// Says that a kernel is called with i, until the result goes out of scope.
  template <class I>
  [[nodiscard]] RunStep runs(const I& i) {
    RunningStep step;
    if constexpr (!std::is_integral_v<I>)
      step = {.launch = &accesses, .begin = i.begin, .range = lane_range(i), .width = index_width(i)};
    return RunStep(step);
  }
};
#else
struct LaunchFailure : RegionFailure {
  struct Nothing {};
  template <class I>
  [[nodiscard]] static Nothing runs(const I& /*i*/) {
    return {};
  }
};
#endif

/// Calls work(), which calls a kernel with i; keeps what it throws, and says which lanes run.
template <class I, class Work>
void call_guarded([[maybe_unused]] const I& i, LaunchFailure& failure, const Work& work) {
  failure.guard([&] {
    constexpr bool partial = requires { i.first; };
    using Set = std::conditional_t<checked_build || partial, RunLanes, AllLanes>;
    [[maybe_unused]] const auto runs = failure.runs(i);
    [[maybe_unused]] const Set set(RunningLanes{lane_range(i), index_width(i)});
    work();
  });
}

/// Calls kernel(i), compiled for size: at the ends of a range.
template <class Kernel, class I>
[[gnu::cold, gnu::noinline]] void call_seldom(LaunchFailure& failure, const Kernel& kernel, const I& i) {
  call_guarded(i, failure, [&] { kernel(i); });
}

}  // namespace physgen::detail

#pragma pop_macro("I")
