// See calculated.h.
#include "usage/calculated.h"

#include <clang/AST/ExprCXX.h>

#include <algorithm>
#include <set>

#include "usage/expressions.h"

namespace physgen::usage {
namespace {

class Number {
 public:
  explicit Number(const Names& names) : names_(names) {}

  // NOLINTNEXTLINE(misc-no-recursion)
  bool is_calculated(const clang::Expr* expression) {
    expression = written(expression);
    if (const auto* cast = llvm::dyn_cast<clang::CastExpr>(expression)) return is_calculated(cast->getSubExpr());
    if (llvm::isa<clang::IntegerLiteral>(expression)) return true;
    if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expression))
      return std::any_of(made->arg_begin(), made->arg_end(), [&](const auto* one) { return is_calculated(one); });
    if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(expression))
      return list->getNumInits() == 1 && is_calculated(list->getInit(0));
    if (const auto* either = llvm::dyn_cast<clang::ConditionalOperator>(expression))
      return is_calculated(either->getTrueExpr()) || is_calculated(either->getFalseExpr());
    if (const auto* both = llvm::dyn_cast<clang::BinaryOperator>(expression))  // code >> 2 is a packed number
      return both->isAdditiveOp() || both->isMultiplicativeOp() || is_calculated(both->getLHS());
    if (const auto* one = llvm::dyn_cast<clang::UnaryOperator>(expression))
      return one->isArithmeticOp() || one->isIncrementDecrementOp();
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expression))
      return llvm::isa<clang::CXXThisExpr>(written(member->getBase())) && member->getType()->isIntegerType();
    if (const auto* named = llvm::dyn_cast<clang::DeclRefExpr>(expression)) return is_calculated(*named->getDecl());
    const auto* call = llvm::dyn_cast<clang::CallExpr>(expression);
    return call != nullptr && is_calculated(*call);
  }

 private:
  // NOLINTNEXTLINE(misc-no-recursion)
  bool is_calculated(const clang::ValueDecl& named) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(&named);
    if (variable == nullptr || variable->getAnyInitializer() == nullptr || !seen_.insert(variable).second) return false;
    return is_calculated(variable->getAnyInitializer());
  }
  // NOLINTNEXTLINE(misc-no-recursion)
  bool is_calculated(const clang::CallExpr& call) {
    const auto any = [&](unsigned count) {
      return std::any_of(call.arg_begin(), call.arg_begin() + count, [&](auto* one) { return is_calculated(one); });
    };
    if (const auto* words = llvm::dyn_cast<clang::CXXOperatorCallExpr>(&call)) {
      switch (words->getOperator()) {
        case clang::OO_Plus:
        case clang::OO_Minus:
        case clang::OO_Star:  // or what a pointer or an iterator leads to
        case clang::OO_Slash:
        case clang::OO_Percent:
          return call.getNumArgs() == 2;
        case clang::OO_GreaterGreater:
        case clang::OO_Amp:
          return any(1);
        default:
          return false;
      }
    }
    // std::min(j + 1, last), select(...), numbers(i): of what the library gives back, what it was given.
    const auto* function = call.getDirectCallee();
    if (Names::is_physgen(function, "object_of_part")) return false;
    return function != nullptr && !llvm::isa<clang::CXXMethodDecl>(function) &&
           names_.is_library(function->getLocation()) && any(call.getNumArgs());
  }

  const Names& names_;
  std::set<const clang::VarDecl*> seen_;
};

}  // namespace

void add_calculated(const clang::CallExpr& call, Names& names, std::set<std::string>& arrays) {
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(call.getDirectCallee());
  if (method == nullptr || method->getOverloadedOperator() != clang::OO_Subscript || call.getNumArgs() != 2) return;
  if (!Names::is_physgen(method->getParent(), "View") || !Number(names).is_calculated(call.getArg(1))) return;
  for (const std::string& array : names.arrays(call.getArg(0)->getType())) arrays.insert(array);
}

}  // namespace physgen::usage
