// A kernel's rows of the Truth Cube on the CPU. For the files that CMake writes.
#pragma once

#include "measure/host_rows.h"
#include "measure/scene_errors.h"

namespace physgen::bench {

/// @tparam Reals float, double or both
template <class Kernel, class... Reals>
bool register_scene_rows() {
  if constexpr (requires { typename Kernel::Output; }) makers()[Kernel::name] = make_output<Kernel>;
  return add(Part{"kernels", Kernel::place, Kernel::name, "host", [](std::vector<Row>& rows, const Sizes& sizes) {
                    (add_layouts(rows, OnScene<Kernel, Reals>(scene_of(sizes.host))), ...);
                  }});
}

}  // namespace physgen::bench
