// Several kernels as one, which stores none of the objects that only they share: `fuse(locals(F, svd), first, second,
// third)`. A local takes the place of an array: it lies in registers of a CUDA thread, or in a tile of W objects on the
// stack of a CPU's thread. Kernels are the same as over arrays, and their results have the same bits (where compilers
// contract no products with sums across them: -ffp-contract=off, --fmad=false).
//
//   const auto F = local<elasticity::DeformationGradientObject, float>();
//   const auto svd = local<elasticity::DeformationSvdObject, float>();
//   parallel_for(Host{}, n, fuse(locals(F, svd), fem::ComputeDeformationGradient{tets, positions, rest, F},
//                                fem::ComputeSvd{F, svd}, fem::ComputeStress{material, svd, stress.view()}));
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/fused.h>

namespace physgen {

/// The formats that the schema states for the space in which a kernel runs.
struct FormatsOfSpace;

/// Takes the place of a view in fused kernels; local() makes it. It is empty: each call of a fused kernel has objects
/// of its own. A step writes local[i] before a later step reads it.
template <class Object_, class Real, class Formats, class Tag, class Layout_>
struct Local {
  using Object = Object_;
  using Precision = Real;
  /// Of the array that it stands for.
  using Layout = Layout_;
  /// How its fields are stored where the kernel runs in Space.
  template <class Space>
  using FormatsIn = std::conditional_t<std::is_same_v<Formats, FormatsOfSpace>, FormatsOf<Object, Space>, Formats>;
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
  /// Other objects, of which there is none: who uses a field of them does not compile.
  template <class I>
    requires(!detail::is_own<I>)
  [[nodiscard]] PHYSGEN_FUNCTION auto operator[](const I& /*i*/) const {
    using Cursor = detail::NotInLocal<Local, std::remove_cvref_t<detail::Operand<I>>>;
    return typename Object::template Ref<Real, FormatsIn<Host>, Cursor>(Cursor());
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
/// @tparam Layout that of the array, which has a say in how many objects a step is called with at once
template <class Object, class Real, class Formats = FormatsOfSpace, class Tag = Object, class Layout = Aosoa<16>>
[[nodiscard]] constexpr Local<Object, Real, Formats, Tag, Layout> local() {
  return {};
}

/// Several locals.
template <class... Local>
struct Locals {};
template <class... Object, class... Real, class... Formats, class... Tag, class... Layout>
[[nodiscard]] constexpr Locals<Local<Object, Real, Formats, Tag, Layout>...> locals(
    const Local<Object, Real, Formats, Tag, Layout>&... /*all*/) {
  return {};
}

/// The kernel that fuse() makes.
template <class LocalList, class... Step>
struct Fused;
template <class... Local, class... Step>
struct Fused<Locals<Local...>, Step...> {
  using FusedSteps = detail::Steps<Step...>;
  /// The widest of the steps.
  using Scalar = typename FusedSteps::Scalar;
  FusedSteps steps;

  /// @return what the last step does
  template <class I>
  PHYSGEN_FUNCTION decltype(auto) operator()(const I& i) const {
    return run<detail::StepLanes::chosen>(i);
  }
  /// @tparam kLanes whether a step that suits one lane is called with the objects of a pack one by one
  template <detail::StepLanes kLanes, class I>
  PHYSGEN_FUNCTION decltype(auto) run(const I& i) const {
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
    return steps.template run<kLanes>(Own<I, Frame>{i, &frame});
  }
};

/// A kernel that calls `steps`, one after the other, for the same object(s): for parallel_for(), for parallel_reduce(),
/// which folds what the last step returns, for executors, and as a step of another fused kernel.
///
/// Steps are kernels that take packs. They read and write the locals at their own index, local[i]; each field is
/// written, by an assignment that all objects run through, before it is read. In checked builds locals begin as
/// signalling NaN, index fields as the lowest integer. Values that a local's format cannot hold are not counted.
///
/// Each step is called with as many objects at once as it would be by itself: with one, also where others take packs,
/// if detail/chosen_lanes.h gives it one lane. lanes<W>(fuse(...)) calls all steps with W. Checked builds call all with
/// packs, in which they find races.
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

#pragma pop_macro("I")
