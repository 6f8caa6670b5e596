// The groups whose rows the kernels add: those of the Truth Cube, and those of the sets of inputs.
#include "measure/registry.h"

namespace physgen::bench {

namespace {

// Rows of the Truth Cube, whose names end with the number of objects: with --all every kernel in float, and the three
// of the 2010 paper in double. CMakeLists.txt compiles those that run without it apart, as physbench_first.
[[maybe_unused]] const bool kernels =
    add(Group{"kernels",
              "the kernels in every layout, storage and space: the group that runs where none is named,\n"
              "three of them in float where --all is not given",
              0, "(/float/|^(dp_from_df|stress_derivative|add_force_differential)/).*[0-9]$",
              "^(dp_from_df|stress_derivative|svd)/.*/float/.*[0-9]$", "errors"});
[[maybe_unused]] const bool errors =
    add(Group{"errors",
              "kernels on three sets of inputs, and the table of error against speed (the worst input\n"
              "of each at its end)",
              1});

}  // namespace

}  // namespace physgen::bench
