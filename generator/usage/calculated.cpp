// See calculated.h.
#include "usage/calculated.h"

#include <clang/AST/ExprCXX.h>
#include <clang/AST/RecursiveASTVisitor.h>

#include <algorithm>
#include <map>
#include <set>

#include "usage/expressions.h"

namespace physgen::usage {
namespace {

/// Looks for what changes a variable behind its declaration.
class Changes : public clang::RecursiveASTVisitor<Changes> {
 public:
  explicit Changes(const clang::VarDecl& variable) : variable_(variable) {}
  [[nodiscard]] bool found() const { return found_; }
  [[nodiscard]] static bool shouldVisitTemplateInstantiations() { return true; }

  bool VisitBinaryOperator(clang::BinaryOperator* both) {
    if (both->isAssignmentOp()) note(both->getLHS());
    return true;
  }
  bool VisitUnaryOperator(clang::UnaryOperator* one) {
    if (one->isIncrementDecrementOp() || one->getOpcode() == clang::UO_AddrOf) note(one->getSubExpr());
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call) {  // what takes it by a reference that may write, such as its operator +=
    const clang::FunctionDecl* function = call->getDirectCallee();
    if (function == nullptr) return true;
    const bool is_operator = llvm::isa<clang::CXXOperatorCallExpr>(call) && llvm::isa<clang::CXXMethodDecl>(function);
    if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
        is_operator && !method->isConst() && call->getNumArgs() > 0)
      note(call->getArg(0));
    for (unsigned a = is_operator ? 1 : 0; a < call->getNumArgs(); ++a) {
      const unsigned parameter = is_operator ? a - 1 : a;
      if (parameter >= function->getNumParams()) break;
      const clang::QualType type = function->getParamDecl(parameter)->getType();
      if (type->isLValueReferenceType() && !type.getNonReferenceType().isConstQualified()) note(call->getArg(a));
    }
    return true;
  }

 private:
  void note(const clang::Expr* target) {
    const auto* named = llvm::dyn_cast<clang::DeclRefExpr>(written(target));
    found_ = found_ || (named != nullptr && named->getDecl() == &variable_);
  }
  const clang::VarDecl& variable_;
  bool found_ = false;
};

bool is_changed(const clang::VarDecl& variable) {
  if (variable.getType().isConstQualified() || variable.getType()->isReferenceType()) return false;
  const auto* function = llvm::dyn_cast<clang::FunctionDecl>(variable.getDeclContext());
  if (function == nullptr || !function->hasBody()) return true;
  Changes changes(variable);
  changes.TraverseStmt(function->getBody());
  return changes.found();
}

class Number {
 public:
  explicit Number(const Names& names) : names_(names) {}

  // NOLINTNEXTLINE(misc-no-recursion)
  bool is_calculated(const clang::Expr* expression) {
    constexpr int deepest = 64;  // of what calls itself it is not known what it returns
    if (depth_ == deepest) return true;
    ++depth_;
    const bool result = is_calculated_here(written(expression));
    --depth_;
    return result;
  }

