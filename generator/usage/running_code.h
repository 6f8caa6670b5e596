// Visits the code of a function that runs: no types, no operands that are not evaluated, and no bodies of lambdas and
// of local classes, which are functions of their own.
#pragma once

#include <clang/AST/DeclCXX.h>
#include <clang/AST/RecursiveASTVisitor.h>

namespace physgen::usage {

template <class Derived>
class RunningCode : public clang::RecursiveASTVisitor<Derived> {
 public:
  static bool TraverseTypeLoc(clang::TypeLoc /*type*/, bool /*qualifier*/ = true) { return true; }
  static bool TraverseCXXNoexceptExpr(clang::CXXNoexceptExpr* /*expression*/) { return true; }
  static bool TraverseRequiresExpr(clang::RequiresExpr* /*expression*/) { return true; }
  static bool TraverseConceptSpecializationExpr(clang::ConceptSpecializationExpr* /*expression*/) { return true; }
  static bool TraverseCXXRecordDecl(clang::CXXRecordDecl* /*record*/) { return true; }
  bool TraverseLambdaExpr(clang::LambdaExpr* lambda) {
    for (clang::Expr* captured : lambda->capture_inits()) this->getDerived().TraverseStmt(captured);
    return true;
  }

  /// @param code a function, whose body and initializers are visited, or a variable
  void look_through(const clang::Decl& code) {
    const auto visit = [this](const clang::Stmt* of) { this->getDerived().TraverseStmt(const_cast<clang::Stmt*>(of)); };
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(&code)) visit(variable->getAnyInitializer());
    if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(&code))
      for (const auto* member : constructor->inits()) visit(member->getInit());
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(&code);
        function != nullptr && function->doesThisDeclarationHaveABody())
      visit(function->getBody());
  }
};

}  // namespace physgen::usage
