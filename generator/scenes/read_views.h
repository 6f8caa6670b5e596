// Reads how a program itself, outside of kernels, uses the arrays of its groups. Uses Clang's types, as read.h does.
#pragma once

#include <clang/AST/Decl.h>
#include <clang/AST/Expr.h>

#include <map>
#include <string>
#include <utility>

#include "scenes/scene.h"
#include "usage/names.h"

namespace physgen::scenes {

/// The array that view(), const_view() or size() is asked of, `body.tets.size()`, body being a parameter.
/// @return nulls: the expression is not such a call
[[nodiscard]] std::pair<const Group*, const Array*> asked_of_array(const clang::Expr* expression, const Scene& scene);

/// The objects that a count counts, in the words of ProgramStep::runs: a constant, or the size() of an array as it is,
/// not converted. Empty: it is neither.
[[nodiscard]] std::string counted(const clang::Expr* count, const Scene& scene, const clang::ASTContext& context);

/// Arrays, by full name, of which the program does not only ask the size and hand views to kernels that are built where
/// they are run; and where, " at x.h:3:5".
[[nodiscard]] std::map<std::string, std::string> views_used(const clang::FunctionDecl& program, const Scene& scene,
                                                            const usage::Names& names);

}  // namespace physgen::scenes
