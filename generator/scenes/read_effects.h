// Whether what stands between two steps of a program can stay before both: an expression has no effects, and what it
// gives does not depend on the steps; a declaration has names that are known. Knows Clang, as read.h does.
#pragma once

#include <clang/AST/Expr.h>

#include <optional>
#include <string>
#include <vector>

#include "usage/names.h"

namespace physgen::scenes {

/// @return why it is not sure to be so, "it calls log() at x.h:3:5"; empty: it is
[[nodiscard]] std::string effects_of(const clang::Expr* expression, const usage::Names& names);

/// The same of what initialises a variable, and its parts where it is a structured binding.
[[nodiscard]] std::string effects_of(const clang::VarDecl& variable, const usage::Names& names);

/// The names that a declaration introduces where it stands; none: they are not known, as of `using namespace`.
[[nodiscard]] std::optional<std::vector<std::string>> names_of(const clang::Decl& declaration);

/// Whether a macro writes more than a literal of an expression: what it means may change with the place.
[[nodiscard]] bool is_of_macro(const clang::Stmt* expression);

}  // namespace physgen::scenes
