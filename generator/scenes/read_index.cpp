// See read_index.h. The text is read before it is instantiated, where the index and what depends on it have names.
#include "scenes/read_index.h"

#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprConcepts.h>
#include <clang/AST/RecursiveASTVisitor.h>

#include <algorithm>
#include <set>
#include <vector>

namespace physgen::scenes {
namespace {

using usage::Names;

/// The parameter T of a function's parameter of type T, const T or T&; null: its type is another.
const clang::TemplateTypeParmDecl* bare_parameter(const clang::ParmVarDecl& parameter) {
  const auto type = parameter.getType().getNonReferenceType().getUnqualifiedType();
  const auto* named = llvm::dyn_cast<clang::TemplateTypeParmType>(type.getTypePtr());
  return named == nullptr ? nullptr : named->getDecl();
}

bool mentions_variable(const clang::Stmt* statement) {
  if (statement == nullptr) return false;
  if (const auto* named = llvm::dyn_cast<clang::DeclRefExpr>(statement))
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(named->getDecl())) return variable->hasLocalStorage();
  return std::any_of(statement->child_begin(), statement->child_end(), mentions_variable);
}

class IndexUse : public clang::RecursiveASTVisitor<IndexUse> {
 public:
  IndexUse(const clang::FunctionDecl& function, const clang::FunctionDecl& pattern, const Names& names)
      : names_(names) {
    for (unsigned i = 0; i < function.getNumParams() && i < pattern.getNumParams(); ++i) {
      if (!is_pack(function.getParamDecl(i)->getType())) continue;
      indices_.insert(pattern.getParamDecl(i));
      if (const auto* type = bare_parameter(*pattern.getParamDecl(i)); type != nullptr) types_.insert(type);
    }
    for (const auto* type : types_)
      if (type->hasTypeConstraint()) say(type->getLocation());
  }

  bool TraverseStmt(clang::Stmt* statement) {
    path_.push_back(statement);
    const bool goes_on = clang::RecursiveASTVisitor<IndexUse>::TraverseStmt(statement);
    path_.pop_back();
    return goes_on;
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* named) {
    if (indices_.contains(named->getDecl()) && !is_used(*named)) say(named->getBeginLoc());
    return true;
  }
  bool VisitParmVarDecl(clang::ParmVarDecl* parameter) {
    if (parameter->getTypeSourceInfo() == nullptr) return true;
    clang::TypeLoc type = parameter->getTypeSourceInfo()->getTypeLoc().getUnqualifiedLoc();
    if (const auto reference = type.getAs<clang::ReferenceTypeLoc>())
      type = reference.getPointeeLoc().getUnqualifiedLoc();
    known_.insert(type.getBeginLoc());
    return true;
  }
  bool VisitTemplateSpecializationTypeLoc(clang::TemplateSpecializationTypeLoc type) {
    if (Names::is_physgen(type.getTypePtr()->getTemplateName().getAsTemplateDecl(), "lanes_t"))
      for (unsigned i = 0; i < type.getNumArgs(); ++i)
        if (const auto* argument = type.getArgLoc(i).getTypeSourceInfo(); argument != nullptr)
          known_.insert(argument->getTypeLoc().getBeginLoc());
    return true;
  }
  bool VisitTemplateTypeParmTypeLoc(clang::TemplateTypeParmTypeLoc type) {
    if (types_.contains(type.getDecl()) && !known_.contains(type.getBeginLoc())) say(type.getBeginLoc());
    return true;
  }
  // What asks for types may ask for that of an object at the index.
  bool VisitDecltypeTypeLoc(clang::DecltypeTypeLoc type) { return asks(type.getUnderlyingExpr(), type.getBeginLoc()); }
  bool VisitUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr* size) {
    return size->isArgumentType() || asks(size->getArgumentExpr(), size->getBeginLoc());
  }
  bool VisitCXXNoexceptExpr(clang::CXXNoexceptExpr* question) {
    return asks(question->getOperand(), question->getBeginLoc());
  }
  bool VisitRequiresExpr(clang::RequiresExpr* question) {
    say(question->getBeginLoc());
    return true;
  }

