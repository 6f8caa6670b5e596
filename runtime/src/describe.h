// Words of messages: the name of an array, and refusals of copies and of fields that it does not store.
#pragma once

#include <physgen/arrays/untyped_array.h>
#include <physgen/error.h>

#include <string>

namespace physgen::detail {

/// "elasticity::Tet[12] in cuda memory"
[[nodiscard]] inline std::string describe(const UntypedArray& array) {
  return std::string(array.object) + "[" + std::to_string(array.size) + "] in " + name(array.space) + " memory";
}

[[noreturn]] inline void refuse_copy(const UntypedArray& to, const UntypedArray& from, const std::string& why) {
  throw Error("cannot copy " + describe(from) + " to " + describe(to) + ": " + why);
}

/// @param what is asked for in vain
[[noreturn]] inline void refuse_unstored(const UntypedArray& array, const FieldInfo& field, const std::string& what) {
  throw Error(describe(array) + ": " + what + ", but nothing is stored of " + std::string(field.name) +
              ": this array prunes it (format::Nothing or Pruned); take an array that stores it");
}

}  // namespace physgen::detail
