// Finds what is done to probed arrays in ways that their types do not show, and so nobody can follow.
#pragma once

#include <clang/AST/Decl.h>

#include <vector>

#include "usage/names.h"

namespace physgen::usage {

/// Casts of views, their sizes, memory and unions, and addresses behind which lie other elements.
/// @param function of the program; its body and initializers are looked through
void add_unknown_uses(const clang::FunctionDecl& function, Names& names, std::vector<UnknownUse>& uses);

}  // namespace physgen::usage
