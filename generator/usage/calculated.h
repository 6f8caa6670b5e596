// Numbers that a kernel calculates, in place of those that index fields have, and finds objects by.
#pragma once

#include <clang/AST/Expr.h>

#include <set>
#include <string>

#include "usage/names.h"

namespace physgen::usage {

/// Adds the array of `view[number]`, where the number is formed by arithmetic, is stated, or is a member of the kernel:
/// on several ranks another object may have it. A variable that is assigned to behind its declaration counts as
/// calculated, and so does what a function of the user returns, where that is. Parameters of functions do not,
/// nor does `number - member`, by which kernels find objects of a window.
void add_calculated(const clang::CallExpr& call, Names& names, std::set<std::string>& arrays);

}  // namespace physgen::usage
