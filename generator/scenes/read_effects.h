// Whether an expression of a program can be evaluated later than it stands: it has no effects, and what it gives does
// not depend on the steps in between. Knows Clang, as read.h does.
#pragma once

#include <clang/AST/Expr.h>

#include <string>

#include "usage/names.h"

namespace physgen::scenes {

/// @return why it is not sure to be so, "it calls log() at x.h:3:5"; empty: it is
[[nodiscard]] std::string effects_of(const clang::Expr* expression, const usage::Names& names);

}  // namespace physgen::scenes
