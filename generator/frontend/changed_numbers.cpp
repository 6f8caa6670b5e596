// See changed_numbers.h.
#include "frontend/changed_numbers.h"

#include <clang/AST/ExprCXX.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <llvm/ADT/SmallString.h>

#include <set>

namespace physgen::frontend {
namespace {

class Visitor : public clang::RecursiveASTVisitor<Visitor> {
 public:
  explicit Visitor(Report& report) : report_(report), context_(report.context()) {}

  bool TraverseCStyleCastExpr(clang::CStyleCastExpr*) { return true; }
  bool TraverseCXXFunctionalCastExpr(clang::CXXFunctionalCastExpr*) { return true; }
  bool TraverseCXXStaticCastExpr(clang::CXXStaticCastExpr*) { return true; }

  bool VisitImplicitCastExpr(clang::ImplicitCastExpr* cast) {
    const clang::Expr* from = cast->getSubExpr();
    const clang::CastKind kind = cast->getCastKind();
    if (kind == clang::CK_IntegralToFloating) divisions(*from);
    if (kind != clang::CK_IntegralToFloating && kind != clang::CK_FloatingToIntegral && kind != clang::CK_IntegralCast)
      return true;  // a condition asks whether a number is 0, and decimals are rounded
    const auto before = value(*from), after = value(*cast);
    if (!before || !after || is_kept(*before, *after)) return true;
    report_.error(from->getSourceRange(),
                  text(*before) + " becomes " + text(*after) + " in the type " +
                      in_quotes(cast->getType().getUnqualifiedType().getAsString(context_.getPrintingPolicy())) +
                      "; write a number that it can hold");
    return true;
  }

  bool VisitDeclRefExpr(clang::DeclRefExpr* name) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(name->getDecl());
    const clang::Expr* init = variable == nullptr ? nullptr : variable->getAnyInitializer();
    if (init != nullptr && seen_.insert(init).second) TraverseStmt(const_cast<clang::Expr*>(init));
    return true;
  }

 private:
  /// Divisions whose result becomes a real number, but for those in calls, casts and named integers.
  void divisions(const clang::Expr& expression) {
    const clang::Expr* plain = expression.IgnoreParenImpCasts();
    if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(plain)) {
      divisions(*choice->getTrueExpr());
      divisions(*choice->getFalseExpr());
    } else if (const auto* unary = llvm::dyn_cast<clang::UnaryOperator>(plain)) {
      divisions(*unary->getSubExpr());
    } else if (const auto* binary = llvm::dyn_cast<clang::BinaryOperator>(plain);
               binary != nullptr && (binary->isAdditiveOp() || binary->isMultiplicativeOp())) {
      divisions(*binary->getLHS());
      divisions(*binary->getRHS());
      if (binary->getOpcode() == clang::BO_Div) division(*binary);
    }
  }

  void division(const clang::BinaryOperator& division) {
    const auto above = value(*division.getLHS()), below = value(*division.getRHS()), result = value(division);
    if (!above || !below || !result || !above->isInt() || !below->isInt()) return;
    if (below->getInt() == 0 || (above->getInt() % below->getInt()) == 0) return;
    report_.error(division.getSourceRange(), "this integer division gives " + text(*result) +
                                                 " and drops the remainder; write " + text(*above) + ".0 / " +
                                                 text(*below) + ", or " + text(*result) + " if that is meant");
  }

  [[nodiscard]] std::optional<clang::APValue> value(const clang::Expr& expression) const {
    clang::Expr::EvalResult result;
    if (expression.isValueDependent() || !expression.getType()->isArithmeticType()) return std::nullopt;
    if (!expression.EvaluateAsRValue(result, context_)) return std::nullopt;
    if (!result.Val.isInt() && !result.Val.isFloat()) return std::nullopt;
    return result.Val;
  }

  /// Whether a conversion from or to an integer keeps the value; rounding of a real number to another precision does.
  static bool is_kept(const clang::APValue& before, const clang::APValue& after) {
    if (before.isInt() && after.isInt()) return llvm::APSInt::isSameValue(before.getInt(), after.getInt());
    if (before.isFloat() && after.isFloat()) return true;
    const llvm::APFloat& real = before.isFloat() ? before.getFloat() : after.getFloat();
    const llvm::APSInt& whole = before.isInt() ? before.getInt() : after.getInt();
    llvm::APSInt exact(whole.getBitWidth(), whole.isUnsigned());
    bool is_exact = false;
    real.convertToInteger(exact, llvm::APFloat::rmTowardZero, &is_exact);
    return is_exact && exact == whole;
  }

  static std::string text(const clang::APValue& value) {
    llvm::SmallString<32> digits;
    if (value.isInt())
      value.getInt().toString(digits, 10);
    else
      value.getFloat().toString(digits);
    return digits.str().str();
  }

  Report& report_;
  clang::ASTContext& context_;
  std::set<const clang::Expr*> seen_;
};

}  // namespace

void report_changed_numbers(const clang::Expr& argument, Report& report) {
  Visitor(report).TraverseStmt(const_cast<clang::Expr*>(&argument));
}

}  // namespace physgen::frontend
