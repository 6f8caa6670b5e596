// See listed_code.h.
#include "scenes/listed_code.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/ExprCXX.h>
#include <clang/AST/StmtCXX.h>

#include <set>

#include "usage/names.h"

namespace physgen::scenes {

using usage::Names;

namespace {

/// Casts that change a value and lead to no other memory.
bool is_listed_cast(const clang::CastExpr& cast) {
  switch (cast.getCastKind()) {
    case clang::CK_NoOp:
    case clang::CK_LValueToRValue:
    case clang::CK_IntegralCast:
    case clang::CK_IntegralToBoolean:
    case clang::CK_IntegralToFloating:
    case clang::CK_FloatingToIntegral:
    case clang::CK_FloatingToBoolean:
    case clang::CK_FloatingCast:
    case clang::CK_ArrayToPointerDecay:
    case clang::CK_FunctionToPointerDecay:
    case clang::CK_BuiltinFnToFnPtr:
    case clang::CK_ConstructorConversion:
    case clang::CK_UserDefinedConversion:
    case clang::CK_DerivedToBase:
    case clang::CK_UncheckedDerivedToBase:
    case clang::CK_ToVoid:
      return true;
    default:
      return false;
  }
}

/// What the rest of an array begins with, which is no child of its list: nothing, or zeros.
bool is_listed_filler(const clang::Expr* filler) {
  return filler == nullptr || llvm::isa<clang::ImplicitValueInitExpr>(filler);
}

}  // namespace

bool is_listed(const clang::Stmt& statement) {
  if (const auto* cast = llvm::dyn_cast<clang::CastExpr>(&statement))
    return is_listed_cast(*cast) &&
           llvm::isa<clang::ImplicitCastExpr, clang::CStyleCastExpr, clang::CXXStaticCastExpr,
                     clang::CXXFunctionalCastExpr>(cast) &&
           (!llvm::isa<clang::CStyleCastExpr, clang::CXXFunctionalCastExpr>(cast) || cast->isPRValue()) &&
           (!llvm::isa<clang::ExplicitCastExpr>(cast) || !cast->getType()->isPointerType());
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(&statement))
    return is_listed_filler(list->getArrayFiller());
  if (const auto* list = llvm::dyn_cast<clang::CXXParenListInitExpr>(&statement))
    return is_listed_filler(list->getArrayFiller());
  if (const auto* unary = llvm::dyn_cast<clang::UnaryOperator>(&statement))
    return (unary->getOpcode() != clang::UO_AddrOf && unary->getOpcode() != clang::UO_Deref &&
            !unary->getType()->isPointerType()) ||
           llvm::isa<clang::CXXThisExpr>(unary->getSubExpr()->IgnoreParenImpCasts());
  return llvm::isa<
      clang::CompoundStmt, clang::DeclStmt, clang::NullStmt, clang::IfStmt, clang::ForStmt, clang::WhileStmt,
      clang::DoStmt, clang::BreakStmt, clang::ContinueStmt, clang::ReturnStmt, clang::SwitchStmt, clang::SwitchCase,
      clang::AttributedStmt, clang::IntegerLiteral, clang::FloatingLiteral, clang::CXXBoolLiteralExpr,
      clang::CharacterLiteral, clang::ParenExpr, clang::BinaryOperator, clang::ConditionalOperator, clang::MemberExpr,
      clang::DeclRefExpr, clang::CXXThisExpr, clang::CallExpr, clang::CXXConstructExpr, clang::DesignatedInitExpr,
      clang::CXXInheritedCtorInitExpr, clang::ArraySubscriptExpr, clang::MaterializeTemporaryExpr,
      clang::CXXBindTemporaryExpr, clang::ExprWithCleanups, clang::ConstantExpr, clang::SubstNonTypeTemplateParmExpr,
      clang::CXXDefaultArgExpr, clang::CXXDefaultInitExpr, clang::ImplicitValueInitExpr, clang::CXXScalarValueInitExpr,
      clang::LambdaExpr, clang::UnaryExprOrTypeTraitExpr, clang::TypeTraitExpr>(statement);
}

bool fails(const clang::CallExpr& call) {
  const auto* callee = call.getDirectCallee();
  return callee != nullptr && callee->isExternC() && callee->getName() == "__assert_fail";
}

bool is_listed_in_std(const clang::FunctionDecl& function) {
  static const std::set<llvm::StringRef> names = {
      "abs",  "fabs",  "fma",   "sqrt", "cbrt",     "exp",      "exp2",   "expm1", "log",
      "log2", "log10", "log1p", "pow",  "sin",      "cos",      "tan",    "asin",  "acos",
      "atan", "atan2", "sinh",  "cosh", "tanh",     "hypot",    "fmin",   "fmax",  "floor",
      "ceil", "round", "trunc", "fmod", "copysign", "isfinite", "isnan",  "isinf", "signbit",
      "min",  "max",   "clamp", "move", "forward",  "get",      "invoke", "apply", "as_const"};
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&function);
  if (method == nullptr) return function.getIdentifier() != nullptr && names.contains(function.getName());
  static const std::set<llvm::StringRef> classes = {"array", "pair", "tuple", "numeric_limits", "integral_constant"};
  return method->getParent()->getIdentifier() != nullptr && classes.contains(method->getParent()->getName());
}

bool is_listed_in_runtime(const clang::FunctionDecl& function) {
  static const std::set<llvm::StringRef> headers = {"add.h",
                                                    "cursor.h",
                                                    "element_ref.h",
                                                    "field_ref.h",
                                                    "folds.h",
                                                    "gather.h",
                                                    "in_lanes.h",
                                                    "lanes.h",
                                                    "lanewise.h",
                                                    "math.h",
                                                    "matrix_value.h",
                                                    "object_ref.h",
                                                    "pack.h",
                                                    "quaternion.h",
                                                    "rows.h",
                                                    "shape.h",
                                                    "value_views.h",
                                                    "view.h",
                                                    "row_visit.h",
                                                    "rounding.h",
                                                    "transposed.h",
                                                    "reference_rules.h",
                                                    "value_expressions.h"};
  const auto& sources = function.getASTContext().getSourceManager();
  const llvm::StringRef file = sources.getFilename(sources.getFileLoc(function.getLocation())).rsplit('/').second;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&function);
  const llvm::StringRef name = function.getIdentifier() == nullptr ? llvm::StringRef() : function.getName();
  return (headers.contains(file) || file.starts_with("simd")) && name != "store_where" &&
         (method == nullptr || !Names::is_physgen(method->getParent(), "View") || name.empty() || name == "get" ||
          name == "put");
}

}  // namespace physgen::scenes
