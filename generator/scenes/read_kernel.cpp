// See read_kernel.h.
#include "scenes/read_kernel.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Lex/Lexer.h>

#include <algorithm>
#include <set>

#include "scenes/read_index.h"
#include "scenes/read_plain.h"
#include "scenes/read_stores.h"

namespace physgen::scenes {
namespace {

using usage::Names;

/// Finds what keeps a kernel from being a step of a fused kernel: it asks for its index, makes one, does what locals,
/// which are not arrays, do not allow, or uses what cannot be seen. Functions of libraries are looked through for those
/// of the program that they call, such as those that std::invoke() is given.
class Unfit : public clang::RecursiveASTVisitor<Unfit> {
 public:
  explicit Unfit(Names& names) : names_(names) {}
  [[nodiscard]] static bool shouldVisitImplicitCode() { return true; }

  /// @return where it does so, and what; empty: nowhere
  std::string find(const clang::FunctionDecl& function) {
    follow(&function);
    while (!queue_.empty() && found_.empty()) {
      const auto* next = queue_.back();
      queue_.pop_back();
      in_library_ = next->getCanonicalDecl() != function.getCanonicalDecl() && names_.is_library(next->getLocation());
      if (!names_.is_library(next->getLocation())) directives(*next);
      if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(next))
        for (const auto* member : constructor->inits()) TraverseStmt(member->getInit());
      TraverseStmt(next->getBody());
    }
    return found_;
  }

  bool VisitCallExpr(clang::CallExpr* call) {
    const auto* callee = call->getDirectCallee();
    if (callee != nullptr && callee->getIdentifier() != nullptr && callee->getName() == "store_where" &&
        names_.is_library(callee->getLocation()))
      say(call->getBeginLoc(), "stores under a mask");
    if (call->isPRValue() && is_pack(call->getType())) say(call->getBeginLoc(), "makes an index");
    if (callee == nullptr && !call->getCallee()->isInstantiationDependent() &&  // as in a generic lambda's pattern
        !llvm::isa<clang::CXXPseudoDestructorExpr>(call->getCallee()->IgnoreParens()))
      say(call->getBeginLoc(), "calls what is not known");
    if (!in_library_ && callee != nullptr && callee->getBuiltinID() == 0 && !callee->isDefined() &&
        !callee->isNoReturn() && !callee->isImplicit() && !callee->isDefaulted())
      say(call->getBeginLoc(), "calls " + callee->getNameAsString() + "(), which is not known,");
    if (!in_library_ && found_.empty()) found_ = asked_by_call(*call, names_);
    follow(callee);
    return found_.empty();
  }
  bool VisitVarDecl(clang::VarDecl* variable) {
    destroys(variable->getType());
    return found_.empty();
  }
  bool VisitCXXBindTemporaryExpr(clang::CXXBindTemporaryExpr* temporary) {
    destroys(temporary->getType());
    return found_.empty();
  }
  bool VisitExplicitCastExpr(clang::ExplicitCastExpr* cast) {
    const auto of = [](clang::QualType type) { return type->isPointerType() ? type->getPointeeType() : type; };
    const clang::QualType to = cast->getTypeAsWritten(), from = cast->getSubExprAsWritten()->getType();
    if ((to->isPointerType() || to->isReferenceType()) && of(from).isConstQualified() &&
        !to->getPointeeType().isConstQualified())
      say(cast->getBeginLoc(), "casts const away");
    return found_.empty();
  }
  bool VisitAsmStmt(clang::AsmStmt* statement) {
    say(statement->getBeginLoc(), "holds instructions of a processor");
    return found_.empty();
  }
  bool VisitCastExpr(clang::CastExpr* cast) {
    if (cast->getCastKind() == clang::CK_IntegralToPointer) say(cast->getBeginLoc(), "makes a pointer");
    return found_.empty();
  }
  bool VisitCXXMemberCallExpr(clang::CXXMemberCallExpr* call) {
    const auto* method = call->getMethodDecl();
    if (method == nullptr || !Names::is_physgen(method->getParent(), "View")) return true;
    const std::string name = method->getNameAsString();
    if (name != "get" && name != "put") say(call->getBeginLoc(), "asks a view for " + name + "()");
    return found_.empty();
  }
  bool VisitCXXConstructExpr(clang::CXXConstructExpr* made) {
    if (is_pack(made->getType()) && !made->getConstructor()->isCopyOrMoveConstructor())
      say(made->getBeginLoc(), "makes an index");
    follow(made->getConstructor());
    return found_.empty();
  }
  bool VisitInitListExpr(clang::InitListExpr* list) {
    if (!list->getType().isNull() && is_pack(list->getType())) say(list->getBeginLoc(), "makes an index");
    return found_.empty();
  }
  bool VisitMemberExpr(clang::MemberExpr* member) {
    const auto type = member->getBase()->getType();
    if (is_pack(type->isPointerType() ? type->getPointeeType() : type))
      say(member->getMemberLoc(), "looks into its index");
    follow(llvm::dyn_cast<clang::FunctionDecl>(member->getMemberDecl()));
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(member->getMemberDecl()))
      shared(*variable, member->getMemberLoc());
    return found_.empty();
  }
  bool VisitUnaryOperator(clang::UnaryOperator* taken) {
    if (taken->getOpcode() == clang::UO_AddrOf && is_pack(taken->getSubExpr()->getType()))
      say(taken->getBeginLoc(), "looks into its index");
    return found_.empty();
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* named) {
    follow(llvm::dyn_cast<clang::FunctionDecl>(named->getDecl()));
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(named->getDecl());
    if (variable == nullptr || in_library_) return found_.empty();
    shared(*variable, named->getBeginLoc());
    return found_.empty();
  }

