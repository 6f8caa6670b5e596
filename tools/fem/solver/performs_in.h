// Concepts of executors, for functions that do a step in a way of their own in a space.
#pragma once

#include <physgen/memory/space.h>

namespace physgen::fem {

/// An executor that performs its steps in this space; not one that only counts their bytes, for which there are
/// overloads that nvcc would take to be no better.
template <class On, class Space>
concept PerformsIn = RunsIn<On, Space> && !requires { On::only_counts; };

/// on.perform(work), which does what the kernel would for n objects. An executor of several ranks finds in the kernel
/// which arrays the work uses.
template <class On, class Work, class Kernel>
void perform_in_place_of(On& on, index_t n, const Kernel& kernel, const Work& work) {
  if constexpr (requires { on.perform(work, kernel, n); }) {
    on.perform(work, kernel, n);
  } else {
    on.perform(work);
  }
}

/// Whether an executor is told which arrays such work uses: one of several ranks, whose results must not depend on how
/// many there are, so that sums are formed in one order.
template <class On>
concept OnRanks = requires(On& on, void (*work)(Stream), int kernel) { on.perform(work, kernel, index_t{}); };

namespace detail {

/// on.perform(work) with arrays that each of several ranks has whole.
/// @param views of arrays that the work uses, in an aggregate, by which an executor of several ranks knows that
template <class On, class Work, class Views>
void perform_here(On& on, const Work& work, const Views& views) {
  if constexpr (OnRanks<On>) {
    on.perform_on_each(work, views);
  } else {
    on.perform(work);
  }
}

}  // namespace detail

/// Such an executor that only counts.
template <class On>
concept OnlyCounts = requires { On::only_counts; };

}  // namespace physgen::fem
