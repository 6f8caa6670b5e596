// See other_precision.h.
#include "scenes/other_precision.h"

#include <clang/AST/DeclTemplate.h>

#include <algorithm>
#include <set>

namespace physgen::scenes {
namespace {

using usage::Names;

bool is_specialised(const auto& whole) {
  return std::any_of(whole.spec_begin(), whole.spec_end(), [](const auto* one) {
    return one->getTemplateSpecializationKind() == clang::TSK_ExplicitSpecialization;
  });
}

/// Whether something in a class of a template's instance has a text of its own.
bool has_special_members(const clang::CXXRecordDecl& record) {
  const auto is_special = [](clang::TemplateSpecializationKind kind) {
    return kind == clang::TSK_ExplicitSpecialization;
  };
  return std::any_of(record.decls_begin(), record.decls_end(), [&](const clang::Decl* one) {
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(one))
      return is_special(function->getTemplateSpecializationKind());
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(one))
      return is_special(variable->getTemplateSpecializationKind());
    if (const auto* type = llvm::dyn_cast<clang::EnumDecl>(one))
      return is_special(type->getTemplateSpecializationKind());
    if (const auto* inner = llvm::dyn_cast<clang::CXXRecordDecl>(one))
      return is_special(inner->getTemplateSpecializationKind()) || has_special_members(*inner);
    if (const auto* whole = llvm::dyn_cast<clang::RedeclarableTemplateDecl>(one); whole != nullptr) {
      if (whole->isMemberSpecialization()) return true;
      if (const auto* functions = llvm::dyn_cast<clang::FunctionTemplateDecl>(whole)) return is_specialised(*functions);
      if (const auto* classes = llvm::dyn_cast<clang::ClassTemplateDecl>(whole)) return is_specialised(*classes);
      if (const auto* variables = llvm::dyn_cast<clang::VarTemplateDecl>(whole)) return is_specialised(*variables);
    }
    return false;
  });
}

/// Whether a function takes as many arguments as a call of another may give it.
bool may_take(const clang::FunctionDecl* one, const clang::FunctionDecl& other) {
  if (one == nullptr) return false;
  const bool is_open = one->isVariadic() || (one->getNumParams() > 0 && one->parameters().back()->isParameterPack());
  return one->getMinRequiredArguments() <= other.getNumParams() &&
         (is_open || one->getNumParams() >= other.getMinRequiredArguments());
}

/// Whether two functions that another precision may choose between return types that calculate alike.
bool return_alike(const clang::FunctionDecl& a, const clang::FunctionDecl& b, const Names& names) {
  const auto of_a = a.getReturnType().getNonReferenceType(), of_b = b.getReturnType().getNonReferenceType();
  return a.getASTContext().hasSameUnqualifiedType(of_a, of_b) ||
         (is_of_precision(of_a, names) && is_of_precision(of_b, names));
}

/// What has a function's name in a namespace or in one within it, where arguments' types may find it. A program may add
/// to the namespaces of libraries.
std::vector<const clang::NamedDecl*> in_namespaces(const clang::DeclContext& outer, const clang::FunctionDecl& function,
                                                   const Names& names) {
  std::vector<const clang::NamedDecl*> result;
  for (const clang::NamedDecl* one : outer.lookup(function.getDeclName()))
    if (outer.Equals(function.getDeclContext()) || !names.is_library(one->getLocation())) result.push_back(one);
  for (const auto* inner : outer.decls())
    if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(inner);
        space != nullptr && !names.is_library(space->getLocation()))
      for (const auto* one : in_namespaces(*space, function, names)) result.push_back(one);
  return result;
}

llvm::StringRef outer_space(const clang::Decl& declared) {
  const clang::NamespaceDecl* space = nullptr;
  for (const auto* outer = declared.getDeclContext(); !outer->isTranslationUnit(); outer = outer->getParent())
    if (const auto* named = llvm::dyn_cast<clang::NamespaceDecl>(outer)) space = named;
  return space == nullptr ? "" : space->getName();
}

/// Whether an argument, in another precision, may be given to a parameter of this type.
bool may_become(clang::QualType argument, clang::QualType parameter, const Names& names) {
  const auto* given = argument.getNonReferenceType()->getAsCXXRecordDecl();
  const bool is_number = given == nullptr || outer_space(*given) == "xsimd";
  // Accessors of the runtime, and classes of the program, may convert to anything.
  if (!is_number && (outer_space(*given) == "physgen" || !is_of_libraries(*given, names))) return true;
  const auto* made = llvm::dyn_cast<clang::TemplateSpecializationType>(parameter.getTypePtr());
  const clang::NamedDecl* wanted = parameter->getAsCXXRecordDecl();
  if (wanted == nullptr && made != nullptr) wanted = made->getTemplateName().getAsTemplateDecl();
  if (wanted == nullptr) return is_number || parameter->isDependentType();
  if (is_of_libraries(*wanted, names)) return given != nullptr && outer_space(*given) == outer_space(*wanted);
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(wanted);
  if (record == nullptr || !record->hasDefinition()) return record != nullptr;
  return std::any_of(record->decls_begin(), record->decls_end(), [](const clang::Decl* one) {
    const auto* whole = llvm::dyn_cast<clang::FunctionTemplateDecl>(one);
    const auto* maker = llvm::dyn_cast<clang::CXXConstructorDecl>(whole != nullptr ? whole->getTemplatedDecl() : one);
    return maker != nullptr && !maker->isCopyOrMoveConstructor() && maker->getNumParams() > 0 &&
           maker->getMinRequiredArguments() <= 1;
  });
}

}  // namespace

