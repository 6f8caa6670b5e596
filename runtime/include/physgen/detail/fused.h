// Makes up a fused kernel of the memory of its locals and its steps in their order.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/arrays/array.h>
#include <physgen/detail/check_numbers.h>
#include <physgen/detail/chosen_lanes.h>
#include <physgen/detail/local_cursor.h>
#include <physgen/detail/reduction.h>
#include <physgen/kernels/lanes.h>
#include <physgen/launch/in_lanes.h>

#include <concepts>
#include <type_traits>

namespace physgen {
template <class LocalList, class... Step>
struct Fused;  // fuse.h
}  // namespace physgen

namespace physgen::detail {

/// A fused kernel is called with single objects where all of its steps would be, but in checked builds, which look into
/// its packs.
template <class LocalList, class... Step>
inline constexpr bool kernel_suits_one_lane<Fused<LocalList, Step...>> =
    !checked_build && (kernel_suits_one_lane<Step> && ...);

/// The layouts of locals. They are types of their own, so that cursors know locals.
struct OneRecord : Aos {
  static constexpr bool of_locals = true;
  struct Pitch : StaticPitch<1> {
    using StaticPitch<1>::StaticPitch;
  };
};
template <int W>
struct OneTile : Aosoa<W> {
  static constexpr bool of_locals = true;
};

/// The record of a local, or its tile, for a plain index or a pack of type I.
template <class Local, class I, class Space>
struct LocalMemory {
  using Object = typename Local::Object;
  using Real = typename Local::Precision;
  using Formats = typename Local::template FormatsIn<Space>;
  static constexpr int width = index_width(I());
  using Layout = typename std::conditional_t<width == 1, std::type_identity<OneRecord>,
                                             std::type_identity<OneTile<width == 1 ? 2 : width>>>::type;
  using View = physgen::View<Object, Real, Layout, Formats, Space>;
  static constexpr int bytes = View::record_bytes * width;

  alignas(width == 1 ? 8 : 64) std::byte memory[bytes > 0 ? bytes : 1];  // NOLINT: not initialised

  /// @param i the pack, or one object of it
  template <class At>
  [[nodiscard]] PHYSGEN_FUNCTION auto object(const At& i) {
    using InTile = typename View::template CursorAt<At>;
    using Cursor = LocalObject<InTile, Local>;
    using Ref = typename Object::template Ref<Real, Formats, Cursor>;
    const typename Layout::Pitch pitch(width);
    if constexpr (std::is_integral_v<At>) {
      return Ref(Cursor(InTile(memory, pitch, static_cast<At>(i % width), nullptr)));
    } else {
      At in_tile = i;
      in_tile.begin = 0;
      return Ref(Cursor(InTile(memory, pitch, in_tile, nullptr)));
    }
  }

  /// Signalling NaN, or an index that no array has.
  PHYSGEN_FUNCTION void make_invalid() {
    constexpr std::size_t count = Object::template fields<Real, Formats>.size();
    [this]<std::size_t... f>(std::index_sequence<f...> /*which*/) {
      const int made[] = {(make_field_invalid<f>(), 0)...};  // a fold nests too deep for clang
      (void)made;
    }(std::make_index_sequence<count>());
  }

 private:
  template <std::size_t f>
  PHYSGEN_FUNCTION void make_field_invalid() {
    constexpr ElementType type = Object::template fields<Real, Formats>[f].type;
    constexpr int offset = Object::template fields<Real, Formats>[f].offset;
    constexpr int count = Object::template fields<Real, Formats>[f].count;
    constexpr std::uint64_t bits = bits_of_no_value(type);
    constexpr int size = element_bytes(type);
    for (int at = 0; at < count * width; ++at) {
      for (int b = 0; b < size; ++b) {
        memory[offset * width + at * size + b] = static_cast<std::byte>(bits >> (8 * b) & 0xff);
      }
    }
  }
};

/// The locals of one call of a fused kernel.
template <class I, class Space, class... Local>
struct Frame : LocalMemory<Local, I, Space>... {
  template <class Wanted>
  static constexpr bool has = (std::is_same_v<Wanted, Local> || ...);

