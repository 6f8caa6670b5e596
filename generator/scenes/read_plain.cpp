// See read_plain.h.
#include "scenes/read_plain.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/ExprCXX.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Lex/Lexer.h>

#include <algorithm>

#include "scenes/read_views.h"

namespace physgen::scenes {
namespace {

bool is_number(clang::QualType type) { return type->isArithmeticType() && !type.isVolatileQualified(); }
bool is_plain_struct(clang::QualType type) {
  const auto* record = type->getAsCXXRecordDecl();
  return record != nullptr && record->hasDefinition() && record->isTriviallyCopyable() && !type.isVolatileQualified();
}
bool is_copy(const clang::CXXConstructExpr& made) {
  return made.getConstructor()->isTrivial() && made.getConstructor()->isCopyOrMoveConstructor();
}
/// The variable `a` of `a` and of `a.b`; null: it is none.
const clang::DeclRefExpr* owner(const clang::Expr* expression) {
  expression = expression->IgnoreParenImpCasts();
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(expression);
  if (member != nullptr && !member->isArrow() && llvm::isa<clang::FieldDecl>(member->getMemberDecl()) &&
      !member->getMemberDecl()->getType()->isReferenceType())
    return owner(member->getBase());
  return llvm::dyn_cast<clang::DeclRefExpr>(expression);
}

/// Finds variables that are used for more than to read their values and to assign to them by a statement.
class Escapes : public clang::RecursiveASTVisitor<Escapes> {
 public:
  bool VisitImplicitCastExpr(clang::ImplicitCastExpr* cast) {
    if (cast->getCastKind() == clang::CK_LValueToRValue) harmless_.insert(owner(cast->getSubExpr()));
    return true;
  }
  bool VisitCXXConstructExpr(clang::CXXConstructExpr* made) {
    if (is_copy(*made)) harmless_.insert(owner(made->getArg(0)));
    return true;
  }
  bool VisitCompoundStmt(clang::CompoundStmt* compound) {
    for (const clang::Stmt* statement : compound->body()) assigned(statement);
    return true;
  }
  bool VisitForStmt(clang::ForStmt* loop) {
    assigned(loop->getInc());
    return true;
  }
  bool TraverseInitListExpr(clang::InitListExpr* list) {  // as it is meant, not as it is spelt
    if (auto* meant = list->getSemanticForm(); meant != nullptr) list = meant;
    return std::ranges::all_of(list->inits(), [&](clang::Expr* one) { return TraverseStmt(one); });
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* named) {
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(named->getDecl()); !harmless_.contains(named))
      found.insert(variable);
    return true;
  }

  std::set<const clang::VarDecl*> found;

 private:
  void assigned(const clang::Stmt* statement) {
    const auto* two = llvm::dyn_cast_or_null<clang::BinaryOperator>(statement);
    const auto* one = llvm::dyn_cast_or_null<clang::UnaryOperator>(statement);
    const clang::DeclRefExpr* to = two != nullptr && two->isAssignmentOp()           ? owner(two->getLHS())
                                   : one != nullptr && one->isIncrementDecrementOp() ? owner(one->getSubExpr())
                                                                                     : nullptr;
    if (to != nullptr && !to->refersToEnclosingVariableOrCapture()) harmless_.insert(to);
  }
  std::set<const clang::DeclRefExpr*> harmless_;
};

}  // namespace

std::string in_quotes(const clang::Stmt& statement, const clang::ASTContext& context, const usage::Names& names) {
  const auto& sources = context.getSourceManager();
  const std::string words =
      clang::Lexer::getSourceText(sources.getExpansionRange(statement.getSourceRange()), sources, context.getLangOpts())
          .str();
  const std::size_t end = std::min(words.find('\n'), std::size_t(60));
  return "'" + words.substr(0, end) + (end < words.size() ? "...' at " : "' at ") +
         usage::text_of(names.place(statement.getBeginLoc()));
}

Plain::Plain(const clang::FunctionDecl& program, const Scene& scene, const usage::Names& names)
    : context_(program.getASTContext()), scene_(scene), names_(names) {
  Escapes escapes;
  escapes.TraverseStmt(program.getBody());
  escaped_ = std::move(escapes.found);
}