 private:
  // NOLINTNEXTLINE(misc-no-recursion)
  bool is_calculated_here(const clang::Expr* expression) {
    if (const auto* cast = llvm::dyn_cast<clang::CastExpr>(expression)) return is_calculated(cast->getSubExpr());
    if (llvm::isa<clang::IntegerLiteral>(expression)) return true;
    if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expression))
      return std::any_of(made->arg_begin(), made->arg_end(), [&](const auto* one) { return is_calculated(one); });
    if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(expression))
      return list->getNumInits() == 1 && is_calculated(list->getInit(0));
    if (const auto* either = llvm::dyn_cast<clang::ConditionalOperator>(expression))
      return is_calculated(either->getTrueExpr()) || is_calculated(either->getFalseExpr());
    if (const auto* both = llvm::dyn_cast<clang::BinaryOperator>(expression)) {  // code >> 2 is a packed number
      const bool is_window = both->getOpcode() == clang::BO_Sub && is_begin(both->getRHS());
      const bool unpacks = both->getOpcode() == clang::BO_Shr || both->getOpcode() == clang::BO_And;
      return !(is_window || unpacks) || is_calculated(both->getLHS());
    }
    if (const auto* one = llvm::dyn_cast<clang::UnaryOperator>(expression))
      return one->isArithmeticOp() || one->isIncrementDecrementOp();
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expression))
      return llvm::isa<clang::CXXThisExpr>(written(member->getBase())) && member->getType()->isIntegerType();
    if (const auto* named = llvm::dyn_cast<clang::DeclRefExpr>(expression)) return is_calculated(*named->getDecl());
    const auto* call = llvm::dyn_cast<clang::CallExpr>(expression);
    return call != nullptr && is_calculated(*call);
  }
  /// Whether a number is a member that a kernel has, where arrays have a window of objects: `number - chunk.first`.
  static bool is_begin(const clang::Expr* number) {
    const clang::Expr* inner = written(number);
    while (const auto* cast = llvm::dyn_cast<clang::CastExpr>(inner)) inner = written(cast->getSubExpr());
    if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(inner); made != nullptr && made->getNumArgs() == 1)
      return is_begin(made->getArg(0));
    const auto* member = llvm::dyn_cast<clang::MemberExpr>(inner);
    return member != nullptr && llvm::isa<clang::FieldDecl>(member->getMemberDecl()) &&
           member->getType()->isIntegerType();
  }
  // NOLINTNEXTLINE(misc-no-recursion)
  bool is_calculated(const clang::ValueDecl& named) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(&named);
    if (variable == nullptr) return false;
    if (is_changed(*variable)) return true;
    if (const auto given = given_.find(variable); given != given_.end()) return is_calculated(given->second);
    const clang::Expr* initializer = variable->getAnyInitializer();
    return initializer != nullptr && is_calculated(initializer);
  }
  // NOLINTNEXTLINE(misc-no-recursion)
  bool is_calculated(const clang::CallExpr& call) {
    const auto any = [&](unsigned count) {
      return std::any_of(call.arg_begin(), call.arg_begin() + count, [&](auto* one) { return is_calculated(one); });
    };
    if (const auto* words = llvm::dyn_cast<clang::CXXOperatorCallExpr>(&call)) {
      switch (words->getOperator()) {
        case clang::OO_Plus:
        case clang::OO_Star:  // or what a pointer or an iterator leads to
        case clang::OO_Slash:
        case clang::OO_Percent:
        case clang::OO_Caret:
        case clang::OO_Pipe:
        case clang::OO_LessLess:
          return call.getNumArgs() == 2;
        case clang::OO_Minus:
          return call.getNumArgs() == 2 && (any(1) || !is_begin(call.getArg(1)));
        case clang::OO_GreaterGreater:
        case clang::OO_Amp:
          return any(1);
        default:
          return false;
      }
    }
    // std::min(j + 1, last), select(...), numbers(i): of what the library gives back, what it was given.
    const auto* function = call.getDirectCallee();
    if (function == nullptr) return true;
    if (Names::is_physgen(function, "object_of_part")) return false;
    if (names_.is_library(function->getLocation()))
      return !llvm::isa<clang::CXXMethodDecl>(function) && any(call.getNumArgs());
    if (!function->hasBody()) return true;
    for (unsigned a = 0; a < std::min(call.getNumArgs(), function->getNumParams()); ++a)
      given_[function->getDefinition()->getParamDecl(a)] = call.getArg(a);
    return returns_calculated(*function->getBody());
  }
  // NOLINTNEXTLINE(misc-no-recursion)
  bool returns_calculated(const clang::Stmt& statement) {
    if (const auto* end = llvm::dyn_cast<clang::ReturnStmt>(&statement))
      return end->getRetValue() != nullptr && is_calculated(end->getRetValue());
    if (llvm::isa<clang::LambdaExpr>(statement)) return false;
    return std::any_of(statement.child_begin(), statement.child_end(),
                       [&](const clang::Stmt* one) { return one != nullptr && returns_calculated(*one); });
  }

  const Names& names_;
  std::map<const clang::VarDecl*, const clang::Expr*> given_;  // to parameters of functions that it went into
  int depth_ = 0;
};

}  // namespace

void add_calculated(const clang::CallExpr& call, Names& names, std::set<std::string>& arrays) {
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(call.getDirectCallee());
  if (method == nullptr || method->getOverloadedOperator() != clang::OO_Subscript || call.getNumArgs() != 2) return;
  if (!Names::is_physgen(method->getParent(), "View") || !Number(names).is_calculated(call.getArg(1))) return;
  for (const std::string& array : names.arrays(call.getArg(0)->getType())) arrays.insert(array);
}

}  // namespace physgen::usage
