// A kernel's rows of the Truth Cube on the CPU. For the files that CMake writes.
#pragma once

#include "measure/host_rows.h"
#include "measure/scene_errors.h"

namespace physgen::bench {

/// What the kernel writes can be read by others; for those whose rows are not in this program.
template <class Kernel>
bool register_maker() {
  if constexpr (requires { typename Kernel::Output; }) makers()[Kernel::name] = make_output<Kernel>;
  return true;
}

/// @tparam Reals float, double or both
template <class Kernel, class... Reals>
bool register_scene_rows() {
  register_maker<Kernel>();
  return add(Part{"kernels", Kernel::place, Kernel::name, "host", [](std::vector<Row>& rows, const Sizes& sizes) {
                    (add_layouts(rows, OnScene<Kernel, Reals>(scene_of(sizes.host))), ...);
                  }});
}

}  // namespace physgen::bench