bool Plain::is_readable(const clang::VarDecl& variable) const {
  const clang::QualType type = variable.getType(), value = type.getNonReferenceType();
  if (!is_number(value) && !is_plain_struct(value)) return false;
  if (variable.isConstexpr()) return !type->isReferenceType();
  if (!variable.hasLocalStorage()) return false;
  if (type->isReferenceType())  // a number's may be an element of an array
    return llvm::isa<clang::ParmVarDecl>(variable) && value.isConstQualified() && is_plain_struct(value);
  return type.isConstQualified() || !escaped_.contains(&variable);
}

std::string Plain::not_in(const clang::Expr* expression) const {
  const auto all_of = [&](const auto& parts) {
    std::string found;
    for (const clang::Stmt* part : parts)
      if (found.empty() && part != nullptr) found = not_in(llvm::cast<clang::Expr>(part));
    return found;
  };
  if (expression->getBeginLoc().isMacroID() || expression->getEndLoc().isMacroID())
    return "the macro " + in_quotes(*expression, context_, names_);
  const bool is_of_numbers = is_number(expression->getType());
  if (llvm::isa<clang::IntegerLiteral, clang::FloatingLiteral, clang::CXXBoolLiteralExpr, clang::ImplicitValueInitExpr>(
          expression))
    return {};
  if (const auto* initial = llvm::dyn_cast<clang::CXXDefaultInitExpr>(expression)) return not_in(initial->getExpr());
  if (llvm::isa<clang::ParenExpr, clang::ConstantExpr, clang::SubstNonTypeTemplateParmExpr,
                clang::MaterializeTemporaryExpr>(expression))
    return all_of(expression->children());
  if (const auto* cast = llvm::dyn_cast<clang::CastExpr>(expression))
    if (is_of_numbers ? is_number(cast->getSubExpr()->getType()) : cast->getCastKind() == clang::CK_NoOp)
      return all_of(cast->children());
  if (const auto* one = llvm::dyn_cast<clang::UnaryOperator>(expression);
      one != nullptr && is_of_numbers && one->isArithmeticOp())
    return all_of(one->children());
  if (const auto* two = llvm::dyn_cast<clang::BinaryOperator>(expression); two != nullptr && is_of_numbers &&
                                                                           is_number(two->getLHS()->getType()) &&
                                                                           !two->isAssignmentOp() && !two->isCommaOp())
    return all_of(two->children());
  if (llvm::isa<clang::ConditionalOperator>(expression) && is_of_numbers) return all_of(expression->children());
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(expression);
      list != nullptr && (is_of_numbers || is_plain_struct(list->getType()) || list->getType()->isArrayType())) {
    if (!list->hasArrayFiller() || llvm::isa<clang::ImplicitValueInitExpr>(list->getArrayFiller()))
      return all_of(list->inits());
  }
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expression);
      made != nullptr && is_copy(*made) && is_plain_struct(made->getType()))
    return not_in(made->getArg(0));
  if (asked_of_array(expression, scene_).second != nullptr) return {};
  if (const auto* named = owner(expression); named != nullptr && expression->isGLValue()) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(named->getDecl());
    if (variable != nullptr && is_readable(*variable)) return {};
  }
  return in_quotes(*expression, context_, names_);
}

std::string Plain::not_in_statement(const clang::Stmt& statement) const {
  const auto* group = llvm::dyn_cast<clang::DeclStmt>(&statement);
  if (group == nullptr) return in_quotes(statement, context_, names_);
  for (const clang::Decl* one : group->decls()) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(one);
    if (variable == nullptr || llvm::isa<clang::DecompositionDecl>(variable) || !variable->hasLocalStorage() ||
        variable->hasAttrs() || variable->getInit() == nullptr ||
        !(is_number(variable->getType()) || is_plain_struct(variable->getType())))
      return "a declaration of something other than a value, " + in_quotes(statement, context_, names_) + ",";
    if (const std::string found = not_in(variable->getInit()); !found.empty())
      return "the declaration of " + variable->getNameAsString() + " by " + found;
  }
  return {};
}

bool holds_values(clang::QualType type, usage::Names& names) {
  while (type->isConstantArrayType()) type = type->castAsArrayTypeUnsafe()->getElementType();
  if (is_number(type) || type->isEnumeralType()) return true;
  if (!is_plain_struct(type) || type->isUnionType()) return false;
  const auto& record = *type->getAsCXXRecordDecl()->getDefinition();
  if (usage::Names::is_physgen(&record, "View")) return !names.arrays(type).empty();
  for (const auto& base : record.bases())
    if (!holds_values(base.getType(), names)) return false;
  for (const auto* member : record.fields())
    if (member->isMutable() || !holds_values(member->getType(), names)) return false;
  return true;
}

}  // namespace physgen::scenes
