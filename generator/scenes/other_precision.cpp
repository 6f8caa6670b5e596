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

/// What has a function's name in a namespace of the program or in one within it, where arguments' types may find it.
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

}  // namespace

bool is_of_libraries(const clang::Decl& declared, const Names& names) {
  static const std::set<llvm::StringRef> spaces = {"Eigen", "physgen", "xsimd"};
  const clang::NamespaceDecl* space = nullptr;
  for (const auto* outer = declared.getDeclContext(); !outer->isTranslationUnit(); outer = outer->getParent())
    if (const auto* named = llvm::dyn_cast<clang::NamespaceDecl>(outer)) space = named;
  return space != nullptr && spaces.contains(space->getName()) && names.is_library(declared.getLocation());
}

bool is_of_precision(clang::QualType type, const Names& names) {
  const auto* record = type->getAsCXXRecordDecl();
  return record == nullptr ? type->isArithmeticType() || type->isVoidType() : is_of_libraries(*record, names);
}

bool is_one_text(const clang::CXXRecordDecl& record) {
  const auto* special = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&record);
  if (special == nullptr) return true;
  llvm::SmallVector<clang::ClassTemplatePartialSpecializationDecl*, 4> partial;
  special->getSpecializedTemplate()->getPartialSpecializations(partial);
  return partial.empty() && !is_specialised(*special->getSpecializedTemplate());
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
