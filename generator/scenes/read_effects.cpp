// See read_effects.h.
#include "scenes/read_effects.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/ExprCXX.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace physgen::scenes {
namespace {

class Effects {
 public:
  explicit Effects(const usage::Names& names) : names_(names) {}

  std::string of(const clang::Stmt* expression) {
    if (expression == nullptr) return {};
    if (const auto* initial = llvm::dyn_cast<clang::CXXDefaultInitExpr>(expression)) return of(initial->getExpr());
    if (const auto* argument = llvm::dyn_cast<clang::CXXDefaultArgExpr>(expression)) return of(argument->getExpr());
    std::string reason = own(*expression);
    if (llvm::isa<clang::LambdaExpr>(expression)) return reason;  // its body is run when it is called
    for (const clang::Stmt* child : expression->children())
      if (reason.empty()) reason = of(child);
    return reason;
  }

 private:
  [[nodiscard]] std::string own(const clang::Stmt& expression) {
    if (const auto* called = llvm::dyn_cast<clang::CallExpr>(&expression)) return call(*called);
    if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(&expression)) return construct(*made);
    if (const auto* one = llvm::dyn_cast<clang::UnaryOperator>(&expression);
        one && one->isIncrementDecrementOp() && !is_own_variable(one->getSubExpr()))
      return at("changes a variable", expression);
    if (const auto* two = llvm::dyn_cast<clang::BinaryOperator>(&expression);
        two && two->isAssignmentOp() && !is_own_variable(two->getLHS()))
      return at("changes a variable", expression);
    if (llvm::isa<clang::CXXNewExpr, clang::CXXDeleteExpr, clang::CXXThrowExpr, clang::StmtExpr, clang::CoawaitExpr,
                  clang::CoyieldExpr, clang::AsmStmt, clang::CXXConstCastExpr>(&expression))
      return at("does more than to name values", expression);
    return {};
  }

  [[nodiscard]] std::string call(const clang::CallExpr& call) {
    const auto* callee = call.getDirectCallee();
    if (callee == nullptr) return at("calls what is not known", call);
    const std::string name = callee->getNameAsString();
    if (is_of_runtime(*callee)) {
      static constexpr std::array known = {"view", "const_view", "size", "local", "locals", "fuse", "over"};
      if (std::find(known.begin(), known.end(), name) != known.end()) return {};
    }
    return is_constant(*callee) ? std::string() : at("calls " + name + "()", call);
  }
  [[nodiscard]] std::string construct(const clang::CXXConstructExpr& made) {
    const auto& constructor = *made.getConstructor();
    if (!constructor.getParent()->hasTrivialDestructor() && !is_of_runtime(constructor))
      return at("calls the destructor of " + constructor.getParent()->getNameAsString(), made);
    if (is_of_runtime(constructor) || is_constant(constructor)) return {};
    if (constructor.isImplicit() || constructor.isDefaulted()) {
      for (const auto* member : constructor.inits())
        if (std::string reason = of(member->getInit()); !reason.empty()) return reason;
      return {};
    }
    return at("calls the constructor of " + constructor.getParent()->getNameAsString(), made);
  }

