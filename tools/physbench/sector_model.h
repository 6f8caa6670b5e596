// The model of coalescing as rows use it.
#pragma once

#include <optional>

#include "coalescing.h"
#include "row.h"

namespace physgen::bench {

/// The sectors of a row's kernel; none for rows of the CPU, of copies and libraries, and of double precision.
[[nodiscard]] std::optional<Sectors> model_sectors(const Row& row);

}  // namespace physgen::bench
