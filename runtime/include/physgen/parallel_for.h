// Runs a kernel over objects on the CPU: on several threads, each over SIMD packs where the kernel can take them.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/check_numbers.h>
#include <physgen/detail/host_loop.h>
#include <physgen/detail/kernel_calls.h>
#include <physgen/detail/simd_rows.h>
#include <physgen/kernels/add.h>
#include <physgen/launch/in_lanes.h>
#include <physgen/layout.h>
#include <physgen/memory/space.h>
#include <physgen/simd/simd_lanes.h>

#include <array>

namespace physgen {

/// A generic lambda as a kernel over packs of Real: `parallel_for(Host{}, n, over<float>([=](auto i) { ... }))`.
template <class Real, class Body>
struct Over {
  using Scalar = Real;
  Body body;
  template <class I>
  PHYSGEN_FUNCTION auto operator()(const I& i) const {
    return body(i);
  }
};
template <class Real, class Body>
[[nodiscard]] Over<Real, Body> over(const Body& body) {
  return {body};
}

/// Calls kernel(i) for the objects begin .. end-1, on threads() threads (threads.h), and returns when all are done.
///
/// A kernel with a member type Scalar and a templated call operator is called with Pack<W> for W objects at once, W
/// being as many as fit the widest register; where the range does not fill the first or the last pack, with
/// PartialPack<W>, which sees and changes objects of the range only. A kernel that would lose by packs, as
/// detail/chosen_lanes.h tells from its type, one that takes index_t alone, and one of doubles where the CPU has no
/// register of as few integers (x86-64 without AVX), is called with one object at a time. lanes<W>(kernel) states W.
/// A kernel with a Scalar and a templated call operator is compiled over numbers that refuse a double beside a float,
/// too, as packs do; see check_numbers.h.
/// @pre the range lies in the arrays whose objects the kernel writes; no two calls write the same object, unless by
/// add()
/// @throw what a call throws (the first to be caught), after all other calls have been made
template <class Kernel>
void parallel_for(Host /*space*/, index_t begin, index_t end, const Kernel& kernel) {
  constexpr int width = detail::lanes_of_calls<Kernel>();
  detail::check_range_of_launch(begin);
  if (begin >= end) return;
  const detail::RunLanes outer({});  // where a kernel calls this
  detail::LaunchFailure failure;
  if constexpr (width == 1) {
    detail::check_numbers(kernel);
    detail::for_each_index(begin, end, [&](index_t i) { detail::call_guarded(i, failure, [&] { kernel(i); }); });
  } else {
    const index_t first = align_up(begin, index_t{width}) / width, last = end / width;  // whole packs
    detail::for_each_index<width>(first, last, [&](index_t p) {
      const Pack<width> pack{p * width};
      detail::call_guarded(pack, failure, [&] { kernel(pack); });
    });
    // One loop, so that the kernel is compiled once for partial packs.
    const std::array<index_t, 2> ends{begin / width, last};
    for (std::size_t e = begin % width == 0 || ends[0] == ends[1] ? 1 : 0; e < 2; ++e) {
      if (ends[e] * width < end) detail::call_seldom(failure, kernel, partial_pack<width>(ends[e] * width, begin, end));
    }
  }
  failure.rethrow();
}

/// The same for the objects 0 .. size-1.
template <class Kernel>
void parallel_for(Host space, index_t size, const Kernel& kernel) {
  parallel_for(space, 0, size, kernel);
}

}  // namespace physgen

#pragma pop_macro("I")
