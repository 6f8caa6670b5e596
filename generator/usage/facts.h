// Lists the parts of instantiated code, so that instantiations of one source over different arrays can be compared:
// where they differ, the code depends on the types of its arrays.
#pragma once

#include <clang/AST/ASTContext.h>
#include <clang/AST/Decl.h>

#include <functional>

#include "usage/graph.h"

namespace physgen::usage {

/// The statements and names of a function's body, or of a variable's initializer, and the values of what is constant in
/// it. Operators and conversions are left out: numbers have those of the language, and what stands for one has others.
/// @param place of a location
[[nodiscard]] std::set<Fact> facts_of(const clang::Decl& code, clang::ASTContext& context,
                                      const std::function<Place(clang::SourceLocation)>& place);

}  // namespace physgen::usage