 private:
  void say(clang::SourceLocation place, const std::string& what) {
    if (found_.empty() && !in_library_) found_ = what + " at " + usage::text_of(names_.place(place));
  }
  /// Says that the program's function is not known, whoever calls it.
  void unknown(const clang::FunctionDecl& function) {
    in_library_ = false;
    say(function.getLocation(), "calls " + function.getNameAsString() + "(), which is not known,");
  }
  /// A variable that lives as long as the program.
  void shared(const clang::VarDecl& variable, clang::SourceLocation place) {
    if (!variable.hasGlobalStorage() || names_.is_library(variable.getLocation())) return;
    const auto type = variable.getType();
    if (!type.isConstQualified() || !holds_values(type, names_))
      say(place, "uses the variable " + variable.getNameAsString());
  }
  void destroys(clang::QualType type) {
    if (type->isDependentType()) return;
    const auto* record = type->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();
    if (record == nullptr || !record->hasDefinition() || record->hasTrivialDestructor()) return;
    if (!destroyed_.insert(record->getCanonicalDecl()).second) return;
    follow(record->getDestructor());
    for (const auto& base : record->getDefinition()->bases()) destroys(base.getType());
    for (const auto* member : record->getDefinition()->fields()) destroys(member->getType());
  }
  /// Code behind an #if is seen as it is compiled for the CPU alone.
  void directives(const clang::FunctionDecl& function) {
    const auto& context = function.getASTContext();
    const llvm::StringRef text =
        clang::Lexer::getSourceText(clang::CharSourceRange::getTokenRange(function.getSourceRange()),
                                    context.getSourceManager(), context.getLangOpts());
    for (std::size_t at = 0; (at = text.find('\n', at)) != llvm::StringRef::npos; ++at)
      if (llvm::StringRef line = text.substr(at + 1).ltrim(" \t");
          line.consume_front("#") && line.ltrim(" \t").starts_with("if"))
        say(function.getLocation(), "holds a directive of the preprocessor");
  }
  void follow(const clang::FunctionDecl* function) {
    const clang::FunctionDecl* definition = nullptr;
    if (function == nullptr) return;
    const bool is_known = function->isDefined(definition) && definition->getBody() != nullptr;
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
    const bool is_library = names_.is_library(function->getLocation());
    if (!is_library &&
        ((method != nullptr && method->isVirtual()) ||
         (!is_known && !function->isImplicit() && !function->isDefaulted() && function->getBuiltinID() == 0)))
      unknown(*function);
    if (!is_known) return;
    if (!seen_.insert(definition->getCanonicalDecl()).second) return;
    if (found_.empty() && !is_library && sees_arrays(*definition, names_)) found_ = asked_of_index(*definition, names_);
    queue_.push_back(definition);
  }

