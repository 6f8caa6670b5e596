// Reads from the body of a kernel, beyond the fields that it uses, which of them it stores on all paths, and whether it
// can be a step of a fused kernel. Uses Clang's types, as read.h does.
#pragma once

#include <clang/AST/Decl.h>

#include <set>
#include <string>
#include <utility>

#include "scenes/other_precision.h"
#include "scenes/scene.h"
#include "usage/names.h"

namespace physgen::scenes {

struct KernelFacts {
  bool takes_packs = false;
  int scalar_bytes = 0;
  std::set<std::pair<std::string, std::string>> stores;  ///< see ProgramStep
  std::string obstacle;                                  ///< see ProgramStep
};

/// @param others of the whole program
/// @param step physgen::probe::detail::step of the kernel
[[nodiscard]] KernelFacts read_kernel(usage::Names& names, const OtherFunctions& others, const Scene& scene,
                                      clang::QualType kernel, const clang::FunctionDecl& step);

}  // namespace physgen::scenes
