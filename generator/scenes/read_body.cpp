// See read_body.h.
#include "scenes/read_body.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/ExprCXX.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Lex/Lexer.h>

#include <algorithm>
#include <set>
#include <vector>

#include "scenes/listed_code.h"
#include "scenes/read_index.h"
#include "scenes/read_plain.h"

namespace physgen::scenes {
namespace {

using usage::Names;

/// Visits a function, and those that it calls. Functions of libraries are looked through for those of the program that
/// they call, such as those that std::invoke() is given.
class Body : public clang::RecursiveASTVisitor<Body> {
 public:
  Body(Names& names, const clang::ASTContext& context, const OtherFunctions& others)
      : names_(names), context_(context), others_(others) {}
  [[nodiscard]] static bool shouldVisitImplicitCode() { return true; }

  std::string find(const clang::FunctionDecl& function) {
    queue_.push_back(&function);
    seen_.insert(function.getCanonicalDecl());
    bool is_known = true;
    if (!is_library(function)) {
      asked(function);
      (void)others_.of(function, nullptr, is_known);
    }
    if (!is_known) say("is specialised for some types", function.getLocation());
    while (!queue_.empty() && found_.empty()) {
      const auto* next = queue_.back();
      queue_.pop_back();
      in_library_ = is_library(*next);
      if (!in_library_) own_text(*next);
      if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(next))
        for (const auto* member : constructor->inits()) TraverseStmt(member->getInit());
      TraverseStmt(next->getBody());
    }
    return found_;
  }

  bool TraverseStmt(clang::Stmt* statement) {
    if (statement == nullptr) return true;
    if (const auto* call = llvm::dyn_cast<clang::CallExpr>(statement); call != nullptr && fails(*call)) return true;
    if (!in_library_ && !is_listed(*statement)) say(*statement);
    return found_.empty() && clang::RecursiveASTVisitor<Body>::TraverseStmt(statement);
  }
  /// What it captures is its constructor's; its body is a function of its own.
  bool TraverseLambdaExpr(clang::LambdaExpr* lambda) {
    for (clang::Expr* captured : lambda->capture_inits())
      if (!TraverseStmt(captured)) return false;
    return true;
  }
  static bool TraverseStaticAssertDecl(clang::StaticAssertDecl* /*claim*/) { return true; }
  static bool TraverseTypeLoc(clang::TypeLoc /*type*/, bool /*qualifier*/ = true) { return true; }

