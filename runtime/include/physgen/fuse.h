// Several kernels as one, which stores nothing of what only they share: `fuse(locals(F, svd), first, second, third)`.
// What stands in a local takes the place of an array: in registers of a CUDA thread, in a tile of W objects on the
// stack of a CPU's thread. Kernels are the same as over arrays, and their results have the same bits (where compilers
// contract no products with sums across them: -ffp-contract=off, --fmad=false).
//
//   const auto F = local<elasticity::DeformationGradientObject, float>();
//   const auto svd = local<elasticity::DeformationSvdObject, float>();
//   parallel_for(Host{}, n, fuse(locals(F, svd), fem::ComputeDeformationGradient{tets, positions, rest, F},
//                                fem::ComputeSvd{F, svd}, fem::ComputeStress{material, svd, stress.view()}));
#pragma once

#include <physgen/array.h>
#include <physgen/lanes.h>

#include <concepts>

namespace physgen {

/// The formats that the schema states for the space in which a kernel runs.
struct FormatsOfSpace;

/// What fused kernels take in the place of a view, made by local(). It is empty, and holds no object: each call of a
/// fused kernel has its own. A kernel writes local[i] before a later one of the group reads it.
template <class Object, class Real, class Formats, class Tag>
struct Local {
  using Precision = Real;
  template <class I>
  using Value = typename Object::template Value<lanes_t<Real, I>>;

  /// The object(s) at the index that a fused kernel gives its steps.
  template <class I, class Frame>
  [[nodiscard]] PHYSGEN_FUNCTION auto operator[](const Own<I, Frame>& i) const {
    if constexpr (Frame::template has<Local>) {
      return i.frame->template object<Local>(detail::bare(i.index));
    } else {
      static_assert(detail::is_own<I>, "fuse(): this local is not among those that locals(...) names");
      return (*this)[i.index];
    }
  }
  template <class I>
    requires(!detail::is_own<I>)
  void operator[](const I& /*i*/) const {
    static_assert(detail::is_own<I>,
                  "a local of fuse() has the objects at the kernel's own index alone, local[i]; what other objects or "
                  "other kernels read needs an array");
  }
  /// All fields of object(s) i, by value.
  template <class I>
  [[nodiscard]] PHYSGEN_FUNCTION const Value<I> get(const I& i) const {
    return (*this)[i].get();
  }
  /// Stores all fields of object(s) i.
  template <class I>
  PHYSGEN_FUNCTION void put(const I& i, const Value<I>& value) const {
    (*this)[i].put(value);
  }
};

/// In the place of an array of these objects that only the kernels of one fused kernel use.
/// @tparam Formats those of the array that it stands for, through which its values are rounded: FormatsOfSpace, or a
/// struct as an array's. One in which all fields are format::Native rounds nothing.
/// @tparam Tag tells locals apart that have all else in common
template <class Object, class Real, class Formats = FormatsOfSpace, class Tag = Object>
[[nodiscard]] constexpr Local<Object, Real, Formats, Tag> local() {
  return {};
}

/// Several locals.
template <class... Local>
struct Locals {};
template <class... Object, class... Real, class... Formats, class... Tag>
[[nodiscard]] constexpr Locals<Local<Object, Real, Formats, Tag>...> locals(
    const Local<Object, Real, Formats, Tag>&... /*all*/) {
  return {};
}

namespace detail {

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
struct LocalMemory;
template <class Object, class Real, class Formats_, class Tag, class I, class Space>
struct LocalMemory<Local<Object, Real, Formats_, Tag>, I, Space> {
  static constexpr int width = [] {
    if constexpr (std::is_integral_v<I>) {
      return 1;
    } else {
      return I::width;
    }
  }();
  using Layout = typename std::conditional_t<width == 1, std::type_identity<OneRecord>,
                                             std::type_identity<OneTile<width == 1 ? 2 : width>>>::type;
  using Formats =
      typename std::conditional_t<std::is_same_v<Formats_, FormatsOfSpace>,
                                  std::type_identity<FormatsOf<Object, Space>>, std::type_identity<Formats_>>::type;
  using View = physgen::View<Object, Real, Layout, Formats, Space>;
  static constexpr int bytes = View::record_bytes * width;

  alignas(width == 1 ? 8 : 64) std::byte memory[bytes > 0 ? bytes : 1];  // NOLINT: not initialised

  [[nodiscard]] PHYSGEN_FUNCTION typename View::template Ref<I> object(const I& i) {
    using Cursor = typename View::template CursorAt<I>;
    const typename Layout::Pitch pitch(width);
    if constexpr (std::is_integral_v<I>) {
      return typename View::template Ref<I>(Cursor(memory, pitch, 0, nullptr));
    } else {
      I in_tile = i;
      in_tile.begin = 0;
      return typename View::template Ref<I>(Cursor(memory, pitch, in_tile, nullptr));
    }
  }

