// See read_index.h. The text is read before it is instantiated, where the index and what depends on it have names.
#include "scenes/read_index.h"

#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprConcepts.h>
#include <clang/AST/RecursiveASTVisitor.h>

#include <algorithm>
#include <set>
#include <vector>

#include "scenes/other_precision.h"

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

class IndexUse : public clang::RecursiveASTVisitor<IndexUse> {
 public:
  /// @param instance a function or a class, whose templates' arguments are known
  IndexUse(const clang::DeclContext& instance, Names& names, bool sees_arrays)
      : names_(names), sees_arrays_(sees_arrays) {
    for (const auto* outer = &instance; outer != nullptr; outer = outer->getParent()) {
      const auto* special = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(outer);
      const auto* function = llvm::dyn_cast<clang::FunctionDecl>(outer);
      if (special != nullptr)
        arguments_.insert(arguments_.begin(), special->getTemplateArgs().asArray());
      else if (function != nullptr && function->getTemplateSpecializationArgs() != nullptr)
        arguments_.insert(arguments_.begin(), function->getTemplateSpecializationArgs()->asArray());
    }
  }
  void read(const clang::FunctionDecl& function, clang::FunctionDecl& pattern) {
    outer_ = &pattern;
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
    if (auto* whole = pattern.getDescribedFunctionTemplate(); whole != nullptr)
      TraverseDecl(whole);
    else
      TraverseDecl(&pattern);
  }
  /// What a class is made of.
  void read(const clang::CXXRecordDecl& pattern) {
    outer_ = &pattern;
    for (const auto& base : pattern.bases()) TraverseTypeLoc(base.getTypeSourceInfo()->getTypeLoc());
    for (const auto* member : pattern.fields()) TraverseTypeLoc(member->getTypeSourceInfo()->getTypeLoc());
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
    const auto* alias =
        llvm::dyn_cast_or_null<clang::TypeAliasTemplateDecl>(type.getTypePtr()->getTemplateName().getAsTemplateDecl());
    if (alias != nullptr && alias->isInStdNamespace() && !chooses_by_numbers(*alias))
      say(type.getBeginLoc(), "chooses its code by types");
    return alias == nullptr || read_alias(*alias->getTemplatedDecl());
  }
  // Guides of the program may choose by types.
  bool VisitDeducedTemplateSpecializationTypeLoc(clang::DeducedTemplateSpecializationTypeLoc type) {
    const auto* whole = type.getTypePtr()->getTemplateName().getAsTemplateDecl();
    if (whole == nullptr || !names_.is_library(whole->getLocation()))
      say(type.getBeginLoc(), "chooses its code by types");
    return true;
  }
  // Such a class may be another one for another precision.
  bool VisitDependentNameTypeLoc(clang::DependentNameTypeLoc type) {
    const auto of = type.getTypePtr()->getQualifier();
    const clang::Type* outer = of.getKind() == clang::NestedNameSpecifier::Kind::Type ? of.getAsType() : nullptr;
    const auto* given = llvm::dyn_cast_or_null<clang::TemplateTypeParmType>(outer);
    const auto* made = llvm::dyn_cast_or_null<clang::TemplateSpecializationType>(outer);
    const auto* whole = made == nullptr ? nullptr : made->getTemplateName().getAsTemplateDecl();
    if (!is_generated(type.getBeginLoc()) && !(given != nullptr && is_given(*given)) &&
        !(whole != nullptr && is_of_libraries(*whole, names_)))
      say(type.getBeginLoc(), "chooses its code by types");
    return true;
  }
  bool VisitUnresolvedUsingTypeLoc(clang::UnresolvedUsingTypeLoc type) {
    say(type.getBeginLoc(), "chooses its code by types");
    return true;
  }
  /// Another precision may call any of them.
  bool VisitUnresolvedLookupExpr(clang::UnresolvedLookupExpr* callee) {
    const auto is_library = [&](const clang::NamedDecl* named) {
      return names_.is_library(named->getUnderlyingDecl()->getLocation());
    };
    const bool has_library = std::any_of(callee->decls_begin(), callee->decls_end(), is_library);
    for (const clang::NamedDecl* named : callee->decls()) {
      if (is_library(named)) continue;
      if (has_library) say(callee->getBeginLoc(), "chooses its code by types");
      named = named->getUnderlyingDecl();
      if (const auto* one = llvm::dyn_cast<clang::FunctionDecl>(named))
        candidates.emplace_back(one, callee);
      else if (callee->getNumDecls() > 1)
        say(callee->getBeginLoc(), "chooses its code by types");
    }
    return true;
  }
  bool VisitTemplateTypeParmTypeLoc(clang::TemplateTypeParmTypeLoc type) {
    if (types_.contains(type.getDecl()) && !known_.contains(type.getBeginLoc())) say(type.getBeginLoc());
    return true;
  }
  // What asks for types may ask for that of an object at the index.
  bool VisitDecltypeTypeLoc(clang::DecltypeTypeLoc type) {
    if (!is_generated(type.getBeginLoc()) && !llvm::isa<clang::DeclRefExpr>(type.getUnderlyingExpr()->IgnoreParens()))
      say(type.getBeginLoc(), "chooses its code by types");
    return asks(type.getUnderlyingExpr(), type.getBeginLoc());
  }
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
  bool VisitTypedefTypeLoc(clang::TypedefTypeLoc type) { return read_alias(*type.getTypePtr()->getDecl()); }
  bool VisitIfStmt(clang::IfStmt* choice) {
    if (choice->isConstexpr() && !is_of_numbers(choice->getCond()))
      say(choice->getBeginLoc(), "chooses its code by types");
    return true;
  }

