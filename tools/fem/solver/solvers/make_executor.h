// Executors as solvers make them.
#pragma once

#include <fem/mesh/stages.h>
#include <fem/solver/settings.h>
#include <physgen/config.h>

#include <memory>
#include <type_traits>

namespace physgen::fem {

/// The executor, which on CUDA must know the longest range that is reduced. It is the first to use the device.
template <class On>
[[nodiscard]] std::unique_ptr<On> make_executor(index_t objects, const SolverSettings& settings) {
  if (settings.before_device) {
    const InStage stage("waiting for the device");
    settings.before_device();
  }
  const InStage stage("executor");
  if constexpr (std::is_default_constructible_v<On>) {
    return std::make_unique<On>();
  } else {
    return std::make_unique<On>(objects);
  }
}

}  // namespace physgen::fem