  /// A function of constants, which changes nothing that it is given, and nothing else: constexpr says so only of what
  /// is evaluated by the compiler.
  [[nodiscard]] bool is_constant(const clang::FunctionDecl& function) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&function);
    if (method != nullptr && method->isInstance() && !method->isConst() &&
        !llvm::isa<clang::CXXConstructorDecl>(method))
      return false;
    const bool takes_constants = std::all_of(function.param_begin(), function.param_end(), [](const auto* parameter) {
      const auto type = parameter->getType();
      return !type->isPointerType() && (!type->isReferenceType() || type.getNonReferenceType().isConstQualified());
    });
    const clang::FunctionDecl* definition = nullptr;
    if (!function.isConstexpr() || !takes_constants) return false;
    if (names_.is_library(function.getLocation()) || !function.isDefined(definition)) return true;
    if (!seen_.insert(definition->getCanonicalDecl()).second) return true;
    const bool is_within = std::exchange(in_function_, true);
    std::string effects = of(definition->getBody());
    if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(definition))
      for (const auto* member : constructor->inits())
        if (effects.empty()) effects = of(member->getInit());
    in_function_ = is_within;
    if (!effects.empty()) seen_.erase(definition->getCanonicalDecl());
    return effects.empty();
  }
  /// Whether a function that is called changes a variable of its own, or a constructor the object that it makes.
  [[nodiscard]] bool is_own_variable(const clang::Expr* changed) const {
    changed = changed->IgnoreParenImpCasts();
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(changed))
      return llvm::isa<clang::FieldDecl>(member->getMemberDecl()) && !member->isArrow() &&
             is_own_variable(member->getBase());
    if (const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(changed);
        element != nullptr && element->getBase()->IgnoreParenImpCasts()->getType()->isArrayType())
      return is_own_variable(element->getBase());
    const auto* named = llvm::dyn_cast<clang::DeclRefExpr>(changed);
    const auto* variable = named == nullptr ? nullptr : llvm::dyn_cast<clang::VarDecl>(named->getDecl());
    return in_function_ && variable != nullptr && variable->hasLocalStorage() &&
           !variable->getType()->isReferenceType();
  }
  [[nodiscard]] bool is_of_runtime(const clang::Decl& declaration) const {
    return names_.place(declaration.getLocation()).file.starts_with("physgen/");
  }
  [[nodiscard]] std::string at(const std::string& what, const clang::Stmt& where) const {
    return "it " + what + " at " + usage::text_of(names_.place(where.getBeginLoc()));
  }

  const usage::Names& names_;
  std::set<const clang::FunctionDecl*> seen_;
  bool in_function_ = false;  // that the expression calls
};

}  // namespace

std::string effects_of(const clang::Expr* expression, const usage::Names& names) {
  return Effects(names).of(expression);
}

std::string effects_of(const clang::VarDecl& variable, const usage::Names& names) {
  std::string effects = effects_of(variable.getInit(), names);
  if (const auto* parts = llvm::dyn_cast<clang::DecompositionDecl>(&variable))
    for (const auto* part : parts->bindings())
      if (const auto* holder = part->getHoldingVar(); holder != nullptr && effects.empty())
        effects = effects_of(holder->getInit(), names);
  return effects;
}

std::optional<std::vector<std::string>> names_of(const clang::Decl& declaration) {
  std::vector<std::string> result;
  if (const auto* parts = llvm::dyn_cast<clang::DecompositionDecl>(&declaration)) {
    for (const auto* part : parts->bindings()) result.push_back(part->getNameAsString());
    return result;
  }
  if (llvm::isa<clang::StaticAssertDecl>(declaration)) return result;
  if (const auto* kind = llvm::dyn_cast<clang::EnumDecl>(&declaration))
    for (const auto* one : kind->enumerators()) result.push_back(one->getNameAsString());
  const auto* named = llvm::dyn_cast<clang::NamedDecl>(&declaration);
  if (named == nullptr || llvm::isa<clang::UsingDirectiveDecl, clang::UsingEnumDecl>(declaration)) return std::nullopt;
  if (named->getIdentifier() != nullptr)
    result.push_back(named->getNameAsString());
  else if (!llvm::isa<clang::EnumDecl>(declaration))
    return std::nullopt;
  return result;
}

bool is_of_macro(const clang::Stmt* expression) {
  if (expression == nullptr ||
      llvm::isa<clang::IntegerLiteral, clang::FloatingLiteral, clang::CXXBoolLiteralExpr>(expression))
    return false;
  if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(expression)) return is_of_macro(cast->getSubExpr());
  if (llvm::isa<clang::CXXDefaultArgExpr, clang::CXXDefaultInitExpr, clang::LambdaExpr>(expression)) return false;
  if (expression->getBeginLoc().isMacroID()) return true;
  return std::any_of(expression->child_begin(), expression->child_end(), is_of_macro);
}

}  // namespace physgen::scenes
