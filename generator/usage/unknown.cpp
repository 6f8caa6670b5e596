// See unknown.h.
#include "usage/unknown.h"

#include <clang/AST/DeclCXX.h>

#include <set>

#include "usage/expressions.h"
#include "usage/running_code.h"

namespace physgen::usage {
namespace {

constexpr const char* name_of_type = "the name of a type";

const clang::Expr* object_of_address(const clang::Expr* expression) {
  const auto* call = llvm::dyn_cast<clang::CallExpr>(expression);
  const auto* method =
      call == nullptr ? nullptr : llvm::dyn_cast_or_null<clang::CXXMethodDecl>(call->getDirectCallee());
  if (method == nullptr || method->getOverloadedOperator() != clang::OO_Amp ||
      !Names::is_physgen(method->getParent(), "ElementRef"))
    return nullptr;
  return object_of(*call);
}

}  // namespace

class UnknownUses::Finder : public RunningCode<Finder> {
 public:
  Finder(UnknownUses& to, const clang::FunctionDecl* function)
      : to_(to), names_(to.names_), context_(to.context_), function_(function) {}

  static bool TraverseUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr* /*expression*/) { return true; }
  bool VisitCXXDefaultInitExpr(clang::CXXDefaultInitExpr* expression) { return TraverseStmt(expression->getExpr()); }
  bool VisitCXXDefaultArgExpr(clang::CXXDefaultArgExpr* expression) {
    const auto outer = used_;
    used_ = expression->getUsedLocation();
    TraverseStmt(expression->getExpr());
    used_ = outer;
    return true;
  }

