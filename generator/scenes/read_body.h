// Whether the body of a kernel does nothing but to compute with numbers and to use its views, as far as reading tells:
// a short list of statements, expressions and functions. What is not on it is unknown, be it harmless or not. Knows
// Clang, as read.h does.
#pragma once

#include <clang/AST/Decl.h>

#include <string>

#include "scenes/other_precision.h"
#include "usage/names.h"

namespace physgen::scenes {

/// The list: local variables, arithmetic, branches and loops; constants; the kernel's members, views and index, as
/// read_index.h has it; functions of the program whose bodies are on the list; and functions of Eigen, of the runtime's
/// numbers and views, and of std's mathematics, and what of the program these call.
/// @param function an instantiated call operator
/// @param others of the whole program
/// @return what is not on the list, "it uses the variable n at kernel.h:3:5; ..." without "it"; empty: all of it is
[[nodiscard]] std::string not_in_body(const clang::FunctionDecl& function, usage::Names& names,
                                      const OtherFunctions& others);

}  // namespace physgen::scenes
