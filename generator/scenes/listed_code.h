// The lists of what the body of a kernel may hold whose steps are joined: what is not on them is unknown.
#pragma once

#include <clang/AST/Expr.h>

namespace physgen::scenes {

/// Whether a statement or an expression, apart from what it calls and names, computes with numbers and leads to no
/// other memory.
[[nodiscard]] bool is_listed(const clang::Stmt& statement);

/// Whether an assert() ends the program here.
[[nodiscard]] bool fails(const clang::CallExpr& call);

/// Whether a function of std computes, or hands a value on, or calls what it is given.
[[nodiscard]] bool is_listed_in_std(const clang::FunctionDecl& function);

/// Whether a function is of the runtime's headers of numbers, rows, views and references to objects.
[[nodiscard]] bool is_listed_in_runtime(const clang::FunctionDecl& function);

}  // namespace physgen::scenes