  std::string found;
  std::vector<Candidate> candidates;

 private:
  /// Accessors name the places of fields, `typename Record::f`.
  [[nodiscard]] bool is_generated(clang::SourceLocation place) const {
    const auto& sources = outer_->getParentASTContext().getSourceManager();
    return sources.getFilename(sources.getFileLoc(place)).ends_with(".physgen.h");
  }
  /// Whether an alias of std takes references and qualifiers away, or chooses by a number, which is looked at by
  /// itself.
  [[nodiscard]] static bool chooses_by_numbers(const clang::NamedDecl& alias) {
    static const std::set<llvm::StringRef> listed = {"conditional_t",      "decay_t",        "enable_if_t",
                                                     "remove_const_t",     "remove_cv_t",    "remove_cvref_t",
                                                     "remove_reference_t", "type_identity_t"};
    return listed.contains(alias.getName());
  }
  /// Whether a parameter's argument is a type whose own types are known to differ in the precision alone.
  [[nodiscard]] bool is_given(const clang::TemplateTypeParmType& parameter) const {
    if (is_foreign_ || parameter.getDepth() >= arguments_.size()) return false;
    const auto given = arguments_[parameter.getDepth()];
    return parameter.getIndex() < given.size() &&
           given[parameter.getIndex()].getKind() == clang::TemplateArgument::Type &&
           is_of_precision(given[parameter.getIndex()].getAsType().getNonReferenceType(), names_);
  }
  bool read_alias(const clang::TypedefNameDecl& alias) {
    if (names_.is_library(alias.getLocation()) || !aliases_.insert(&alias).second) return true;
    if (alias.getTypeSourceInfo() == nullptr) return true;
    const bool was_foreign = is_foreign_;
    is_foreign_ = is_foreign_ || !alias.getDeclContext()->Encloses(outer_) ||
                  (llvm::isa<clang::TypeAliasDecl>(alias) &&
                   llvm::cast<clang::TypeAliasDecl>(alias).getDescribedAliasTemplate() != nullptr);
    const bool goes_on = TraverseTypeLoc(alias.getTypeSourceInfo()->getTypeLoc());
    is_foreign_ = was_foreign;
    return goes_on;
  }
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
  const clang::DeclContext* outer_ = nullptr;                       // what is read
  std::vector<llvm::ArrayRef<clang::TemplateArgument>> arguments_;  // of its templates, the outermost first
  bool is_foreign_ = false;                                         // in an alias with other parameters than these
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

std::string asked_of_index(const clang::FunctionDecl& function, Names& names, std::vector<Candidate>& candidates) {
  const auto* pattern = function.getTemplateInstantiationPattern();
  if (pattern == nullptr) pattern = &function;
  IndexUse use(function, names, sees_arrays(function, names));
  use.read(function, const_cast<clang::FunctionDecl&>(*pattern));
  candidates = use.candidates;
  return use.found;
}

std::string asked_of_class(const clang::CXXRecordDecl& record, Names& names) {
  const auto* pattern = record.getTemplateInstantiationPattern();
  if (pattern == nullptr || record.isLambda()) return {};
  IndexUse use(record, names, false);
  use.read(*pattern);
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

}  // namespace physgen::scenes
