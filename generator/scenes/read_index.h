// What functions of a kernel do with its index, which is of another type in a fused kernel. Uses Clang's types, as
// read.h does.
#pragma once

#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>

#include <string>
#include <vector>

#include "usage/names.h"

namespace physgen::scenes {

/// Whether a type is Pack<W> or PartialPack<W>.
[[nodiscard]] bool is_pack(clang::QualType type);

/// Whether a function of the program may use objects of the scene's arrays: it is given an index, or it or the object
/// that it is of has a view.
[[nodiscard]] bool sees_arrays(const clang::FunctionDecl& function, usage::Names& names);

/// The list: an index is what objects are named by, `view[i]`, and an argument of functions; and its type is asked by
/// `lanes_t<Scalar, I>` alone. What `if constexpr` chooses depends on no type, which another precision may change.
/// @param function an instantiated one of the program
/// @return what else it does, "asks what its index is at kernel.h:3:5"; empty: nothing
[[nodiscard]] std::string asked_of_index(const clang::FunctionDecl& function, usage::Names& names);

/// Whether a class has the same text in another precision.
[[nodiscard]] bool is_one_text(const clang::CXXRecordDecl& record);

/// A function of the program and the others that another precision may choose in its place.
/// @param is_known false, if these may be others than those that are returned: of a template with others of its name
[[nodiscard]] std::vector<const clang::FunctionDecl*> namesakes(const clang::FunctionDecl& function, bool& is_known);

}  // namespace physgen::scenes
