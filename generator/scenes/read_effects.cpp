// See read_effects.h.
#include "scenes/read_effects.h"

#include <clang/AST/ExprCXX.h>

#include <algorithm>
#include <array>

namespace physgen::scenes {
namespace {

class Effects {
 public:
  explicit Effects(const usage::Names& names) : names_(names) {}

  std::string of(const clang::Stmt* expression) const {
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
  [[nodiscard]] std::string own(const clang::Stmt& expression) const {
    if (const auto* called = llvm::dyn_cast<clang::CallExpr>(&expression)) return call(*called);
    if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(&expression)) return construct(*made);
    if (const auto* one = llvm::dyn_cast<clang::UnaryOperator>(&expression); one && one->isIncrementDecrementOp())
      return at("changes a variable", expression);
    if (const auto* two = llvm::dyn_cast<clang::BinaryOperator>(&expression); two && two->isAssignmentOp())
      return at("changes a variable", expression);
    if (llvm::isa<clang::CXXNewExpr, clang::CXXDeleteExpr, clang::CXXThrowExpr, clang::StmtExpr>(&expression))
      return at("does more than to name values", expression);
    return {};
  }

  [[nodiscard]] std::string call(const clang::CallExpr& call) const {
    const auto* callee = call.getDirectCallee();
    if (callee == nullptr) return at("calls what is not known", call);
    const std::string name = callee->getNameAsString();
    if (is_of_runtime(*callee)) {
      static constexpr std::array known = {"view", "const_view", "size", "local", "locals", "fuse", "over"};
      if (std::find(known.begin(), known.end(), name) != known.end()) return {};
    }
    return is_constant(*callee) ? std::string() : at("calls " + name + "()", call);
  }
  [[nodiscard]] std::string construct(const clang::CXXConstructExpr& made) const {
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

  /// A function of constants, which changes nothing that it is given.
  [[nodiscard]] static bool is_constant(const clang::FunctionDecl& function) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&function);
    if (method != nullptr && method->isInstance() && !method->isConst() &&
        !llvm::isa<clang::CXXConstructorDecl>(method))
      return false;
    return function.isConstexpr() &&
           std::all_of(function.param_begin(), function.param_end(), [](const auto* parameter) {
             const auto type = parameter->getType();
             return !type->isPointerType() &&
                    (!type->isReferenceType() || type.getNonReferenceType().isConstQualified());
           });
  }
  [[nodiscard]] bool is_of_runtime(const clang::Decl& declaration) const {
    return names_.place(declaration.getLocation()).file.starts_with("physgen/");
  }
  [[nodiscard]] std::string at(const std::string& what, const clang::Stmt& where) const {
    return "it " + what + " at " + usage::text_of(names_.place(where.getBeginLoc()));
  }

  const usage::Names& names_;
};

}  // namespace

std::string effects_of(const clang::Expr* expression, const usage::Names& names) {
  return Effects(names).of(expression);
}

}  // namespace physgen::scenes