  /// Signalling NaN, or an index that no array has.
  PHYSGEN_FUNCTION void make_invalid() {
    constexpr std::size_t count = Object::template fields<Real, Formats>.size();
    [this]<std::size_t... f>(std::index_sequence<f...> /*which*/) {
      (make_field_invalid<f>(), ...);
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
  template <class Wanted>
  [[nodiscard]] PHYSGEN_FUNCTION auto object(const I& i) {
    return LocalMemory<Wanted, I, Space>::object(i);
  }
};

/// Whether one of the fused kernels that gave the index has the local.
template <class Index, class Local>
inline constexpr bool has_local = false;
template <class I, class Frame, class Local>
inline constexpr bool has_local<Own<I, Frame>, Local> = Frame::template has<Local> || has_local<I, Local>;

template <class Step, class Index>
PHYSGEN_FUNCTION constexpr void check_step() {
  static_assert(std::invocable<const Step&, const Index&>,
                "fuse(): this step takes no packs, since its call operator is no template over the index; run it by "
                "itself, over an array in the place of each local");
}

/// Kernels in their order; not a std::tuple, of which CUDA knows less.
template <class... Step>
struct Steps;
template <class Last>
struct Steps<Last> {
  using Scalar = typename Last::Scalar;
  Last step;

  template <class Index>
  PHYSGEN_FUNCTION decltype(auto) run(const Index& i) const {
    check_step<Last, Index>();
    return step(i);
  }
};
template <class First, class... Rest>
struct Steps<First, Rest...> {
  using Others = typename Steps<Rest...>::Scalar;
  using Scalar = std::conditional_t<(sizeof(typename First::Scalar) < sizeof(Others)), Others, typename First::Scalar>;
  First step;
  Steps<Rest...> rest;

  template <class Index>
  PHYSGEN_FUNCTION decltype(auto) run(const Index& i) const {
    check_step<First, Index>();
    static_assert(std::is_void_v<std::invoke_result_t<const First&, const Index&>>,
                  "fuse(): a step before the last one returns a term, which nothing would fold; make it the last");
    step(i);
    return rest.run(i);
  }
};

template <class Step>
PHYSGEN_FUNCTION constexpr void check_scalar() {
  static_assert(
      requires { typename Step::Scalar; },
      "fuse(): a step needs a member type, `using Scalar = typename View::Precision;`, or over<float>(lambda)");
}

template <class... Local>
inline constexpr bool all_differ = true;
template <class First, class... Rest>
inline constexpr bool all_differ<First, Rest...> = !(std::is_same_v<First, Rest> || ...) && all_differ<Rest...>;

}  // namespace detail

/// What fuse() makes: a kernel.
template <class LocalList, class... Step>
struct Fused;
template <class... Local, class... Step>
struct Fused<Locals<Local...>, Step...> {
  /// The widest of the steps.
  using Scalar = typename detail::Steps<Step...>::Scalar;
  detail::Steps<Step...> steps;

  /// @return what the last step does
  template <class I>
  PHYSGEN_FUNCTION decltype(auto) operator()(const I& i) const {
#ifdef __CUDA_ARCH__
    using Space = Cuda;
#else
    using Space = Host;
#endif
    static_assert((!detail::has_local<I, Local> && ...),
                  "fuse() inside of another: both name this local, and the inner one would have a record of its own, "
                  "which nothing has written; name it in the outer locals(...) alone, and in the inner one "
                  "fuse(locals(), ...)");
    using Frame = detail::Frame<detail::Bare<I>, Space, Local...>;
    Frame frame;
    return steps.run(Own<I, Frame>{i, &frame});
  }
};

namespace detail {

template <class Last>
[[nodiscard]] constexpr Steps<Last> steps_of(const Last& last) {
  return {last};
}
template <class First, class... Rest>
[[nodiscard]] constexpr Steps<First, Rest...> steps_of(const First& first, const Rest&... rest) {
  return {first, steps_of(rest...)};
}

}  // namespace detail

/// A kernel that calls `steps`, one after the other, for the same object(s): for parallel_for(), for parallel_reduce(),
/// which folds what the last step returns, for executors, and as a step of another fused kernel.
///
/// Steps are kernels that take packs. They read and write the locals at their own index, local[i]; each field is
/// written, by an assignment that all objects run through, before it is read. In checked builds locals begin as
/// signalling NaN, index fields as the lowest integer. What a local's format cannot hold is not counted.
/// @param steps their Scalars may differ; packs are as wide as the widest makes them
template <class... Local, class... Step>
[[nodiscard]] constexpr Fused<Locals<Local...>, Step...> fuse(Locals<Local...> /*locals*/, const Step&... steps) {
  static_assert(sizeof...(Step) > 0, "fuse(): there are no steps");
  static_assert(detail::all_differ<Local...>,
                "locals(): two locals have one type, and so one memory; give one a tag of its own as the last "
                "argument, local<Object, float, FormatsOfSpace, struct Other>()");
  (detail::check_scalar<Step>(), ...);
  return {detail::steps_of(steps...)};
}

}  // namespace physgen
