// The groups whose rows the kernels add: those of the Truth Cube, and those of the sets of inputs.
#include "measure/registry.h"

namespace physgen::bench {

namespace {

// Selects rows of the Truth Cube, whose names end with the number of objects: all in float, the paper's in double.
[[maybe_unused]] const bool kernels =
    add(Group{"kernels", "the kernels in every layout, storage and space: the group that runs where none is named", 0,
              "(/float/|^(dp_from_df|stress_derivative|add_force_differential)/).*[0-9]$", "errors"});
[[maybe_unused]] const bool errors =
    add(Group{"errors",
              "kernels on three sets of inputs, and the table of error against speed (the worst input\n"
              "of each at its end)",
              1});

}  // namespace

}  // namespace physgen::bench
