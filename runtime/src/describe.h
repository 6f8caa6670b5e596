// How messages name an array, and what they say where it does not store a field.
#pragma once

#include <physgen/error.h>
#include <physgen/storage.h>

#include <string>

namespace physgen::detail {

/// "elasticity::Tet[12] in cuda memory"
[[nodiscard]] inline std::string describe(const Storage& storage) {
  return std::string(storage.object) + "[" + std::to_string(storage.size) + "] in " + name(storage.space) + " memory";
}

/// @param what cannot be had
[[noreturn]] inline void refuse_unstored(const Storage& storage, const FieldInfo& field, const std::string& what) {
  throw Error(describe(storage) + ": " + what + ", but nothing is stored of " + std::string(field.name) +
              ": this array prunes it (format::Nothing or Pruned); take an array that stores it");
}

}  // namespace physgen::detail
