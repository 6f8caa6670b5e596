// See other_precision.h.
#include "scenes/other_precision.h"

#include <clang/AST/DeclTemplate.h>

#include <algorithm>
#include <set>
#include <type_traits>

namespace physgen::scenes {
namespace {

using usage::Names;

bool is_explicit(const clang::Decl& declared) {
  const auto kind = [](const auto* one) { return one != nullptr ? one->getTemplateSpecializationKind() : 0; };
  const auto* whole = llvm::dyn_cast<clang::RedeclarableTemplateDecl>(&declared);
  return kind(llvm::dyn_cast<clang::FunctionDecl>(&declared)) == clang::TSK_ExplicitSpecialization ||
         kind(llvm::dyn_cast<clang::CXXRecordDecl>(&declared)) == clang::TSK_ExplicitSpecialization ||
         kind(llvm::dyn_cast<clang::VarDecl>(&declared)) == clang::TSK_ExplicitSpecialization ||
         (whole != nullptr && whole->isMemberSpecialization());
}

template <class Template>
bool specialises(const Template& whole, const Names& names) {
  return std::any_of(whole.spec_begin(), whole.spec_end(), [&](const auto* one) {
    if (is_explicit(*one)) return !names.is_library(one->getLocation());
    if constexpr (std::is_same_v<Template, clang::ClassTemplateDecl>) {
      const auto within = [&](const auto& self, const clang::DeclContext& outer) -> bool {
        return std::any_of(outer.decls_begin(), outer.decls_end(), [&](const clang::Decl* member) {
          const auto* inner = llvm::dyn_cast<clang::CXXRecordDecl>(member);
          const auto* of_functions = llvm::dyn_cast<clang::FunctionTemplateDecl>(member);
          if (of_functions != nullptr && specialises(*of_functions, names)) return true;
          return (is_explicit(*member) && !names.is_library(member->getLocation())) ||
                 (inner != nullptr && !inner->isInjectedClassName() && self(self, *inner));
        });
      };
      return within(within, *one);
    }
    return false;
  });
}

/// What a function is called with.
std::vector<clang::QualType> operands(const clang::FunctionDecl& function) {
  std::vector<clang::QualType> types;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&function);
  if (method != nullptr && method->isInstance() && !llvm::isa<clang::CXXConstructorDecl>(method))
    types.push_back(function.getASTContext().getCanonicalTagType(method->getParent()));
  for (const auto* one : function.parameters()) types.push_back(one->getType().getNonReferenceType());
  return types;
}

/// Whether a class of the program takes what has another type, or is a template that may be.
bool may_be(clang::QualType parameter, clang::QualType given) {
  const auto *to = parameter->getAsCXXRecordDecl(), *from = given->getAsCXXRecordDecl();
  if (from != nullptr && from->hasDefinition() && (parameter->isArithmeticType() || parameter->isEnumeralType()))
    return from->getDescribedClassTemplate() != nullptr || !from->getVisibleConversionFunctions().empty();
  if (to == nullptr || !to->hasDefinition() || llvm::isa<clang::ClassTemplateSpecializationDecl>(to) ||
      to->isDependentContext())
    return true;
  if (std::any_of(to->ctor_begin(), to->ctor_end(), [](const clang::CXXConstructorDecl* one) {
        return one->isConvertingConstructor(false) && !one->isCopyOrMoveConstructor() && one->getNumParams() > 0;
      }))
    return true;
  if (from == nullptr) return given->isDependentType();
  return !from->hasDefinition() || from->getCanonicalDecl() == to->getCanonicalDecl() || from->isDerivedFrom(to) ||
         !from->getVisibleConversionFunctions().empty();
}

/// Adds the namespaces in which calls with an argument of a type find functions.
void add_spaces(clang::QualType type, std::set<const clang::Decl*>& seen, std::set<const clang::DeclContext*>& spaces) {
  while (type->isAnyPointerType() || type->isReferenceType()) type = type->getPointeeType();
  const auto* tag = type->getBaseElementTypeUnsafe()->getAsTagDecl();
  if (tag == nullptr || !seen.insert(tag->getCanonicalDecl()).second) return;
  spaces.insert(tag->getEnclosingNamespaceContext()->getPrimaryContext());
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(tag);
  if (record != nullptr && record->hasDefinition())
    for (const auto& base : record->bases()) add_spaces(base.getType(), seen, spaces);
  if (const auto* special = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(tag))
    for (const auto& argument : special->getTemplateArgs().asArray()) {
      if (argument.getKind() == clang::TemplateArgument::Type) add_spaces(argument.getAsType(), seen, spaces);
      if (argument.getKind() == clang::TemplateArgument::Pack)
        for (const auto& one : argument.getPackAsArray())
          if (one.getKind() == clang::TemplateArgument::Type) add_spaces(one.getAsType(), seen, spaces);
    }
}

std::set<const clang::DeclContext*> spaces_of(const clang::FunctionDecl& function, const clang::Expr* call) {
  std::set<const clang::Decl*> seen;
  std::set<const clang::DeclContext*> spaces;
  for (const auto type : operands(function)) add_spaces(type, seen, spaces);
  if (call != nullptr)
    for (const clang::Stmt* part : call->children())
      if (const auto* argument = llvm::dyn_cast_or_null<clang::Expr>(part))
        add_spaces(argument->IgnoreUnlessSpelledInSource()->getType(), seen, spaces);
  return spaces;
}

/// Whether a function can be called with what another one is.
bool may_take(const clang::FunctionDecl* one, const clang::FunctionDecl& other) {
  if (one == nullptr) return false;
  const bool is_open = one->isVariadic() || (one->getNumParams() > 0 && one->parameters().back()->isParameterPack());
  const auto mine = operands(*one), given = operands(other);
  const std::size_t optional = one->getNumParams() - one->getMinRequiredArguments(),
                    omitted = other.getNumParams() - other.getMinRequiredArguments();
  return mine.size() <= given.size() + optional && (is_open || mine.size() + omitted >= given.size()) &&
         std::equal(mine.begin(), mine.begin() + std::min(mine.size(), given.size()), given.begin(), may_be);
}

/// Whether two functions that another precision may choose between return types that calculate alike.
bool return_alike(const clang::FunctionDecl& a, const clang::FunctionDecl& b, const Names& names) {
  const auto of_a = a.getReturnType().getNonReferenceType(), of_b = b.getReturnType().getNonReferenceType();
  return a.getASTContext().hasSameUnqualifiedType(of_a, of_b) ||
         (is_of_precision(of_a, names) && is_of_precision(of_b, names));
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

template <class Template>
bool OtherFunctions::is_specialised(const Template& whole) const {
  const auto [found, is_new] = specialised_.try_emplace(whole.getCanonicalDecl(), false);
  if (is_new) found->second = specialises(whole, names_);
  return found->second;
}

bool OtherFunctions::is_one_text(const clang::CXXRecordDecl& record) const {
  const auto* outer = llvm::dyn_cast<clang::CXXRecordDecl>(record.getDeclContext());
  if (outer != nullptr && !is_one_text(*outer)) return false;
  const auto* special = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&record);
  if (special == nullptr) return true;
  llvm::SmallVector<clang::ClassTemplatePartialSpecializationDecl*, 4> partial;
  special->getSpecializedTemplate()->getPartialSpecializations(partial);
  return std::ranges::all_of(partial, [&](const auto* one) { return names_.is_library(one->getLocation()); }) &&
         !is_specialised(*special->getSpecializedTemplate());
}

void OtherFunctions::collect(const clang::DeclContext& outer) {
  for (const clang::Decl* one : outer.decls()) {
    if (const auto* of_friend = llvm::dyn_cast<clang::FriendDecl>(one)) one = of_friend->getFriendDecl();
    if (one == nullptr || names_.is_library(one->getLocation())) continue;
    const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(one);
    if (const auto* whole = llvm::dyn_cast<clang::ClassTemplateDecl>(one)) record = whole->getTemplatedDecl();
    if (llvm::isa<clang::NamespaceDecl, clang::LinkageSpecDecl>(one))
      collect(*llvm::cast<clang::DeclContext>(one));
    else if (record != nullptr && record->isThisDeclarationADefinition() && !record->isInjectedClassName())
      collect(*record);
    else if (const auto* named = llvm::dyn_cast<clang::NamedDecl>(one);
             named != nullptr && named->getAsFunction() != nullptr &&
             (!llvm::isa<clang::CXXMethodDecl>(named->getAsFunction())))
      functions_[named->getDeclName()].push_back(named);
  }
}

std::vector<const clang::FunctionDecl*> OtherFunctions::of(const clang::FunctionDecl& function, const clang::Expr* call,
                                                           bool& is_known) const {
  std::vector<const clang::FunctionDecl*> result;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&function);
  if (method != nullptr && method->getParent()->isLambda()) return result;
  const bool is_library = names_.is_library(function.getLocation());
  is_known = is_known && (method == nullptr || is_one_text(*method->getParent()));
  const auto* primary = function.getPrimaryTemplate();
  if (primary != nullptr) is_known = is_known && !is_specialised(*primary);
  const auto* pattern = function.getTemplateInstantiationPattern();
  const auto add = [&](const clang::NamedDecl* named) {
    named = named->getUnderlyingDecl();
    const clang::FunctionDecl* own = named->getAsFunction();
    if (!may_take(own, function)) return;
    if (const auto* one = llvm::dyn_cast<clang::FunctionDecl>(named); one != nullptr && !one->isDeleted()) {
      if (one->isDependentContext())  // a friend of a template
        is_known = is_known && pattern != nullptr && pattern->getCanonicalDecl() == one->getCanonicalDecl();
      else
        result.push_back(one);
      is_known = is_known && (one->isDependentContext() || return_alike(*one, function, names_));
    }
    if (const auto* whole = llvm::dyn_cast<clang::FunctionTemplateDecl>(named))
      is_known = is_known && !whole->hasAssociatedConstraints() && !is_specialised(*whole) && primary != nullptr &&
                 primary->getCanonicalDecl() == whole->getCanonicalDecl();
  };
  if (llvm::isa<clang::CXXConversionDecl>(function) && !is_library)
    for (const clang::NamedDecl* one : method->getParent()->getVisibleConversionFunctions()) add(one);
  else if (method != nullptr && !is_library)
    for (const clang::NamedDecl* one : method->getParent()->lookup(function.getDeclName())) add(one);
  if (method == nullptr && function.isOverloadedOperator()) {  // operators that are members of its first operand
    const auto types = operands(function);
    const auto* first = types.empty() ? nullptr : types.front()->getAsCXXRecordDecl();
    const auto members = [&](const clang::CXXRecordDecl* record) {
      if (!names_.is_library(record->getLocation()))
        for (const clang::NamedDecl* one : record->lookup(function.getDeclName())) add(one);
      return true;
    };
    if (first != nullptr && first->hasDefinition() && members(first)) (void)first->forallBases(members);
  }
  const auto found = functions_.find(function.getDeclName());
  if (found == functions_.end() || (method != nullptr && !function.isOverloadedOperator())) return result;
  const auto spaces = is_library ? spaces_of(function, call) : std::set<const clang::DeclContext*>();
  for (const clang::NamedDecl* one : found->second)
    if (!is_library || spaces.contains(one->getDeclContext()->getEnclosingNamespaceContext()->getPrimaryContext()))
      add(one);
  return result;
}

}  // namespace physgen::scenes
