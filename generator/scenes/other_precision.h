// Kernels are read in one precision and run in others: what these may choose in place of what was read.
#pragma once

#include <clang/AST/DeclCXX.h>

#include <vector>

#include "usage/names.h"

namespace physgen::scenes {

/// Whether a class or a template is of the libraries that kernels calculate with.
[[nodiscard]] bool is_of_libraries(const clang::Decl& declared, const usage::Names& names);

/// Numbers, and classes of the libraries that kernels calculate with, whose own types differ in the precision alone.
[[nodiscard]] bool is_of_precision(clang::QualType type, const usage::Names& names);

/// Whether a class and its members have the same text in another precision.
[[nodiscard]] bool is_one_text(const clang::CXXRecordDecl& record);

/// A function of the program and the others that another precision may choose in its place.
/// @param is_known false, if these may be others than those that are returned, of a template with others of its name,
///        or return other classes
[[nodiscard]] std::vector<const clang::FunctionDecl*> namesakes(const clang::FunctionDecl& function,
                                                                const usage::Names& names, bool& is_known);

/// A function of the program that another precision may choose in place of one of a library: of its name, and for as
/// many arguments; null where there is none.
[[nodiscard]] const clang::NamedDecl* rival(const clang::FunctionDecl& called, unsigned arguments,
                                            const usage::Names& names);

}  // namespace physgen::scenes
