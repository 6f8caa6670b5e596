// The steps of a program, as calls that compilers read and programs never make. A specialisation of step(),
// reduce_step(), perform_step(), root() or host_reads() is where `physgen usage` begins: the step reads and writes what
// is reached from there.
#pragma once

#include <physgen/detail/check_numbers.h>
#include <physgen/kernels/lanes.h>
#include <physgen/launch/reduce.h>
#include <physgen/probe/field_accesses.h>

#ifndef __CUDACC__
#include <physgen/parallel_for.h>
#endif

namespace physgen::probe::detail {

/// Lanes of the widest packs that the kernel takes, whatever a program calls it with: under them types tell more; 1
/// where it takes none, and on CUDA.
template <class Kernel, class Space>
constexpr int lanes_of() {
#ifndef __CUDACC__
  if constexpr (Space::kind != SpaceKind::cuda) return physgen::detail::widest_lanes(std::type_identity<Kernel>());
#endif
  return 1;
}

/// Whether a kernel takes single objects alone, and is a template over their index: SingleObject. A template that takes
/// all kinds of index is looked at under packs, and fused kernels tell by themselves.
template <class Kernel>
constexpr bool takes_own_object() {
  if constexpr (requires { typename Kernel::FusedSteps; } || !requires { typename Kernel::Scalar; }) {
    return false;
  } else if constexpr (physgen::detail::Generic<Kernel>) {
    return false;
  } else {
    return std::invocable<const Kernel&, physgen::detail::OwnObject>;
  }
}

/// kernel(i) for one object. Types do not tell its index from those that it forms; under packs, in fused kernels and
/// under OwnObject they do.
template <class Kernel>
void single_object(const Kernel& kernel) {
  if (false) (void)kernel(index_t{0});
}

/// kernel(i), for each kind of index that a program calls it with.
template <class Kernel, class Space>
void step(const Kernel& kernel) {
  if (false) {
    single_object(kernel);
    // physgen finds this by its name, to learn whether the kernel takes packs (generator/scenes/read_kernel.cpp).
    constexpr int lanes = lanes_of<Kernel, Space>();
    if constexpr (lanes > 1) (void)kernel(Pack<lanes>{0});
    if constexpr (takes_own_object<Kernel>()) (void)kernel(physgen::detail::OwnObject{0, nullptr});
  }
}

/// The same for a kernel whose terms are folded, and then(value of the fold).
template <class Kernel, class Fold, class Then, class Space>
void reduce_step(const Kernel& kernel, const Fold& /*fold*/, const Then& then) {
  if (false) {
    using Types = physgen::detail::Reduction<Kernel, Fold, index_t>;
    step<Kernel, Space>(kernel);
    (void)then(Types::Entries::result(static_cast<const typename Types::Value*>(nullptr)));
  }
}

/// work(stream): code of the program's own.
template <class Work, class Space>
void perform_step(const Work& work) {
  if (false) work(Stream{});
#if defined(__NVCC__) && !defined(__CUDA_ARCH__)
  if constexpr (Space::kind == SpaceKind::cuda) (void)&DeviceWork<Work>::work;
#endif
}

/// The end of a loop, which is always wanted.
template <class Done>
void root(const Done& done) {
  if (false) (void)done();
}

/// The host asks for an object, so all its fields are wanted.
template <class Array>
void host_reads(const Array& array) {
  if (false) (void)array.const_view().get(index_t{0});
}

}  // namespace physgen::probe::detail
