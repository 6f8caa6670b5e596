// Expressions of Clang's syntax tree as their author wrote them.
#pragma once

#include <clang/AST/ExprCXX.h>

#include "usage/names.h"

namespace physgen::usage {

/// The expression that implicit nodes wrap.
[[nodiscard]] inline const clang::Expr* written(const clang::Expr* expression) {
  const clang::Expr* before = nullptr;
  while (expression != before) {
    before = expression;
    expression = expression->IgnoreParens()->IgnoreImplicit();
  }
  return expression;
}

/// The object that a member function or an operator is called on; null for other calls.
[[nodiscard]] inline const clang::Expr* object_of(const clang::CallExpr& call) {
  if (const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(&call)) return member->getImplicitObjectArgument();
  if (llvm::isa<clang::CXXOperatorCallExpr>(call) && call.getNumArgs() > 0) return call.getArg(0);
  return nullptr;
}

/// Where a reader looks for a call: at the field's name in `view[i].x() = v` and in `const Vector v = view[i].x();`,
/// else at the called name.
[[nodiscard]] inline clang::SourceLocation place_of(const clang::CallExpr& call) {
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(call.getDirectCallee());
  const clang::Expr* object = object_of(call);
  if (method != nullptr && object != nullptr) {
    const bool of_reference =
        Names::is_physgen(method->getParent(), "FieldRef") || Names::is_physgen(method->getParent(), "ElementRef");
    object = written(object);
    if (const auto* inner = llvm::dyn_cast<clang::CallExpr>(object); inner != nullptr && of_reference)
      return place_of(*inner);
    if (of_reference || llvm::isa<clang::CXXConversionDecl>(method)) return object->getBeginLoc();
  }
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(call.getCallee()->IgnoreParenImpCasts()))
    return member->getMemberLoc();
  return call.getCallee()->getExprLoc();
}

}  // namespace physgen::usage
