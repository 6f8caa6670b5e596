// How messages name an array.
#pragma once

#include <physgen/storage.h>

#include <string>

namespace physgen::detail {

/// "elasticity::Tet[12] in cuda memory"
[[nodiscard]] inline std::string describe(const Storage& storage) {
  return std::string(storage.object) + "[" + std::to_string(storage.size) + "] in " + name(storage.space) + " memory";
}

}  // namespace physgen::detail
