// See read_views.h.
#include "scenes/read_views.h"

#include <clang/AST/ExprCXX.h>
#include <clang/AST/RecursiveASTVisitor.h>

#include <set>
#include <vector>

#include "scenes/local_arrays.h"

namespace physgen::scenes {
namespace {

using usage::Names;

/// The array that is a member of a group of the probing unit.
std::pair<const Group*, const Array*> member(const clang::MemberExpr& member, const Scene& scene) {
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(member.getMemberDecl());
  if (field == nullptr) return {};
  const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(field->getParent()->getDeclContext());
  if (space == nullptr || space->getName() != "physgen_probe_unit") return {};
  for (const Group& group : scene.groups)
    if (field->getParent()->getName() == group.name)
      for (const Array& array : group.arrays)
        if (field->getName() == array.name) return {&group, &array};
  return {};
}

/// Whether the group is a parameter of the program, and no expression that does more than to name it.
bool is_of_parameter(const clang::MemberExpr& member) {
  const auto* group = llvm::dyn_cast<clang::DeclRefExpr>(member.getBase()->IgnoreParens());
  return group != nullptr && llvm::isa<clang::ParmVarDecl>(group->getDecl());
}

std::string method(const clang::Expr& expression) {
  const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(&expression);
  return call == nullptr || call->getMethodDecl() == nullptr ? "" : call->getMethodDecl()->getNameAsString();
}

/// The array of which an expression is a view.
std::pair<const Group*, const Array*> array_of(const clang::Expr& view, const Scene& scene) {
  const auto* call = llvm::cast<clang::CXXMemberCallExpr>(view.IgnoreUnlessSpelledInSource());
  const auto* named = llvm::dyn_cast<clang::MemberExpr>(call->getImplicitObjectArgument()->IgnoreParenImpCasts());
  return named == nullptr ? std::pair<const Group*, const Array*>() : member(*named, scene);
}

/// Visits what names an array or a view of one, and looks at what it stands in.
class Views : public clang::RecursiveASTVisitor<Views> {
 public:
  Views(const Scene& scene, const Names& names) : scene_(scene), names_(names) {}

  bool TraverseStmt(clang::Stmt* statement) {
    path_.push_back(statement);
    const bool goes_on = clang::RecursiveASTVisitor<Views>::TraverseStmt(statement);
    path_.pop_back();
    return goes_on;
  }
  bool VisitVarDecl(clang::VarDecl* variable) {
    if (variable->getInit() != nullptr && is_view(*variable->getInit())) variables_.insert(variable->getInit());
    return true;
  }
  bool VisitMemberExpr(clang::MemberExpr* expression) {
    const auto [group, array] = member(*expression, scene_);
    if (array == nullptr) return true;
    std::size_t at = skip(path_.size());
    if (at > 0 && llvm::isa<clang::MemberExpr>(path_[at - 1])) at = skip(at);  // of its function
    const auto* call = at > 0 ? llvm::dyn_cast<clang::CXXMemberCallExpr>(path_[at - 1]) : nullptr;
    const std::string name = call == nullptr ? "" : method(*call);
    const bool harmless = is_of_parameter(*expression) &&
                          (name == "size" || ((name == "view" || name == "const_view") && is_for_a_kernel(at - 1)));
    if (!harmless) say(*group, *array, *expression);
    return true;
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* named) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(named->getDecl());
    if (variable == nullptr || variable->getInit() == nullptr || !is_view(*variable->getInit())) return true;
    const auto [group, array] = array_of(*variable->getInit(), scene_);
    if (array != nullptr && !is_for_a_kernel(path_.size() - 1)) say(*group, *array, *named);
    return true;
  }

  std::map<std::string, std::string> used;

