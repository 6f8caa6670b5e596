// The kernels of steps with the views that they hold, by number, as the table of halos counts them. What lanes<W>()
// makes of a kernel counts as the kernel. Knows Clang, as names.h does.
#pragma once

#include <clang/AST/DeclCXX.h>

#include "usage/names.h"

namespace physgen::usage {

/// A kernel in a fused one. @param call_operator index of a function
[[nodiscard]] Part part_of(int call_operator, const clang::CXXRecordDecl& kernel, int behind, Names& names);

/// Name and views of the kernel of a step that calls a kernel for one object after the other.
void add_kernel(const clang::FunctionDecl& function, Names& names, Step& step);

}  // namespace physgen::usage