  Names& names_;
  std::vector<const clang::FunctionDecl*> queue_;
  std::set<const clang::Decl*> seen_, destroyed_;
  bool in_library_ = false;  // where the function at hand stands
  std::string found_;
};

int lanes(const clang::Stmt* statement) {
  if (statement == nullptr) return 0;
  if (const auto* declared = llvm::dyn_cast<clang::DeclStmt>(statement); declared && declared->isSingleDecl())
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(declared->getSingleDecl());
        variable->getName() == "lanes")
      if (const auto* value = const_cast<clang::VarDecl*>(variable)->evaluateValue();
          value != nullptr && value->isInt())
        return static_cast<int>(value->getInt().getExtValue());
  for (const clang::Stmt* child : statement->children())
    if (const int found = lanes(child); found > 0) return found;
  return 0;
}

/// Scalar of a kernel: float or double.
clang::QualType scalar(const clang::CXXRecordDecl& record) {
  for (const clang::Decl* member : record.decls())
    if (const auto* alias = llvm::dyn_cast<clang::TypedefNameDecl>(member); alias && alias->getName() == "Scalar")
      return alias->getUnderlyingType().getCanonicalType();
  for (const auto& base : record.bases())
    if (const auto* parent = base.getType()->getAsCXXRecordDecl(); parent != nullptr && parent->hasDefinition())
      if (const auto found = scalar(*parent->getDefinition()); !found.isNull()) return found;
  return {};
}

/// Whether a kernel has the same text over arrays of another precision.
bool is_one_text(const clang::CXXRecordDecl& record) {
  const auto* special = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&record);
  if (special == nullptr) return true;
  llvm::SmallVector<clang::ClassTemplatePartialSpecializationDecl*, 4> partial;
  special->getSpecializedTemplate()->getPartialSpecializations(partial);
  const auto all = special->getSpecializedTemplate()->specializations();
  return partial.empty() && std::none_of(all.begin(), all.end(), [](const auto* one) {
           return one->getTemplateSpecializationKind() == clang::TSK_ExplicitSpecialization;
         });
}

}  // namespace

KernelFacts read_kernel(Names& names, const Scene& scene, clang::QualType kernel, const clang::FunctionDecl& step) {
  KernelFacts facts;
  const clang::FunctionDecl* definition = nullptr;
  if (step.isDefined(definition)) facts.takes_packs = lanes(definition->getBody()) > 1;
  const auto* record = kernel->getAsCXXRecordDecl();
  if (record == nullptr || !record->hasDefinition() || !facts.takes_packs) return facts;
  record = record->getDefinition();
  const auto& context = record->getASTContext();
  if (const auto type = scalar(*record); !type.isNull())
    facts.scalar_bytes = static_cast<int>(context.getTypeSizeInChars(type).getQuantity());
  const auto found = record->lookup(context.DeclarationNames.getCXXOperatorName(clang::OO_Call));
  const auto* call = found.isSingleResult() ? llvm::dyn_cast<clang::FunctionTemplateDecl>(found.front()) : nullptr;
  const clang::FunctionDecl* packs = nullptr;
  if (call != nullptr)
    for (const auto* function : call->specializations())
      if (function->getNumParams() == 1 &&
          function->getTemplateSpecializationKind() == clang::TSK_ImplicitInstantiation &&
          Names::is_physgen(function->getParamDecl(0)->getType().getNonReferenceType()->getAsCXXRecordDecl(), "Pack"))
        packs = function->getDefinition();
  if (packs == nullptr) {
    facts.obstacle = "it has more call operators than one template over the index";
    return facts;
  }
  if (!holds_values(kernel, names)) facts.obstacle = "it holds more than numbers and views of the scene's arrays";
  for (const auto* member : record->fields())
    if (!holds_values(member->getType(), names))
      facts.obstacle = "its " + member->getNameAsString() +
                       " is neither a number nor a view of the scene's arrays, at " +
                       usage::text_of(names.place(member->getLocation()));
  if (const std::string use = Unfit(names).find(*packs); !use.empty()) facts.obstacle = "it " + use;
  if (is_one_text(*record)) facts.stores = Stores(names, scene, context).of(*packs);
  return facts;
}

}  // namespace physgen::scenes