  // Not defaulted, which might set memory to zero.
  PHYSGEN_FUNCTION Frame() {  // NOLINT: not initialised
#ifdef PHYSGEN_CHECKED
    (LocalMemory<Local, I, Space>::make_invalid(), ...);
#endif
  }
  template <class Wanted, class At>
  [[nodiscard]] PHYSGEN_FUNCTION auto object(const At& i) {
    return LocalMemory<Wanted, I, Space>::object(i);
  }
};

/// Whether one of the fused kernels that gave the index has the local.
template <class Index, class Local>
inline constexpr bool has_local = false;
template <class I, class Frame, class Local>
inline constexpr bool has_local<Own<I, Frame>, Local> = Frame::template has<Local> || has_local<I, Local>;

/// In checked builds, says which step runs until the result goes out of scope: see fused_accesses.h.
#if defined(PHYSGEN_CHECKED) && !defined(__CUDACC__)
template <class Step>
[[nodiscard]] RunStep begin_step() {
  return RunStep(at_step<Step>());
}
#else
struct NotWatched {};
template <class Step>
[[nodiscard]] PHYSGEN_FUNCTION constexpr NotWatched begin_step() {
  return {};
}
#endif

/// An object of this type says that the step takes the index. (Compilers put off what a function says.)
template <class Step, class Index>
struct TakesIndex {
  static_assert(std::invocable<const Step&, const Index&>,
                "fuse(): this step takes no packs, since its call operator is not a template over the index; run it by "
                "itself, over an array in the place of each local");
};

/// The index of object `at`, of those that a fused kernel's index stands for.
template <class Object, class I>
[[nodiscard]] PHYSGEN_FUNCTION Object at_object(const I& /*i*/, Object at) {
  return at;
}
template <class Object, class I, class Frame>
[[nodiscard]] PHYSGEN_FUNCTION auto at_object(const Own<I, Frame>& i, Object at) {
  return Own<decltype(at_object(i.index, at)), Frame>{at_object(i.index, at), i.frame};
}

/// Calls step(i) for the objects of a pack one by one.
template <class Step, class Index>
auto run_one_by_one(const Step& step, const Index& i) {
  constexpr int W = index_width(Index());
  const index_t begin = bare(i).begin;
  const LaneRange range = lane_range(i);
  if (false) (void)step(at_object(i, CheckedIndex()));  // as check_numbers() does
  if constexpr (std::is_void_v<std::invoke_result_t<const Step&, const Index&>>) {
    for (int l = range.first; l < range.last; ++l) step(at_object(i, begin + l));
  } else {
    using Term = std::remove_cvref_t<std::invoke_result_t<const Step&, const Index&>>;
    using One = std::remove_cvref_t<decltype(step(at_object(i, begin)))>;
    using Entry = typename Terms<Term>::Entry;
    alignas(64) lane_of_t<Entry> numbers[static_cast<std::size_t>(Terms<Term>::count)][W] = {};
    for (int l = range.first; l < range.last; ++l) {
      const One one = step(at_object(i, begin + l));
      for (int k = 0; k < Terms<Term>::count; ++k) numbers[k][l] = Terms<One>::entry(one, k);
    }
    Term term;
    for (int k = 0; k < Terms<Term>::count; ++k)
      const_cast<Entry&>(Terms<Term>::entry(term, k)) = Entry::load_unaligned(numbers[k]);
    return term;
  }
}

/// Calls a step of a fused kernel.
template <StepLanes kLanes, class Step, class Index>
PHYSGEN_FUNCTION decltype(auto) run_step(const Step& step, const Index& i) {
  (void)TakesIndex<Step, Index>();
  [[maybe_unused]] const auto here = begin_step<Step>();
  if constexpr (requires { typename Step::FusedSteps; }) {
    return step.template run<kLanes>(i);
  } else if constexpr (kLanes == StepLanes::chosen && index_width(Index()) > 1 && !checked_build &&
                       kernel_suits_one_lane<Step>) {
    return run_one_by_one(step, i);
  } else {
    return step(i);
  }
}

/// Kernels in their order; not a std::tuple, of which CUDA knows less.
template <class... Step>
struct Steps;
template <class Last>
struct Steps<Last> {
  using Scalar = typename Last::Scalar;
  Last step;

  template <StepLanes kLanes, class Index>
  PHYSGEN_FUNCTION decltype(auto) run(const Index& i) const {
    return run_step<kLanes>(step, i);
  }
};
template <class First, class... Rest>
struct Steps<First, Rest...> {
  using Others = typename Steps<Rest...>::Scalar;
  using Scalar = std::conditional_t<(sizeof(typename First::Scalar) < sizeof(Others)), Others, typename First::Scalar>;
  First step;
  Steps<Rest...> rest;

  template <StepLanes kLanes, class Index>
  PHYSGEN_FUNCTION decltype(auto) run(const Index& i) const {
    static_assert(std::is_void_v<decltype(run_step<kLanes>(step, i))>,
                  "fuse(): a step before the last one returns a term, which nothing would fold; make it the last");
    run_step<kLanes>(step, i);
    return rest.template run<kLanes>(i);
  }
};

template <class Step>
PHYSGEN_FUNCTION constexpr void check_scalar() {
  static_assert(
      requires { typename Step::Scalar; },
      "fuse(): a step needs a member type, `using Scalar = typename View::Precision;`, or over<float>(lambda)");
  static_assert(
      !states_lanes<Step>,
      "fuse(): this step states its lanes, but all steps of a fused kernel are called with the same; state those "
      "of the whole, lanes<W>(fuse(...))");
}

template <class... Local>
inline constexpr bool all_differ = true;
template <class First, class... Rest>
inline constexpr bool all_differ<First, Rest...> = !(std::is_same_v<First, Rest> || ...) && all_differ<Rest...>;

template <class Last>
[[nodiscard]] constexpr Steps<Last> steps_of(const Last& last) {
  return {last};
}
template <class First, class... Rest>
[[nodiscard]] constexpr Steps<First, Rest...> steps_of(const First& first, const Rest&... rest) {
  return {first, steps_of(rest...)};
}

}  // namespace physgen::detail

#pragma pop_macro("I")
