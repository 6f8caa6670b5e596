// A view that a kernel holds, without its types.
#pragma once

#include <physgen/config.h>

#include <cstddef>
#include <string_view>

namespace physgen {

/// See kernel_members.h, which finds them.
struct KernelView {
  const std::byte* base;  ///< null where nothing is stored
  index_t size;
  bool is_written;  ///< may be, by its type
  std::string_view object;
};

}  // namespace physgen
