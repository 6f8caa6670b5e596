// Memory beside the scene's arrays that may be written through what a kernel holds or names: nobody sees what it does
// there for which object, and so not whether another kernel, which runs after it for all objects, may run after it for
// each. Knows Clang, as read.h does.
#pragma once

#include <clang/AST/DeclCXX.h>

#include <string>

#include "usage/names.h"

namespace physgen::scenes {

/// @return what a kernel holds of it, "holds a pointer ... at x.h:3:5"; empty: nothing
[[nodiscard]] std::string other_memory_of(const clang::CXXRecordDecl& kernel, usage::Names& names);

/// The same of a variable that lives as long as the program. @param variable its type
[[nodiscard]] std::string other_memory_of(clang::QualType variable, usage::Names& names);

}  // namespace physgen::scenes
