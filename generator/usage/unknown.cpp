// See unknown.h.
#include "usage/unknown.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/RecursiveASTVisitor.h>

#include <set>

#include "usage/expressions.h"

namespace physgen::usage {
namespace {

class Finder : public clang::RecursiveASTVisitor<Finder> {
 public:
  Finder(clang::ASTContext& context, Names& names, std::vector<UnknownUse>& uses)
      : context_(context), names_(names), uses_(uses) {}

  // Operands that are not evaluated, and types.
  static bool TraverseTypeLoc(clang::TypeLoc /*type*/, bool /*qualifier*/ = true) { return true; }
  static bool TraverseCXXNoexceptExpr(clang::CXXNoexceptExpr* /*expression*/) { return true; }
  static bool TraverseRequiresExpr(clang::RequiresExpr* /*expression*/) { return true; }
  static bool TraverseConceptSpecializationExpr(clang::ConceptSpecializationExpr* /*expression*/) { return true; }
  bool TraverseUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr* expression) {
    if (expression->getKind() == clang::UETT_SizeOf)
      unknown(expression->getTypeOfArgument(), "sizeof", expression->getBeginLoc());
    return true;
  }
  // Bodies of lambdas and of local classes are functions of their own.
  static bool TraverseCXXRecordDecl(clang::CXXRecordDecl* /*record*/) { return true; }
  bool TraverseLambdaExpr(clang::LambdaExpr* lambda) {
    for (clang::Expr* captured : lambda->capture_inits()) TraverseStmt(captured);
    return true;
  }

  bool VisitCallExpr(clang::CallExpr* call) {
    const clang::FunctionDecl* callee = call->getDirectCallee();
    if (callee == nullptr) return true;
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(callee);
    if (method != nullptr && method->getOverloadedOperator() == clang::OO_Amp &&
        Names::is_physgen(method->getParent(), "ElementRef") && harmless_.count(call) == 0)
      unknown(object_of(*call)->getType(), "the address of an element, behind which lie others,", call->getBeginLoc());
    if (callee->getIdentifier() == nullptr) return true;
    const auto begins_with = [&](const char* text) { return callee->getName().starts_with(text); };
    if ((begins_with("atomic") || begins_with("__ld") || begins_with("__st")) &&  // CUDA's, of one element
        names_.is_library(callee->getLocation()))
      for (const clang::Expr* argument : call->arguments()) harmless_.insert(written(argument));
    if (callee->getName() == "bit_cast" && call->getNumArgs() > 0)
      unknown(call->getArg(0)->getType(), "bit_cast", call->getBeginLoc());
    if (method != nullptr && callee->getName() == "data" && Names::is_physgen(method->getParent(), "View"))
      unknown(object_of(*call)->getType(), "data()", place_of(*call));
    return true;
  }
  bool VisitReturnStmt(clang::ReturnStmt* statement) {
    if (statement->getRetValue() != nullptr) only_the_element(statement->getRetValue()->IgnoreImplicit());
    return true;
  }
  bool VisitBinaryOperator(clang::BinaryOperator* operation) {
    if (operation->isAssignmentOp()) only_the_element(operation->getLHS());
    return true;
  }
  bool VisitCastExpr(clang::CastExpr* cast) {
    const auto kind = cast->getCastKind();
    if (kind == clang::CK_LValueToRValue) only_the_element(cast->getSubExpr());
    if (kind == clang::CK_BitCast || kind == clang::CK_LValueBitCast || kind == clang::CK_PointerToIntegral)
      unknown(cast->getSubExpr()->getType(), "a cast to other types, as of memcpy or reinterpret_cast",
              cast->getBeginLoc());
    return true;
  }
  bool VisitCXXTypeidExpr(clang::CXXTypeidExpr* expression) {
    unknown(
        expression->isTypeOperand() ? expression->getTypeOperand(context_) : expression->getExprOperand()->getType(),
        "typeid", expression->getBeginLoc());
    return true;
  }
  bool VisitMemberExpr(clang::MemberExpr* member) {
    if (const auto* record = llvm::dyn_cast<clang::RecordDecl>(member->getMemberDecl()->getDeclContext());
        record != nullptr && record->isUnion())
      unknown(context_.getCanonicalTagType(record), "a union", member->getMemberLoc());
    return true;
  }

 private:
  /// `*&x` as a value, where something is assigned to it, or as what a function returns.
  void only_the_element(const clang::Expr* expression) {
    const auto* at = llvm::dyn_cast<clang::UnaryOperator>(expression->IgnoreParens());
    if (at != nullptr && at->getOpcode() == clang::UO_Deref) harmless_.insert(written(at->getSubExpr()));
  }
  void unknown(clang::QualType type, const char* what, clang::SourceLocation location) {
    for (const std::string& array : names_.arrays(type)) uses_.push_back({array, what, names_.place(location)});
  }

  clang::ASTContext& context_;
  Names& names_;
  std::vector<UnknownUse>& uses_;
  std::set<const clang::Expr*> harmless_;  // addresses for atomicAdd(), __ldcg() and the like, and in *&x
};

}  // namespace

void add_unknown_uses(const clang::FunctionDecl& function, Names& names, std::vector<UnknownUse>& uses) {
  Finder finder(function.getASTContext(), names, uses);
  if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(&function))
    for (const auto* member : constructor->inits()) finder.TraverseStmt(member->getInit());
  if (function.doesThisDeclarationHaveABody()) finder.TraverseStmt(function.getBody());
}

}  // namespace physgen::usage
