// What HaloSteps is told of a step: its kernels and their views. For executors of several ranks.
#pragma once

#include <physgen/distributed/halo_steps.h>
#include <physgen/distributed/kernel_members.h>

#include <span>
#include <type_traits>
#include <vector>

namespace physgen::detail {

template <class Kernel>
[[nodiscard]] std::vector<HaloSteps::Kernel> kernels_of(const Kernel& kernel) {
  std::vector<HaloSteps::Kernel> kernels;
  for_each_kernel(kernel, [&](const auto& one) {
    HaloSteps::Kernel& added = kernels.emplace_back();
    added.name = &name_of_kernel<std::remove_cvref_t<decltype(one)>>();
    for_each_view(one, [&](const KernelView& view) { added.views.push_back(view); });
  });
  return kernels;
}

/// @throw Error when `then`, or the condition of a loop, has views of arrays of which ranks have parts
template <class Then>
void require_replicated(const HaloSteps& steps, const Then& then) {
  if constexpr (std::is_aggregate_v<Then>) {
    std::vector<KernelView> views;
    for_each_view(then, [&](const KernelView& view) { views.push_back(view); });
    steps.require_replicated(views, name_of_kernel<Then>());
  }
}

/// Of an array that a program asks for the value of its one object.
template <class Array>
void require_replicated_value(const HaloSteps& steps, const Array& array) {
  const UntypedArray memory = array.untyped();
  const KernelView view{memory.base, memory.size, false, memory.object};
  steps.require_replicated(std::span(&view, 1), "value()");
}

/// Calls call(begin, end) for the objects of a step: for those first that need nothing of what still crosses.
/// @param transport counts what is hidden
template <class Call>
void for_ranges(HaloSteps& steps, const HaloSteps::Objects& objects, Transport& transport, const Call& call) {
  for (const HaloSteps::Range& inner : objects.inner) call(inner.begin, inner.end);
  if (!objects.inner.empty()) {
    transport.count_overlap();
    steps.arrive();
  }
  index_t at = objects.begin;
  for (const HaloSteps::Range& inner : objects.inner) {
    if (at < inner.begin) call(at, inner.begin);
    at = inner.end;
  }
  if (at < objects.end) call(at, objects.end);
}

}  // namespace physgen::detail
