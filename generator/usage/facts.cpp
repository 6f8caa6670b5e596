// See facts.h.
#include "usage/facts.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprConcepts.h>
#include <clang/AST/RecursiveASTVisitor.h>

namespace physgen::usage {
namespace {

class Facts : public clang::RecursiveASTVisitor<Facts> {
 public:
  Facts(clang::ASTContext& context, const std::function<Place(clang::SourceLocation)>& place)
      : context_(context), place_(place) {}

  std::set<Fact> of(const clang::Decl& code) {
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(&code)) {
      TraverseStmt(const_cast<clang::Expr*>(variable->getAnyInitializer()));
      return std::move(facts_);
    }
    const auto& function = llvm::cast<clang::FunctionDecl>(code);
    if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(&function))
      for (const auto* member : constructor->inits())
        if (member->isWritten() || member->isInClassMemberInitializer()) TraverseStmt(member->getInit());
    if (function.isDefaulted()) return std::move(facts_);  // whether there is one depends on members
    add(function.getLocation(), "a call");
    if (function.doesThisDeclarationHaveABody()) TraverseStmt(function.getBody());
    return std::move(facts_);
  }

  static bool TraverseTypeLoc(clang::TypeLoc /*type*/, bool /*qualifier*/ = true) { return true; }
  // Bodies of lambdas and of local classes are functions of their own.
  static bool TraverseCXXRecordDecl(clang::CXXRecordDecl* /*record*/) { return true; }
  bool TraverseLambdaExpr(clang::LambdaExpr* lambda) {
    add(lambda->getBeginLoc(), "a lambda");
    for (clang::Expr* captured : lambda->capture_inits()) TraverseStmt(captured);
    return true;
  }
  // An operand that does not run counts by its value alone.
  bool TraverseCXXNoexceptExpr(clang::CXXNoexceptExpr* expression) { return value(expression); }
  bool TraverseRequiresExpr(clang::RequiresExpr* expression) { return value(expression); }
  bool TraverseConceptSpecializationExpr(clang::ConceptSpecializationExpr* expression) { return value(expression); }
  bool TraverseTypeTraitExpr(clang::TypeTraitExpr* expression) { return value(expression); }
  bool TraverseUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr* expression) { return value(expression); }

  bool VisitStmt(clang::Stmt* statement) {
    if (!llvm::isa<clang::Expr>(statement)) add(statement->getBeginLoc(), "a statement");
    return true;
  }
  bool VisitIfStmt(clang::IfStmt* statement) {
    if (statement->isConstexpr()) value(statement->getCond(), statement->getIfLoc());
    return true;
  }
  bool VisitCXXDefaultInitExpr(clang::CXXDefaultInitExpr* expression) { return TraverseStmt(expression->getExpr()); }
  bool VisitCXXDefaultArgExpr(clang::CXXDefaultArgExpr* expression) { return TraverseStmt(expression->getExpr()); }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(reference->getDecl());
    name(*reference->getDecl(), reference->getLocation());
    if (variable != nullptr) constant(*variable, reference->getLocation());
    if (variable != nullptr && variable->hasGlobalStorage()) one_for_each_type(*variable, reference->getLocation());
    if (llvm::isa<clang::FunctionDecl>(reference->getDecl()) && called_.count(reference) == 0)
      numbers_among_arguments(*reference->getDecl(), reference->getLocation());
    if (llvm::isa<clang::EnumConstantDecl>(reference->getDecl())) value(reference);
    return true;
  }
  bool VisitMemberExpr(clang::MemberExpr* member) {
    name(*member->getMemberDecl(), member->getMemberLoc());
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(member->getMemberDecl()))
      constant(*variable, member->getMemberLoc());
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(member->getMemberDecl()))
      one_for_each_type(*variable, member->getMemberLoc());
    return true;
  }
  bool VisitGenericSelectionExpr(clang::GenericSelectionExpr* selection) {
    if (!selection->isResultDependent())
      add(selection->getBeginLoc(), "choice " + std::to_string(selection->getResultIndex()));
    return true;
  }
  bool VisitCXXConstructExpr(clang::CXXConstructExpr* made) {  // dynamic_cast tells them by their types
    const auto* record = made->getConstructor()->getParent();
    if (record->isPolymorphic()) numbers_among_arguments(*record, made->getBeginLoc());
    return true;
  }
  bool VisitSubstNonTypeTemplateParmExpr(clang::SubstNonTypeTemplateParmExpr* expression) { return value(expression); }
  bool VisitCallExpr(clang::CallExpr* call) {
    called_.insert(call->getCallee()->IgnoreParenImpCasts());
    const clang::FunctionDecl* callee = call->getDirectCallee();
    if (callee != nullptr && callee->isConstexpr() && call->getNumArgs() == 0) value(call);
    return true;
  }
  bool VisitVarDecl(clang::VarDecl* variable) {
    if (llvm::isa<clang::ParmVarDecl>(variable)) return true;
    const clang::TypeSourceInfo* written = variable->getTypeSourceInfo();
    if (written == nullptr || written->getType()->getContainedDeducedType() != nullptr) return true;
    const std::string type = variable->getType().getCanonicalType().getAsString();
    if (type.find("physgen::") == std::string::npos) add(variable->getLocation(), type);
    return true;
  }

 private:
  void add(clang::SourceLocation location, std::string what) { facts_.insert({place_(location), std::move(what)}); }

  void name(const clang::NamedDecl& declaration, clang::SourceLocation location) {
    if (llvm::isa<clang::CXXConversionDecl>(declaration)) return;
    const auto* function = llvm::dyn_cast<clang::FunctionDecl>(&declaration);
    if (function != nullptr && function->isOverloadedOperator()) return;
    std::string text = declaration.getNameAsString();
    if (function != nullptr && function->getTemplateSpecializationArgs() != nullptr)
      for (const auto& argument : function->getTemplateSpecializationArgs()->asArray())
        if (argument.getKind() == clang::TemplateArgument::Integral)
          text += ' ' + llvm::toString(argument.getAsIntegral(), 10);
    add(location, std::move(text));
  }

  /// A variable that lives as long as the program exists once for each instance of the function or class around it.
  void one_for_each_type(const clang::VarDecl& variable, clang::SourceLocation location) {
    if (variable.getType().isConstQualified()) return;
    numbers_among_arguments(variable, location);
    for (const auto* around = variable.getDeclContext(); around != nullptr; around = around->getParent())
      if (const auto* named = llvm::dyn_cast<clang::NamedDecl>(around)) numbers_among_arguments(*named, location);
  }
  /// Which arguments of a template are types of numbers: what is read from a view is one where memory holds it, and a
  /// stand-in elsewhere.
  void numbers_among_arguments(const clang::NamedDecl& declaration, clang::SourceLocation location) {
    const clang::TemplateArgumentList* arguments = nullptr;
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(&declaration))
      arguments = function->getTemplateSpecializationArgs();
    if (const auto* record = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&declaration))
      arguments = &record->getTemplateArgs();
    if (const auto* variable = llvm::dyn_cast<clang::VarTemplateSpecializationDecl>(&declaration))
      arguments = &variable->getTemplateArgs();
    if (arguments == nullptr) return;
    std::string text = "types";
    for (const auto& argument : arguments->asArray()) {
      const bool is_number = argument.getKind() == clang::TemplateArgument::Type &&
                             argument.getAsType().getNonReferenceType()->isArithmeticType();
      text += is_number ? ' ' + argument.getAsType().getNonReferenceType().getUnqualifiedType().getAsString() : " -";
    }
    add(location, std::move(text));
  }

  void constant(const clang::VarDecl& variable, clang::SourceLocation location) {
    const clang::VarDecl* defined = nullptr;
    if (variable.getAnyInitializer(defined) == nullptr || !defined->isUsableInConstantExpressions(context_)) return;
    const clang::APValue* value = defined->evaluateValue();
    if (value != nullptr && !variable.getType()->isRecordType())
      add(location, value->getAsString(context_, variable.getType()));
  }

  bool value(const clang::Expr* expression) { return value(expression, expression->getBeginLoc()); }
  bool value(const clang::Expr* expression, clang::SourceLocation location) {
    clang::Expr::EvalResult result;
    if (expression == nullptr || expression->isValueDependent() ||
        !expression->getType()->isIntegralOrEnumerationType())
      return true;
    if (expression->EvaluateAsInt(result, context_)) add(location, llvm::toString(result.Val.getInt(), 10));
    return true;
  }

  clang::ASTContext& context_;
  const std::function<Place(clang::SourceLocation)>& place_;
  std::set<const clang::Expr*> called_;
  std::set<Fact> facts_;
};

}  // namespace

std::set<Fact> facts_of(const clang::Decl& code, clang::ASTContext& context,
                        const std::function<Place(clang::SourceLocation)>& place) {
  return Facts(context, place).of(code);
}

}  // namespace physgen::usage