  bool VisitExpr(clang::Expr* expression) {
    if (in_library_) return true;
    if (expression->getType().isVolatileQualified()) return say(*expression);
    if (!made_of_known(expression->getType())) return false;
    const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expression);
    if (expression->isPRValue() && is_pack(expression->getType()) && !llvm::isa<clang::CastExpr>(expression) &&
        (made == nullptr || !made->getConstructor()->isCopyOrMoveConstructor()))
      return say("makes an index", expression->getBeginLoc());
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call) {
    const auto* callee = call->getDirectCallee();
    callees_.insert(call->getCallee()->IgnoreParenImpCasts());
    if (callee == nullptr) return in_library_ || say(*call);
    return called(*callee, *call);
  }
  bool VisitCXXConstructExpr(clang::CXXConstructExpr* made) {
    return is_pack(made->getType()) || made->getConstructor()->isTrivial() || called(*made->getConstructor(), *made);
  }
  bool VisitCXXInheritedCtorInitExpr(clang::CXXInheritedCtorInitExpr* made) {
    return called(*made->getConstructor(), *made);
  }
  bool VisitBinaryOperator(clang::BinaryOperator* two) { return built_in(*two); }
  bool VisitUnaryOperator(clang::UnaryOperator* one) { return built_in(*one); }
  bool VisitUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr* size) {
    return in_library_ || !size->isArgumentType() || !size->getArgumentType()->isVariablyModifiedType() || say(*size);
  }
  bool VisitMemberExpr(clang::MemberExpr* member) { return named(*member->getMemberDecl(), *member); }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) { return named(*reference->getDecl(), *reference); }
  bool VisitDeclStmt(clang::DeclStmt* statement) {
    for (const clang::Decl* one : statement->decls()) {
      if (in_library_ || llvm::isa<clang::TypedefNameDecl, clang::StaticAssertDecl, clang::UsingDecl>(one)) continue;
      const auto* variable = llvm::dyn_cast<clang::VarDecl>(one);
      const auto is_harmless = [](const clang::Attr* a) { return llvm::isa<clang::UnusedAttr>(a); };
      if (variable == nullptr || !(variable->hasLocalStorage() || variable->isConstexpr()) ||
          variable->getType()->isPointerType() || variable->getType()->isVariablyModifiedType() ||
          !std::ranges::all_of(variable->attrs(), is_harmless))
        return say(*statement);
    }
    return true;
  }
  bool VisitVarDecl(clang::VarDecl* variable) { return destroyed(variable->getType(), variable->getLocation()); }
  bool VisitCXXBindTemporaryExpr(clang::CXXBindTemporaryExpr* made) {
    return destroyed(made->getType(), made->getBeginLoc());
  }

 private:
  bool say(const std::string& what) {
    if (found_.empty())
      found_ = what + "; have the program compute it before the steps and give the kernel its value, or a field";
    return false;
  }
  bool say(const char* what, clang::SourceLocation place) {
    return say(what + (" at " + usage::text_of(names_.place(place))));
  }
  bool say(const clang::Stmt& what) { return say("holds " + in_quotes(what, context_, names_)); }

  /// The outermost namespace, or null.
  [[nodiscard]] static const clang::NamespaceDecl* space_of(const clang::FunctionDecl& function) {
    const clang::NamespaceDecl* space = nullptr;
    for (const auto* outer = function.getDeclContext(); !outer->isTranslationUnit(); outer = outer->getParent())
      if (const auto* named = llvm::dyn_cast<clang::NamespaceDecl>(outer)) space = named;
    return space;
  }
  /// A function of the compiler's own headers that is one instruction of the processor.
  [[nodiscard]] static bool is_intrinsic(const clang::FunctionDecl& function) {
    return function.getIdentifier() != nullptr && function.getName().starts_with("_mm") &&
           function.hasAttr<clang::AlwaysInlineAttr>();
  }
  /// Generated headers are read as the program is, and so is what is no part of the libraries that kernels use,
  /// wherever it stands.
  [[nodiscard]] bool is_library(const clang::FunctionDecl& function) const {
    static const std::set<llvm::StringRef> spaces = {"std", "Eigen", "xsimd", "physgen", "__gnu_cxx"};
    const auto& sources = context_.getSourceManager();
    const clang::NamespaceDecl* space = space_of(function);
    return names_.is_library(function.getLocation()) &&
           !sources.getFilename(sources.getFileLoc(function.getLocation())).ends_with(".physgen.h") &&
           (space == nullptr ? function.getBuiltinID() != 0 || is_intrinsic(function)
                             : spaces.contains(space->getName()));
  }
  [[nodiscard]] static bool is_listed_library(const clang::FunctionDecl& function) {
    const clang::NamespaceDecl* space = space_of(function);
    if (space != nullptr && space->getName() == "physgen") return is_listed_in_runtime(function);
    if (std::ranges::any_of(function.parameters(), [](const auto* one) { return is_pack(one->getType()); }))
      return false;
    if (space == nullptr) return function.getBuiltinID() != 0 && is_listed_in_std(function);
    return space->isStdNamespace() ? is_listed_in_std(function)
                                   : space->getName() == "Eigen" || space->getName() == "xsimd";
  }
  /// The language's operators of numbers that objects or enumerators are converted to may be the program's of these.
  template <class Operator>
  bool built_in(const Operator& made) {
    const auto is_of_class = [](const clang::Stmt* operand) {
      const auto type = llvm::cast<clang::Expr>(operand)->IgnoreUnlessSpelledInSource()->getType();
      return type->isRecordType() || type->isEnumeralType();
    };
    const auto name = context_.DeclarationNames.getCXXOperatorName(Operator::getOverloadedOperator(made.getOpcode()));
    return in_library_ || !others_.has(name) || std::none_of(made.child_begin(), made.child_end(), is_of_class) ||
           say("has types choose what it calls, " + in_quotes(made, context_, names_));
  }
  bool called(const clang::FunctionDecl& function, const clang::Expr& call) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&function);
    if (!in_library_ && is_library(function) && !is_listed_library(function)) return say(call);
    if (method != nullptr && method->isVirtual() && !is_library(function)) return say(call);
    return follow(function, call);
  }
  bool follow(const clang::FunctionDecl& function, const clang::Expr& from) {
    const clang::FunctionDecl* definition = nullptr;
    if (!function.isDefined(definition) || definition->getBody() == nullptr) {
      const bool is_builtin = function.getBuiltinID() != 0;
      return (is_builtin && (in_library_ || is_listed_in_std(function) || function.hasAttr<clang::ConstAttr>())) ||
             (function.isNoReturn() && in_library_) || function.isImplicit() || function.isDefaulted() ||
             say("calls what is not known, " + in_quotes(from, context_, names_));
    }
    const bool is_new = seen_.insert(definition->getCanonicalDecl()).second;
    if (is_new) queue_.push_back(definition);
    // What else a call may find of a library's function goes by its arguments, so each call is looked at.
    if (!is_new && (in_library_ || !is_library(*definition))) return true;
    if (!is_library(*definition)) asked(*definition);
    bool is_known = true;
    for (const clang::FunctionDecl* one : others_.of(*definition, &from, is_known))
      if (!follow(*one, from)) return false;
    return is_known || say("has types choose what it calls, " + in_quotes(from, context_, names_));
  }
  /// Reads a function's text before it is instantiated, and later what its calls may choose.
  void asked(const clang::FunctionDecl& function) {
    std::vector<Candidate> candidates;
    if (found_.empty()) found_ = asked_of_index(function, names_, candidates);
    for (const auto& [one, callee] : candidates)
      if (!one->isDeleted() && !follow(*one, *callee)) return;
  }
  /// Whether the classes within a class are the same in another precision.
  bool made_of_known(clang::QualType type) {
    const auto* record = (type->isPointerType() ? type->getPointeeType() : type)->getAsCXXRecordDecl();
    if (record == nullptr || names_.is_library(record->getLocation()) ||
        !seen_.insert(record->getCanonicalDecl()).second)
      return true;
    if (!others_.is_one_text(*record)) return say("has types choose what it is made of,", record->getLocation());
    if (found_.empty()) found_ = asked_of_class(*record, names_);
    return found_.empty();
  }
  bool named(const clang::ValueDecl& declared, const clang::Expr& expression) {
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(&declared))
      return callees_.contains(&expression) || (in_library_ ? follow(*function, expression) : say(expression));
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(&declared);
    if (variable == nullptr || !variable->hasGlobalStorage()) return true;
    const bool is_constant =
        (variable->isConstexpr() || variable->getType().isConstQualified()) &&
        (in_library_ || !variable->getType()->isRecordType() || variable->getTemplateInstantiationPattern() == nullptr);
    if (is_constant && (in_library_ || holds_values(variable->getType(), names_))) return true;
    return say("uses the variable " + in_quotes(expression, context_, names_));
  }
  bool destroyed(clang::QualType type, clang::SourceLocation place) {
    if (in_library_ || type->isDependentType()) return true;
    const auto* record = type->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();
    if (record == nullptr || !record->hasDefinition() || record->hasTrivialDestructor()) return true;
    const auto* destructor = record->getDestructor();  // such as Eigen's of what `matrix << 1, 2;` makes
    return (destructor != nullptr && destructor->isUserProvided() && is_library(*destructor) &&
            is_listed_library(*destructor)) ||
           say("runs a destructor", place);
  }
  /// Code behind a directive is seen as it is compiled for the CPU alone.
  bool own_text(const clang::FunctionDecl& function) {
    const auto words = clang::Lexer::getSourceText(clang::CharSourceRange::getTokenRange(function.getSourceRange()),
                                                   context_.getSourceManager(), context_.getLangOpts());
    return (!words.contains('#') && !words.contains("%:")) ||
           say("holds a directive of the preprocessor", function.getLocation());
  }

  Names& names_;
  const clang::ASTContext& context_;
  const OtherFunctions& others_;
  std::vector<const clang::FunctionDecl*> queue_;
  std::set<const clang::Decl*> seen_;
  std::set<const clang::Expr*> callees_;
  bool in_library_ = false;  // where the function at hand stands
  std::string found_;
};

}  // namespace

std::string not_in_body(const clang::FunctionDecl& function, Names& names, const OtherFunctions& others) {
  return Body(names, function.getASTContext(), others).find(function);
}

}  // namespace physgen::scenes
