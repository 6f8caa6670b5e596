// The model of coalescing as rows of the GPU use it: by name, since tracing is for the C++ compiler alone.
#pragma once

#include <functional>
#include <string>

#include "measure/row.h"

namespace physgen::bench {

/// The counters of a row's accesses; none of a row that no model was added for.
[[nodiscard]] std::function<Counters()> model_of(const Row& row);

/// @param row "kernel/storage/layout" @param count gives what it counts
bool add_model(const std::string& row, std::function<Counters()> count);

}  // namespace physgen::bench
