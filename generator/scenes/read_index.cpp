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

/// Whether a constant is made of numbers alone, such as parameters of a template that are no types.
bool is_of_numbers(const clang::Stmt* constant) {
  if (const auto* named = llvm::dyn_cast<clang::DeclRefExpr>(constant)) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(named->getDecl());
    return llvm::isa<clang::NonTypeTemplateParmDecl>(named->getDecl()) ||
           (variable != nullptr && variable->isConstexpr() && variable->getInit() != nullptr &&
            is_of_numbers(variable->getInit()));
  }
  return llvm::isa<clang::IntegerLiteral, clang::CXXBoolLiteralExpr, clang::ParenExpr, clang::ImplicitCastExpr,
                   clang::ConstantExpr, clang::UnaryOperator, clang::BinaryOperator>(constant) &&
         std::all_of(constant->child_begin(), constant->child_end(), is_of_numbers);
}

bool is_specialised(const auto& whole) {
  return std::any_of(whole.spec_begin(), whole.spec_end(), [](const auto* one) {
    return one->getTemplateSpecializationKind() == clang::TSK_ExplicitSpecialization;
  });
}

/// Whether a function takes as many arguments as a call of another may give it.
bool may_take(const clang::FunctionDecl* one, const clang::FunctionDecl& other) {
  if (one == nullptr) return false;
  const bool is_open = one->isVariadic() || (one->getNumParams() > 0 && one->parameters().back()->isParameterPack());
  return one->getMinRequiredArguments() <= other.getNumParams() &&
         (is_open || one->getNumParams() >= other.getMinRequiredArguments());
}

class IndexUse : public clang::RecursiveASTVisitor<IndexUse> {
 public:
  IndexUse(const clang::FunctionDecl& function, const clang::FunctionDecl& pattern, Names& names)
      : names_(names), sees_arrays_(sees_arrays(function, names)) {
    const unsigned declared = pattern.getNumParams();
    for (unsigned i = 0; i < function.getNumParams() && declared > 0; ++i) {
      if (!is_pack(function.getParamDecl(i)->getType())) continue;
      if (i >= declared || pattern.getParamDecl(i)->isParameterPack()) {
        say(pattern.getLocation());
        break;
      }
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
    if (sees_arrays_) say(question->getBeginLoc());
    return true;
  }
  // Numbers that are given to templates may choose their code.
  bool TraverseTemplateArgumentLoc(const clang::TemplateArgumentLoc& argument) {
    if (argument.getArgument().getKind() == clang::TemplateArgument::Expression &&
        !is_of_numbers(argument.getSourceExpression()))
      say(argument.getLocation(), "chooses its code by types");
    return clang::RecursiveASTVisitor<IndexUse>::TraverseTemplateArgumentLoc(argument);
  }
  bool VisitNonTypeTemplateParmDecl(clang::NonTypeTemplateParmDecl* number) {
    if (number->hasDefaultArgument()) return TraverseTemplateArgumentLoc(number->getDefaultArgument());
    return true;
  }
  bool VisitTypedefTypeLoc(clang::TypedefTypeLoc type) {
    const auto* alias = type.getTypePtr()->getDecl();
    if (names_.is_library(alias->getLocation()) || !aliases_.insert(alias).second) return true;
    return alias->getTypeSourceInfo() == nullptr || TraverseTypeLoc(alias->getTypeSourceInfo()->getTypeLoc());
  }
  bool VisitIfStmt(clang::IfStmt* choice) {
    if (choice->isConstexpr() && !is_of_numbers(choice->getCond()))
      say(choice->getBeginLoc(), "chooses its code by types");
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
    if (sees_arrays_ && mentions_variable(of)) say(place);
    return true;
  }
  void say(clang::SourceLocation place, const char* what = "asks what its index is") {
    if (found.empty()) found = std::string(what) + " at " + usage::text_of(names_.place(place));
  }

  const Names& names_;
  const bool sees_arrays_;
  std::set<const clang::ValueDecl*> indices_;
  std::set<const clang::TemplateTypeParmDecl*> types_;
  std::set<clang::SourceLocation> known_;  // where their names may stand
  std::set<const clang::Decl*> aliases_;   // that were looked at
  std::vector<const clang::Stmt*> path_;
};

}  // namespace

bool is_pack(clang::QualType type) {
  const auto* record = type.getNonReferenceType()->getAsCXXRecordDecl();
  return Names::is_physgen(record, "Pack") || Names::is_physgen(record, "PartialPack");
}

std::string asked_of_index(const clang::FunctionDecl& function, Names& names) {
  const auto* pattern = function.getTemplateInstantiationPattern();
  if (pattern == nullptr) pattern = &function;
  IndexUse use(function, *pattern, names);
  if (auto* whole = pattern->getDescribedFunctionTemplate(); whole != nullptr)
    use.TraverseDecl(whole);
  else
    use.TraverseDecl(const_cast<clang::FunctionDecl*>(pattern));
  return use.found;
}

bool sees_arrays(const clang::FunctionDecl& function, Names& names) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&function);
  if (method != nullptr && !names.arrays(function.getASTContext().getCanonicalTagType(method->getParent())).empty())
    return true;
  return std::any_of(function.param_begin(), function.param_end(), [&](const clang::ParmVarDecl* parameter) {
    return is_pack(parameter->getType()) || !names.arrays(parameter->getType()).empty();
  });
}

bool is_one_text(const clang::CXXRecordDecl& record) {
  const auto* special = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&record);
  if (special == nullptr) return true;
  llvm::SmallVector<clang::ClassTemplatePartialSpecializationDecl*, 4> partial;
  special->getSpecializedTemplate()->getPartialSpecializations(partial);
  return partial.empty() && !is_specialised(*special->getSpecializedTemplate());
}

std::vector<const clang::FunctionDecl*> namesakes(const clang::FunctionDecl& function, bool& is_known) {
  std::vector<const clang::FunctionDecl*> result;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&function);
  if (method != nullptr && method->getParent()->isLambda()) return result;
  is_known = is_known && (method == nullptr || is_one_text(*method->getParent()));
  const auto add = [&](const clang::NamedDecl* named) {
    named = named->getUnderlyingDecl();
    if (!may_take(named->getAsFunction(), function)) return;
    if (const auto* one = llvm::dyn_cast<clang::FunctionDecl>(named); one != nullptr && !one->isDeleted())
      result.push_back(one);
    if (const auto* whole = llvm::dyn_cast<clang::FunctionTemplateDecl>(named))
      is_known = is_known && !whole->hasAssociatedConstraints() && !is_specialised(*whole) &&
                 function.getPrimaryTemplate() != nullptr &&
                 function.getPrimaryTemplate()->getCanonicalDecl() == whole->getCanonicalDecl();
  };
  if (llvm::isa<clang::CXXConversionDecl>(function))
    for (const clang::NamedDecl* one : method->getParent()->getVisibleConversionFunctions()) add(one);
  else
    for (const clang::NamedDecl* one : function.getDeclContext()->lookup(function.getDeclName())) add(one);
  return result;
}

}  // namespace physgen::scenes