  bool VisitCallExpr(clang::CallExpr* call) {
    called_.insert(call->getCallee()->IgnoreParenImpCasts());
    const clang::FunctionDecl* callee = call->getDirectCallee();
    if (callee == nullptr) return true;
    if (const auto* object = object_of_address(call); object != nullptr && harmless_.count(call) == 0)
      unknown(object->getType(), address, call->getBeginLoc());
    if (harmless_.count(call) == 0) may_return_an_element(callee, place_of(*call));
    any(*callee, call->getBeginLoc());
    if (const auto* conversion = llvm::dyn_cast<clang::CXXConversionDecl>(callee);
        conversion != nullptr && conversion->getParent()->isLambda())
      may_return_an_element(conversion->getParent()->getLambdaCallOperator(), call->getBeginLoc());
    if (callee->getIdentifier() == nullptr) return true;
    const auto begins_with = [&](const char* text) { return callee->getName().starts_with(text); };
    if ((begins_with("atomic") || begins_with("__ld") || begins_with("__st")) &&  // CUDA's, of one element
        names_.is_library(callee->getLocation()))
      for (const clang::Expr* argument : call->arguments()) harmless_.insert(written(argument));
    return true;
  }
  /// Looks at a function that is not called here, but by whoever gets its address.
  bool VisitDeclRefExpr(clang::DeclRefExpr* named) {
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(named->getDecl());
        function != nullptr && called_.count(named) == 0)
      may_return_an_element(function, named->getLocation());
    return true;
  }
  bool VisitCXXConstructExpr(clang::CXXConstructExpr* made) {
    any(*made->getConstructor(), made->getBeginLoc());
    return true;
  }

  // These find where no more than one element is used: what becomes a value, and what is not used.
  bool VisitReturnStmt(clang::ReturnStmt* statement) {
    if (statement->getRetValue() != nullptr && function_ != nullptr && function_->getReturnType()->isReferenceType())
      only_the_element(statement->getRetValue(), true);
    return true;
  }
  bool VisitCastExpr(clang::CastExpr* cast) {
    const auto kind = cast->getCastKind();
    if (kind == clang::CK_LValueToRValue || kind == clang::CK_ToVoid) only_the_element(cast->getSubExpr());
    return true;
  }
  bool VisitStmtExpr(clang::StmtExpr* expression) {
    valued_ = expression->getSubStmt();
    return true;
  }
  bool VisitCompoundStmt(clang::CompoundStmt* block) {
    for (const clang::Stmt* statement : block->body())
      if (block != valued_ || statement != block->body_back()) not_used(statement);
    return true;
  }
  bool VisitIfStmt(clang::IfStmt* branch) {
    not_used(branch->getThen());
    not_used(branch->getElse());
    return true;
  }
  bool VisitForStmt(clang::ForStmt* loop) {
    not_used(loop->getInit());
    not_used(loop->getInc());
    not_used(loop->getBody());
    return true;
  }
  bool VisitCXXForRangeStmt(clang::CXXForRangeStmt* loop) {
    not_used(loop->getBody());
    return true;
  }
  bool VisitWhileStmt(clang::WhileStmt* loop) {
    not_used(loop->getBody());
    return true;
  }
  bool VisitDoStmt(clang::DoStmt* loop) {
    not_used(loop->getBody());
    return true;
  }
  bool VisitSwitchCase(clang::SwitchCase* one) {
    not_used(one->getSubStmt());
    return true;
  }

  bool VisitPredefinedExpr(clang::PredefinedExpr* text) {
    const llvm::StringRef kind = text->getIdentKindName();
    if (kind != "__func__" && kind != "__FUNCTION__") name(text->getBeginLoc());
    return true;
  }
  bool VisitSourceLocExpr(clang::SourceLocExpr* place) {
    const std::string kind(place->getBuiltinStr());
    if (kind == "__builtin_source_location" || kind == "__builtin_FUNCSIG")
      name(used_.isValid() ? used_ : place->getBeginLoc());
    return true;
  }

 private:
  void unknown(clang::QualType type, const char* what, clang::SourceLocation location) {
    to_.add(type, what, location);
  }
  void unknown(const clang::TemplateArgument& argument, const char* what, clang::SourceLocation location) {
    if (argument.getKind() == clang::TemplateArgument::Type) unknown(argument.getAsType(), what, location);
    if (argument.getKind() == clang::TemplateArgument::Pack)
      for (const auto& element : argument.pack_elements()) unknown(element, what, location);
  }
  /// The name of the function at hand, in which stand those of its arguments and of the classes around it.
  void name(clang::SourceLocation location) {
    const clang::DeclContext* around = function_;
    for (; around != nullptr; around = around->getParent()) {
      if (const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(around))
        unknown(context_.getCanonicalTagType(record), name_of_type, location);
      const auto* function = llvm::dyn_cast<clang::FunctionDecl>(around);
      if (function == nullptr) continue;
      for (const auto* parameter : function->parameters()) unknown(parameter->getType(), name_of_type, location);
      if (function->getTemplateSpecializationArgs() != nullptr)
        for (const auto& argument : function->getTemplateSpecializationArgs()->asArray())
          unknown(argument, name_of_type, location);
    }
  }
  /// The content of a std::any is known by its type alone.
  void any(const clang::FunctionDecl& callee, clang::SourceLocation location) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&callee);
    const clang::NamedDecl& named =
        method == nullptr ? static_cast<const clang::NamedDecl&>(callee) : *method->getParent();
    const bool is_any = named.getIdentifier() != nullptr && named.isInStdNamespace() &&
                        (named.getName() == "any" || named.getName() == "make_any");
    if (!is_any || callee.getTemplateSpecializationArgs() == nullptr) return;
    for (const auto& argument : callee.getTemplateSpecializationArgs()->asArray())
      unknown(argument, "std::any", location);
  }

  void not_used(const clang::Stmt* statement) {
    if (const auto* expression = llvm::dyn_cast_or_null<clang::Expr>(statement)) only_the_element(expression);
  }
  /// @param is_returned by the function at hand, as a reference
  void only_the_element(const clang::Expr* expression, bool is_returned = false) {
    expression = written(expression);
    if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(expression)) {
      only_the_element(choice->getTrueExpr(), is_returned);
      only_the_element(choice->getFalseExpr(), is_returned);
    } else if (const auto* two = llvm::dyn_cast<clang::BinaryOperator>(expression)) {
      if (two->isAssignmentOp()) only_the_element(two->getLHS(), is_returned);
      if (two->isCommaOp()) only_the_element(two->getRHS(), is_returned);
    } else if (const auto* one = llvm::dyn_cast<clang::UnaryOperator>(expression)) {
      if (one->isIncrementDecrementOp()) only_the_element(one->getSubExpr(), is_returned);
      if (one->getOpcode() != clang::UO_Deref) return;
      const clang::Expr* at = written(one->getSubExpr());
      harmless_.insert(at);
      if (const auto* object = object_of_address(at); object != nullptr && is_returned)
        for (const std::string& array : names_.arrays(object->getType()))
          to_.returned_[function_->getCanonicalDecl()].insert(array);
    } else if (const auto* call = llvm::dyn_cast<clang::CallExpr>(expression);
               call != nullptr && call->getDirectCallee() != nullptr && object_of_address(call) == nullptr) {
      harmless_.insert(call);
      if (is_returned)
        to_.calls_.push_back({call->getDirectCallee()->getCanonicalDecl(), function_->getCanonicalDecl(), {}});
    }
  }
  void may_return_an_element(const clang::FunctionDecl* function, clang::SourceLocation location) {
    if (function == nullptr || !function->getReturnType()->isReferenceType()) return;
    if (!names_.is_library(function->getLocation()))
      to_.calls_.push_back({function->getCanonicalDecl(), nullptr, names_.place(location)});
  }

  UnknownUses& to_;
  Names& names_;
  clang::ASTContext& context_;
  const clang::FunctionDecl* function_;             // null: an initializer of a variable
  clang::SourceLocation used_;                      // the call that has the default argument at hand
  const clang::CompoundStmt* valued_ = nullptr;     // the last statement of which is a value
  std::set<const clang::Expr*> harmless_, called_;  // addresses of which one element is used, as in *&x; callees
};

void UnknownUses::look_through(const clang::Decl& code) {
  const auto* function = llvm::dyn_cast<clang::FunctionDecl>(&code);
  Finder(*this, function).look_through(code);
  look_for_memory(code);
}

void UnknownUses::add(clang::QualType type, const char* what, clang::SourceLocation location) {
  for (const std::string& array : names_.arrays(type)) uses_.push_back({array, what, names_.place(location)});
}

std::vector<UnknownUse> UnknownUses::found(
    const std::function<bool(const clang::FunctionDecl&)>& is_called_by_libraries) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const Call& call : calls_) {
      const auto inner = returned_.find(call.callee);
      if (call.returned_by == nullptr || inner == returned_.end()) continue;
      const std::set<std::string> arrays = inner->second;
      auto& outer = returned_[call.returned_by];
      for (const std::string& array : arrays) changed = outer.insert(array).second || changed;
    }
  }
  const auto use = [&](const std::set<std::string>& arrays, const Place& place) {
    for (const std::string& array : arrays) uses_.push_back({array, address, place});
  };
  for (const Call& call : calls_)
    if (const auto found = returned_.find(call.callee); call.returned_by == nullptr && found != returned_.end())
      use(found->second, call.place);
  for (const auto& [function, arrays] : returned_) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
    if ((method != nullptr && method->isVirtual()) || is_called_by_libraries(*function))
      use(arrays, names_.place(function->getLocation()));
  }
  return std::move(uses_);
}

}  // namespace physgen::usage
