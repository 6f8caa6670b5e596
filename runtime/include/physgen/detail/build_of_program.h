// What must be equal in the programs that run together as ranks.
#pragma once

#include <physgen/config.h>
#include <physgen/version.h>

#include <string>

namespace physgen::detail {

[[nodiscard]] inline std::string build_of_program() {
  std::string text = "physgen " PHYSGEN_VERSION;
#ifdef __VERSION__
  text += ", compiler " __VERSION__;
#endif
  return text + (checked_build ? ", checked" : "");
}

}  // namespace physgen::detail
