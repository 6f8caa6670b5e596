// Executors as solvers make them.
#pragma once

#include <physgen/config.h>

#include <memory>
#include <type_traits>

namespace physgen::fem {

/// The executor, which on CUDA must know the longest range that is reduced.
template <class On>
[[nodiscard]] std::unique_ptr<On> make_executor(index_t objects) {
  if constexpr (std::is_default_constructible_v<On>) {
    return std::make_unique<On>();
  } else {
    return std::make_unique<On>(objects);
  }
}

}  // namespace physgen::fem
