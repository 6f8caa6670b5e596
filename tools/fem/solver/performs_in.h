// Concepts of executors, for functions that do a step in a way of their own in a space.
#pragma once

#include <physgen/memory/space.h>

namespace physgen::fem {

/// An executor that performs its steps in this space; not one that only counts their bytes, for which there are
/// overloads that nvcc would take to be no better.
template <class On, class Space>
concept PerformsIn = RunsIn<On, Space> && !requires { On::only_counts; };

/// Such an executor that only counts.
template <class On>
concept OnlyCounts = requires { On::only_counts; };

}  // namespace physgen::fem
