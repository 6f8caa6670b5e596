// States how many objects the CPU calls a kernel with at once, where the library's choice (detail/chosen_lanes.h) is
// not wanted: `lanes<1>(kernel)`, `lanes<8>(kernel)`. It is a kernel itself, so all words take it: parallel_for(),
// parallel_reduce(), sum() and the other short forms, run() and reduce() of executors. Results have the same bits for
// any number of lanes, but where the functions that a kernel calls differ (runtime/README.md, Lanes).
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/config.h>
#include <physgen/detail/scalar_of.h>
#include <physgen/detail/step_lanes.h>

#include <concepts>

namespace physgen {

/// The kernel that lanes<W>() makes.
template <int W, class Kernel>
struct InLanes : detail::ScalarOf<Kernel> {
  Kernel kernel;

  PHYSGEN_FUNCTION constexpr explicit InLanes(const Kernel& given) : kernel(given) {}
  template <class I>
    requires(requires { typename Kernel::FusedSteps; } || std::invocable<const Kernel&, const I&>)
  PHYSGEN_FUNCTION decltype(auto) operator()(const I& i) const {
    if constexpr (requires { typename Kernel::FusedSteps; }) {
      return kernel.template run<W == 0 ? detail::StepLanes::chosen : detail::StepLanes::stated>(i);
    } else {
      return kernel(i);
    }
  }
};

/// The same kernel, called with Pack<W> for W objects at once, or for W = 1 with index_t; W = 0 leaves the choice to
/// the library. A thread of CUDA has one object, whatever is stated.
///
/// W is 1, 2, 4, 8, 16 or 32, and no more than this CPU's registers hold of the kernel's Scalar. For W > 1 the kernel's
/// call operator is a template on its index. lanes<1>() takes any kernel, also one without a Scalar.
template <int W, class Kernel>
[[nodiscard]] constexpr InLanes<W, Kernel> lanes(const Kernel& kernel) {
  static_assert(
      W == 0 || W == 1 || W == 2 || W == 4 || W == 8 || W == 16 || W == 32,
      "lanes<W>(kernel): packs have 1, 2, 4, 8, 16 or 32 lanes, so that each lies in the padding of arrays and "
      "sums have the same order for all");
  return InLanes<W, Kernel>(kernel);
}

namespace detail {

template <class Kernel>
inline constexpr bool states_lanes = false;
template <int W, class Kernel>
inline constexpr bool states_lanes<InLanes<W, Kernel>> = true;

}  // namespace detail

}  // namespace physgen

#pragma pop_macro("I")