 private:
  static bool is_view(const clang::Expr& expression) {
    const auto* inner = expression.IgnoreUnlessSpelledInSource();
    return Names::is_physgen(expression.getType()->getAsCXXRecordDecl(), "View") &&
           (method(*inner) == "view" || method(*inner) == "const_view");
  }
  static bool wraps(const clang::Stmt* statement) {
    const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(statement);
    if (made != nullptr) return Names::is_physgen(made->getConstructor()->getParent(), "View");
    return llvm::isa<clang::ImplicitCastExpr, clang::ParenExpr, clang::MaterializeTemporaryExpr,
                     clang::CXXBindTemporaryExpr, clang::ExprWithCleanups, clang::ConstantExpr>(statement);
  }
  /// Below which index of the path stands what is not only wrapped.
  [[nodiscard]] std::size_t skip(std::size_t from) const {
    std::size_t at = from - 1;
    while (at > 0 && wraps(path_[at - 1])) --at;
    return at;
  }
  /// Whether the view at path_[at] is a variable's value, or given to a kernel that is built as the argument of run().
  [[nodiscard]] bool is_for_a_kernel(std::size_t at) const {
    if (const auto* value = llvm::dyn_cast<clang::Expr>(path_[at]))
      for (std::size_t k = at + 1; k-- > 0;)
        if (variables_.count(llvm::dyn_cast<clang::Expr>(path_[k])) != 0) return is_view(*value);
    at = skip(at + 1);
    if (at > 0 && llvm::isa<clang::InitListExpr>(path_[at - 1])) at = skip(at);
    const auto* kernel = at > 0 ? llvm::dyn_cast<clang::Expr>(path_[at - 1]) : nullptr;
    if (kernel == nullptr || !llvm::isa<clang::CXXFunctionalCastExpr, clang::CXXConstructExpr>(kernel)) return false;
    while (at > 0 && !llvm::isa<clang::CXXMemberCallExpr>(path_[at - 1])) --at;
    const auto* run = at > 0 ? llvm::cast<clang::CXXMemberCallExpr>(path_[at - 1]) : nullptr;
    if (run == nullptr || !Names::is_physgen(run->getRecordDecl(), "ProbeExecutor") || method(*run) != "run")
      return false;
    const auto* arguments = run->getMethodDecl()->getTemplateSpecializationArgs();
    return kernel->getType().getCanonicalType() == arguments->get(0).getAsType().getCanonicalType();
  }
  void say(const Group& group, const Array& array, const clang::Expr& where) {
    used.try_emplace(group.full_name(array), " at " + usage::text_of(names_.place(where.getBeginLoc())));
  }

  const Scene& scene_;
  const Names& names_;
  std::vector<const clang::Stmt*> path_;
  std::set<const clang::Expr*> variables_;  // initial values of variables that are views
};

}  // namespace

std::pair<const Group*, const Array*> asked_of_array(const clang::Expr* expression, const Scene& scene) {
  const std::string name = method(*expression);
  if (name != "size" && name != "view" && name != "const_view") return {};
  const auto* object = llvm::cast<clang::CXXMemberCallExpr>(expression)->getImplicitObjectArgument();
  const auto* named = llvm::dyn_cast<clang::MemberExpr>(object->IgnoreParenImpCasts());
  return named != nullptr && is_of_parameter(*named) ? member(*named, scene) : std::pair<const Group*, const Array*>();
}

std::string counted(const clang::Expr* count, const Scene& scene, const clang::ASTContext& context) {
  clang::Expr::EvalResult number;
  if (count->EvaluateAsInt(number, context)) {
    const auto objects = number.Val.getInt().getExtValue();
    return std::to_string(objects) + (objects == 1 ? " object" : " objects");
  }
  count = count->IgnoreParens();
  if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(count);
      cast != nullptr && (cast->getCastKind() == clang::CK_LValueToRValue || cast->getCastKind() == clang::CK_NoOp))
    return counted(cast->getSubExpr(), scene, context);
  if (const auto* named = llvm::dyn_cast<clang::DeclRefExpr>(count))
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(named->getDecl());
        variable != nullptr && variable->hasLocalStorage() && variable->getType().isConstQualified() &&
        variable->getInit() != nullptr)
      return counted(variable->getInit(), scene, context);
  if (const auto [group, array] = asked_of_array(count, scene); array != nullptr && method(*count) == "size")
    return counted(*group, *array);
  return {};
}

std::map<std::string, std::string> views_used(const clang::FunctionDecl& program, const Scene& scene,
                                              const Names& names) {
  Views views(scene, names);
  views.TraverseStmt(program.getBody());
  return std::move(views.used);
}

}  // namespace physgen::scenes
