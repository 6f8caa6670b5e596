// Calls kernels on the CPU: knows the width of their packs and keeps what they throw.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/chosen_lanes.h>
#include <physgen/detail/host_loop.h>
#include <physgen/simd/simd_lanes.h>

#include <concepts>
#include <type_traits>

namespace physgen::detail {

/// Whether this CPU has a register of W lanes of T.
template <class T, int W>
inline constexpr bool has_register =
    !std::is_void_v<typename xsimd::make_sized_batch<T, static_cast<std::size_t>(W)>::type>;

/// Lanes of the packs that a kernel over numbers of type Real is called with: those of the widest register, where this
/// CPU has registers of as many 32-bit lanes, too, for integer fields and floats; else 1.
template <class Real>
constexpr int pack_lanes() {
  constexpr int lanes = native_lanes<Real>;
  return has_register<std::int32_t, lanes> ? lanes : 1;
}

/// Lanes of the widest packs that the kernel takes; 1 where it takes none.
template <class Kernel>
constexpr int widest_lanes(std::type_identity<Kernel> /*kernel*/) {
  static_assert(
      requires { typename Kernel::Scalar; },
      "parallel_for() and parallel_reduce() must know whether this kernel takes packs: give a function object a member "
      "type, "
      "`using Scalar = typename View::Precision;`; write over<float>(lambda) for a generic lambda; or "
      "lanes<1>(kernel), which is called with one object at a time");
  if constexpr (requires { typename Kernel::Scalar; }) {
    constexpr int lanes = pack_lanes<typename Kernel::Scalar>();
    if constexpr (lanes > 1) {
      if constexpr (std::invocable<const Kernel&, Pack<lanes>>) return lanes;
    }
  }
  return 1;
}
template <int W, class Kernel>
constexpr int widest_lanes(std::type_identity<InLanes<W, Kernel>> /*kernel*/) {
  if constexpr (W == 1) {
    return 1;
  } else {
    return widest_lanes(std::type_identity<Kernel>());
  }
}

/// Whether W numbers of the kernel's Scalar, where it says one, lie in a register.
template <class Kernel, int W>
constexpr bool fits_registers() {
  if constexpr (requires { typename Kernel::Scalar; }) {
    return has_register<typename Kernel::Scalar, W>;
  } else {
    return true;
  }
}

/// The lanes that a kernel is called with: those of the rule in chosen_lanes.h, or those that lanes<W>() states.
template <class Kernel>
constexpr int chosen_lanes(std::type_identity<Kernel> kernel) {
  constexpr int widest = widest_lanes(kernel);
  return kernel_suits_one_lane<Kernel> ? 1 : widest;
}
template <int W, class Kernel>
constexpr int chosen_lanes(std::type_identity<InLanes<W, Kernel>> /*kernel*/) {
  if constexpr (W == 0) {
    return chosen_lanes(std::type_identity<Kernel>());
  } else if constexpr (W > 1 && padding_objects % W == 0) {  // else lanes() has said that it may not be
    constexpr bool takes_packs = std::invocable<const Kernel&, Pack<W>>;
    static_assert(
        takes_packs,
        "lanes<W>(kernel): this kernel takes single objects alone. Make its call operator a template over the "
        "index, `template <class I> void operator()(I i) const`, or write lanes<1>(kernel)");
    constexpr bool fits = fits_registers<Kernel, W>();
    static_assert(
        fits,
        "lanes<W>(kernel): this CPU has no register of W lanes of the kernel's Scalar; the widest that it has "
        "are those of packs by default");
    return takes_packs && fits ? W : 1;
  } else {
    return 1;
  }
}
template <class Kernel>
constexpr int lanes_of_calls() {
  return chosen_lanes(std::type_identity<Kernel>());
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
