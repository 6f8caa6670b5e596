// What functions of a kernel do with its index, which is of another type in a fused kernel. Uses Clang's types, as
// read.h does.
#pragma once

#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>

#include <string>
#include <utility>
#include <vector>

#include "usage/names.h"

namespace physgen::scenes {

/// Whether a type is Pack<W> or PartialPack<W>.
[[nodiscard]] bool is_pack(clang::QualType type);

/// Whether a function of the program may use objects of the scene's arrays: it is given an index, or it or the object
/// that it is of has a view.
[[nodiscard]] bool sees_arrays(const clang::FunctionDecl& function, usage::Names& names);

/// A function of the program that another precision may call, and the callee there.
using Candidate = std::pair<const clang::FunctionDecl*, const clang::Expr*>;

/// The list: an index is what objects are named by, `view[i]`, and an argument of functions; and its type is asked by
/// `lanes_t<Scalar, I>` alone. What `if constexpr` chooses depends on no type, which another precision may change, nor
/// does any class: `typename T::Law` is not on the list, but `typename V::Precision` of a view or of Eigen's is.
/// @param function an instantiated one of the program
/// @param candidates what its calls name
/// @return what else it does, "asks what its index is at kernel.h:3:5"; empty: nothing
[[nodiscard]] std::string asked_of_index(const clang::FunctionDecl& function, usage::Names& names,
                                         std::vector<Candidate>& candidates);
/// The same of the members and bases of an instantiated class.
[[nodiscard]] std::string asked_of_class(const clang::CXXRecordDecl& record, usage::Names& names);

}  // namespace physgen::scenes
