// Follows the instantiated functions of a program in Clang's syntax tree and writes down what calls what. Of this
// folder's headers, only this one and names.h know Clang.
#pragma once

#include <clang/AST/ASTContext.h>
#include <clang/AST/Decl.h>

#include <string>
#include <vector>

#include "usage/graph.h"

namespace physgen::usage {

/// @param functions of the program that have bodies, instantiated ones among them
/// @param folders in which #include looks: files are named without them
[[nodiscard]] Graph read_graph(clang::ASTContext& context, const std::vector<const clang::FunctionDecl*>& functions,
                               const std::vector<std::string>& folders);

}  // namespace physgen::usage