bool is_of_libraries(const clang::Decl& declared, const Names& names) {
  static const std::set<llvm::StringRef> spaces = {"Eigen", "physgen", "xsimd"};
  return spaces.contains(outer_space(declared)) && names.is_library(declared.getLocation());
}

bool is_of_precision(clang::QualType type, const Names& names) {
  const auto* record = type->getAsCXXRecordDecl();
  return record == nullptr ? type->isArithmeticType() || type->isVoidType() : is_of_libraries(*record, names);
}

bool is_one_text(const clang::CXXRecordDecl& record) {
  const auto* outer = llvm::dyn_cast<clang::CXXRecordDecl>(record.getDeclContext());
  if (outer != nullptr && !is_one_text(*outer)) return false;
  const auto* special = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&record);
  if (special == nullptr) return true;
  const auto& whole = *special->getSpecializedTemplate();
  llvm::SmallVector<clang::ClassTemplatePartialSpecializationDecl*, 4> partial;
  whole.getPartialSpecializations(partial);
  return partial.empty() && !whole.isMemberSpecialization() && !is_specialised(whole) &&
         std::none_of(whole.spec_begin(), whole.spec_end(), [](const auto* one) { return has_special_members(*one); });
}

const clang::NamedDecl* rival(const clang::FunctionDecl& called, llvm::ArrayRef<clang::QualType> arguments,
                              const Names& names) {
  if (!called.getDeclName().isIdentifier() && !called.isOverloadedOperator()) return nullptr;
  for (const clang::NamedDecl* one : in_namespaces(*called.getASTContext().getTranslationUnitDecl(), called, names)) {
    const auto* other = one->getUnderlyingDecl()->getAsFunction();
    if (other == nullptr || names.is_library(other->getLocation()) || other->isDeleted()) continue;
    const unsigned declared = other->getNumParams();
    const bool is_open = other->isVariadic() || (declared > 0 && other->parameters().back()->isParameterPack());
    if (arguments.size() < other->getMinRequiredArguments() || (arguments.size() > declared && !is_open)) continue;
    bool takes = true;
    for (unsigned i = 0; i < arguments.size() && i < declared && takes; ++i)
      takes = other->getParamDecl(i)->isParameterPack() ||
              may_become(arguments[i], other->getParamDecl(i)->getType().getNonReferenceType(), names);
    if (takes) return other;
  }
  return nullptr;
}

std::vector<const clang::FunctionDecl*> namesakes(const clang::FunctionDecl& function, const Names& names,
                                                  bool& is_known) {
  std::vector<const clang::FunctionDecl*> result;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&function);
  if (method != nullptr && method->getParent()->isLambda()) return result;
  is_known = is_known && (method == nullptr || is_one_text(*method->getParent()));
  const auto add = [&](const clang::NamedDecl* named) {
    named = named->getUnderlyingDecl();
    if (!may_take(named->getAsFunction(), function)) return;
    if (const auto* one = llvm::dyn_cast<clang::FunctionDecl>(named); one != nullptr && !one->isDeleted()) {
      is_known = is_known && return_alike(*one, function, names);
      result.push_back(one);
    }
    if (const auto* whole = llvm::dyn_cast<clang::FunctionTemplateDecl>(named))
      is_known = is_known && !whole->hasAssociatedConstraints() && !is_specialised(*whole) &&
                 function.getPrimaryTemplate() != nullptr &&
                 function.getPrimaryTemplate()->getCanonicalDecl() == whole->getCanonicalDecl();
  };
  if (llvm::isa<clang::CXXConversionDecl>(function))
    for (const clang::NamedDecl* one : method->getParent()->getVisibleConversionFunctions()) add(one);
  else if (method != nullptr)
    for (const clang::NamedDecl* one : method->getParent()->lookup(function.getDeclName())) add(one);
  else
    for (const clang::NamedDecl* one :
         in_namespaces(*function.getASTContext().getTranslationUnitDecl(), function, names))
      add(one);
  return result;
}

}  // namespace physgen::scenes
