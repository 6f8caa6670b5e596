// Numbers that a kernel calculates, in place of those that index fields have, and finds objects by.
#pragma once

#include <clang/AST/Expr.h>

#include <set>
#include <string>

#include "usage/names.h"

namespace physgen::usage {

/// Adds the array of `view[number]`, where the number is formed by arithmetic, is stated, or is a member of the kernel:
/// on several ranks another object may have it. Of variables their initializers are looked at, and nothing that is
/// assigned to them later.
void add_calculated(const clang::CallExpr& call, Names& names, std::set<std::string>& arrays);

}  // namespace physgen::usage