  std::string found;

 private:
  /// Whether the reference at the end of the path names an object, or is an argument.
  [[nodiscard]] bool is_used(const clang::DeclRefExpr& named) const {
    std::size_t at = path_.size() - 1;
    while (at > 0 && llvm::isa<clang::ParenExpr, clang::ImplicitCastExpr, clang::CXXConstructExpr>(path_[at - 1])) --at;
    if (at == 0) return false;
    const clang::Stmt *own = path_[at], *outer = path_[at - 1];
    if (const auto* call = llvm::dyn_cast<clang::CallExpr>(outer))
      return std::any_of(call->arg_begin(), call->arg_end(), [&](const clang::Expr* one) { return one == own; });
    const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(outer);
    return element != nullptr && element->getRHS() == own && &named != element->getLHS();
  }
  bool asks(const clang::Expr* of, clang::SourceLocation place) {
    if (mentions_variable(of)) say(place);
    return true;
  }
  void say(clang::SourceLocation place) {
    if (found.empty()) found = "asks what its index is at " + usage::text_of(names_.place(place));
  }

  const Names& names_;
  std::set<const clang::ValueDecl*> indices_;
  std::set<const clang::TemplateTypeParmDecl*> types_;
  std::set<clang::SourceLocation> known_;  // where their names may stand
  std::vector<const clang::Stmt*> path_;
};

}  // namespace

bool is_pack(clang::QualType type) {
  const auto* record = type.getNonReferenceType()->getAsCXXRecordDecl();
  return Names::is_physgen(record, "Pack") || Names::is_physgen(record, "PartialPack");
}

std::string asked_of_index(const clang::FunctionDecl& function, const Names& names) {
  const auto* pattern = function.getTemplateInstantiationPattern();
  if (pattern == nullptr) pattern = &function;
  IndexUse use(function, *pattern, names);
  if (auto* whole = pattern->getDescribedFunctionTemplate(); whole != nullptr)
    use.TraverseDecl(whole);
  else
    use.TraverseDecl(const_cast<clang::FunctionDecl*>(pattern));
  return use.found;
}

std::string asked_by_call(const clang::CallExpr& call, const Names& names) {
  const auto* callee = call.getDirectCallee();
  if (callee == nullptr) return {};
  const bool is_operator = llvm::isa<clang::CXXOperatorCallExpr>(call) && llvm::isa<clang::CXXMethodDecl>(callee);
  const auto takes_any = [](const clang::NamedDecl* candidate, unsigned number) {
    const auto* whole = llvm::dyn_cast<clang::FunctionTemplateDecl>(candidate);
    const auto* function =
        whole == nullptr ? llvm::dyn_cast<clang::FunctionDecl>(candidate) : whole->getTemplatedDecl();
    if (function == nullptr || (whole != nullptr && whole->hasAssociatedConstraints())) return false;
    return number >= function->getNumParams() || bare_parameter(*function->getParamDecl(number)) != nullptr;
  };
  for (unsigned i = is_operator ? 1 : 0; i < call.getNumArgs(); ++i) {
    if (!is_pack(call.getArg(i)->getType())) continue;
    const std::string where = " at " + usage::text_of(names.place(call.getBeginLoc()));
    if (names.is_library(callee->getLocation())) {
      const clang::DeclContext* outer = callee->getDeclContext();
      while (!outer->getParent()->isTranslationUnit()) outer = outer->getParent();
      const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(outer);
      if (space == nullptr || space->getName() != "physgen") return "hands its index to a library" + where;
      continue;
    }
    const auto found = callee->getDeclContext()->lookup(callee->getDeclName());
    if (!std::all_of(found.begin(), found.end(),
                     [&](const auto* one) { return takes_any(one, i - (is_operator ? 1U : 0U)); }))
      return "has its index choose a function" + where;
  }
  return {};
}

}  // namespace physgen::scenes
