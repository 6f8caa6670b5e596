// What functions of a kernel do with its index, which is of another type in a fused kernel. Knows Clang, as read.h
// does.
#pragma once

#include <clang/AST/Decl.h>
#include <clang/AST/Expr.h>

#include <string>

#include "usage/names.h"

namespace physgen::scenes {

/// Whether a type is Pack<W> or PartialPack<W>.
[[nodiscard]] bool is_pack(clang::QualType type);

/// The list: an index is what objects are named by, `view[i]`, and an argument of functions; and its type is asked by
/// `lanes_t<Scalar, I>` alone.
/// @param function an instantiated one that takes an index
/// @return what else it does, "asks what its index is at kernel.h:3:5"; empty: nothing
[[nodiscard]] std::string asked_of_index(const clang::FunctionDecl& function, const usage::Names& names);

/// The same of the arguments of a call that are indices: functions of the runtime take them, and those of the program
/// that take any type there, whatever else has their name.
[[nodiscard]] std::string asked_by_call(const clang::CallExpr& call, const usage::Names& names);

}  // namespace physgen::scenes
