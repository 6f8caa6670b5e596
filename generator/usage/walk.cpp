// See walk.h.
#include "usage/walk.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/ExprCXX.h>

#include <algorithm>
#include <map>
#include <set>

#include "usage/calculated.h"
#include "usage/expressions.h"
#include "usage/facts.h"
#include "usage/in_order.h"
#include "usage/kernel_views.h"
#include "usage/unknown.h"

namespace physgen::usage {
using clang::FunctionDecl;

class Walk {
 public:
  Walk(clang::ASTContext& context, const std::vector<std::string>& folders)
      : context_(context), names_(context, folders), unknown_(context, names_) {}

  const Graph& graph(const std::vector<const FunctionDecl*>& functions) {
    for (const auto* probe : names_.probes()) accesses_of(*probe);
    for (const FunctionDecl* function : names_.steps()) {
      graph_.steps.push_back(names_.step(*function));
      graph_.steps.back().function = number(function);
      add_kernel(*function, names_, graph_.steps.back());
    }
    if (const auto programs = names_.variants(); !programs.empty()) graph_.program = number(programs.front());
    follow();
    for (const FunctionDecl* function : functions)
      if (!names_.is_library(function->getLocation())) graph_.entries.push_back(number(function));
    follow();
    for (const auto* run : runs_) part(*run);
    graph_.unknown = unknown_.found([&](const FunctionDecl& function) {
      const int called = number(&function);
      return std::ranges::any_of(graph_.functions, [&](const Function& caller) {
        return caller.of_library &&
               std::ranges::any_of(caller.calls, [&](const Call& call) { return call.to == called; });
      });
    });
    return graph_;
  }

  const Graph& with_variants() {
    for (const FunctionDecl* function : names_.variants()) graph_.variants.push_back(number(function));
    follow();
    facts();
    return graph_;
  }

 private:
  class Body;

  /// All instantiated accesses, those that no known function leads to among them.
  void accesses_of(const clang::ClassTemplateSpecializationDecl& probe) {
    const int field = static_cast<int>(graph_.fields.size());
    const auto access = [&](const FunctionDecl* function) {
      static const std::map<std::string, Access> kinds = {
          {"decode", Access::read}, {"encode", Access::write}, {"address", Access::address}};
      const auto kind = kinds.find(function->getNameAsString());
      if (kind == kinds.end() || !function->isDefined()) return;
      Function& made = graph_.functions[static_cast<std::size_t>(number(function))];
      made.access = kind->second;
      made.field = field;
    };
    graph_.fields.push_back(names_.field(probe));
    for (const clang::Decl* member : probe.decls()) {
      if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member)) access(method);
      if (const auto* pattern = llvm::dyn_cast<clang::FunctionTemplateDecl>(member))
        for (const FunctionDecl* function : pattern->specializations()) access(function);
    }
  }

  int number(const clang::Decl* declaration) {
    const auto [entry, is_new] =
        numbers_.emplace(declaration->getCanonicalDecl(), static_cast<int>(graph_.functions.size()));
    if (!is_new) return entry->second;
    Function& made = graph_.functions.emplace_back();
    declarations_.push_back(declaration);
    const FunctionDecl* definition = nullptr;
    if (const auto* function = llvm::dyn_cast<FunctionDecl>(declaration)) (void)function->isDefined(definition);
    const auto location = (definition != nullptr ? definition : declaration)->getLocation();
    made.place = names_.place(location);
    made.of_library = names_.is_library(location);
    if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(declaration);
        method != nullptr && method->getIdentifier() != nullptr) {
      made.whole_object = (method->getName() == "get" || method->getName() == "put") &&
                          Names::is_object_reference(*method->getParent());
      if (method->getName() == "run" && Names::is_physgen(method->getParent(), "Steps", {"detail"}))
        runs_.push_back(method);
      made.adds = method->getName() == "add" && (Names::is_physgen(method->getParent(), "FieldRef") ||
                                                 Names::is_physgen(method->getParent(), "ElementRef"));
    }
    if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(declaration))
      made.fused = method->getOverloadedOperator() == clang::OO_Call && Names::is_physgen(method->getParent(), "Fused");
    if (const auto* function = llvm::dyn_cast<FunctionDecl>(declaration))
      made.single_object = Names::is_physgen(function, "single_object", {"detail", "probe"});
    queue_.push_back(definition != nullptr ? definition : declaration);
    return entry->second;
  }

  void facts() {
    const std::function<Place(clang::SourceLocation)> place = [&](auto location) { return names_.place(location); };
    for (std::size_t f = 0; f < graph_.functions.size(); ++f) {
      const clang::Decl* code = declarations_[f];
      const FunctionDecl* definition = nullptr;
      if (const auto* function = llvm::dyn_cast<FunctionDecl>(code);
          function != nullptr && function->isDefined(definition))
        code = definition;
      if (graph_.functions[f].of_library || code->getDeclContext()->isDependentContext()) continue;
      graph_.functions[f].facts = facts_of(*code, context_, place);
    }
  }

  /// The kernel that Steps<Kernel, ...>::run calls first.
  void part(const clang::CXXMethodDecl& run) {
    const auto* steps = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(run.getParent());
    const auto kernels = steps->getTemplateArgs()[0].pack_elements();
    const auto* kernel = kernels.front().getAsType()->getAsCXXRecordDecl();
    add_parts(number(&run), *kernel, static_cast<int>(kernels.size()) - 1);
  }
  void add_parts(int function, const clang::CXXRecordDecl& kernel, int behind) {
    for (const Call& call : std::vector(graph_.functions[static_cast<std::size_t>(function)].calls)) {
      const clang::Decl* declared = declarations_[static_cast<std::size_t>(call.to)];
      const auto* called = llvm::dyn_cast<clang::CXXMethodDecl>(declared);
      if (called != nullptr && called->getOverloadedOperator() == clang::OO_Call && called->getParent() == &kernel)
        graph_.parts.push_back(part_of(call.to, kernel, behind, names_));
      const auto* step = llvm::dyn_cast<FunctionDecl>(declared);
      if (step != nullptr && called == nullptr &&
          (Names::is_physgen(step, "run_step", {"detail"}) || Names::is_physgen(step, "run_one_by_one", {"detail"})))
        add_parts(call.to, kernel, behind);
    }
  }

  void follow();

  clang::ASTContext& context_;
  Names names_;
  UnknownUses unknown_;
  Graph graph_;
  std::map<const clang::Decl*, int> numbers_;
  std::vector<const clang::Decl*> queue_, declarations_;  // the latter beside Graph::functions
  std::vector<const clang::CXXMethodDecl*> runs_;         // of steps of fused kernels
};

/// Finds what one body calls, constructs, destroys or takes the address of: arguments before what takes them.
class Walk::Body : public InOrder<Walk::Body> {
 public:
  Body(Walk& walk, int function)
      : walk_(walk), function_(function), is_users_(!walk.graph_.functions[index()].of_library) {}

  [[nodiscard]] static bool shouldVisitImplicitCode() { return true; }
  static bool TraverseUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr* /*expression*/) { return true; }

  bool VisitCallExpr(clang::CallExpr* call) {
    callees_[call->getCallee()->IgnoreParenImpCasts()] = {call, place_of(*call)};
    if (is_users_) add_calculated(*call, walk_.names_, walk_.graph_.functions[index()].calculated);
    return true;
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) {
    variable(*reference->getDecl(), reference->getLocation());
    return function(reference->getDecl(), reference, reference->getLocation());
  }
  bool VisitMemberExpr(clang::MemberExpr* member) {
    variable(*member->getMemberDecl(), member->getMemberLoc());
    if (llvm::isa<clang::FieldDecl>(member->getMemberDecl())) index_of(member->getBase()->getType());
    return function(member->getMemberDecl(), member, member->getMemberLoc());
  }
  bool VisitCXXConstructExpr(clang::CXXConstructExpr* construction) {
    const auto location = construction->getLocation();
    const auto* record = construction->getConstructor()->getParent();
    if (!construction->getConstructor()->isCopyOrMoveConstructor()) index_of(construction->getType());
    leads_to(construction->getConstructor(), location, construction);
    destroys(construction->getType(), location);
    if (record->isPolymorphic()) overriders(*record, location);
    return true;
  }
  bool VisitInitListExpr(clang::InitListExpr* list) {
    index_of(list->getType());
    return true;
  }
  bool VisitCXXInheritedCtorInitExpr(clang::CXXInheritedCtorInitExpr* construction) {
    leads_to(construction->getConstructor(), construction->getLocation(), construction);
    return true;
  }
  bool VisitVarDecl(clang::VarDecl* variable) {
    destroys(variable->getType(), variable->getLocation());
    return true;
  }
  bool VisitCXXBindTemporaryExpr(clang::CXXBindTemporaryExpr* temporary) {
    leads_to(temporary->getTemporary()->getDestructor(), temporary->getBeginLoc());
    return true;
  }
  bool VisitCXXNewExpr(clang::CXXNewExpr* expression) {
    leads_to(expression->getOperatorNew(), expression->getBeginLoc());
    return true;
  }
  bool VisitCXXDeleteExpr(clang::CXXDeleteExpr* expression) {
    leads_to(expression->getOperatorDelete(), expression->getBeginLoc());
    destroys(expression->getDestroyedType(), expression->getBeginLoc());
    return true;
  }

  [[nodiscard]] std::vector<Call>& calls() { return walk_.graph_.functions[index()].calls; }
  void set_order(std::size_t call, int order) { calls()[call].order = order; }

  /// Follows the end of an object's life behind the body of its destructor.
  void members_of(const clang::CXXDestructorDecl& destructor) {
    for (const auto& base : destructor.getParent()->bases()) destroys(base.getType(), destructor.getLocation());
    for (const auto* member : destructor.getParent()->fields()) destroys(member->getType(), destructor.getLocation());
  }

 private:
  using Callee = std::pair<const clang::CallExpr*, clang::SourceLocation>;

  [[nodiscard]] std::size_t index() const { return static_cast<std::size_t>(function_); }
  /// @param call of the declaration; null: it is called elsewhere, if at all
  void leads_to(const clang::Decl* declaration, clang::SourceLocation location, const clang::Stmt* call = nullptr) {
    if (const auto* conversion = llvm::dyn_cast_or_null<clang::CXXConversionDecl>(declaration);
        conversion != nullptr && conversion->getParent()->isLambda()) {
      declaration = conversion->getParent()->getLambdaCallOperator();  // Clang gives the function pointer no body
      call = nullptr;
    }
    if (declaration == nullptr) return;
    const int to = walk_.number(declaration);
    Place place = is_users_ ? walk_.names_.place(location) : Place{};  // places are wanted of the program's files
    if (call != nullptr) at_end_of(call, calls().size());
    // Conditions of a library, such as those of loops over packs, hold for some object.
    calls().push_back({to, std::move(place), call != nullptr && !(is_users_ && is_conditional()), next()});
  }
  /// Whoever looks into one may change it: its type then says no more that it is the kernel's own.
  void index_of(clang::QualType type) {
    if (type.isNull() || !is_users_) return;
    const auto* record = type->getAsCXXRecordDecl();
    for (const char* name : {"Pack", "PartialPack", "Own"})
      if (Names::is_physgen(record, name)) walk_.graph_.functions[index()].makes_index = true;
  }
  /// One that lives as long as the program is made by whoever names it.
  void variable(const clang::ValueDecl& named, clang::SourceLocation location) {
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(&named);
        variable != nullptr && variable->hasGlobalStorage() && variable->getAnyInitializer() != nullptr)
      leads_to(variable, location);
  }
  bool function(const clang::Decl* declaration, const clang::Expr* expression, clang::SourceLocation location) {
    if (!llvm::isa<FunctionDecl>(declaration)) return true;
    const auto known = callees_.find(expression);
    const auto [call, place] = known == callees_.end() ? Callee(nullptr, location) : known->second;
    leads_to(declaration, place, call);
    return true;
  }
  void destroys(clang::QualType type, clang::SourceLocation location) {
    const auto* record = type->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();
    if (record == nullptr || !record->hasDefinition() || record->hasTrivialDestructor()) return;
    leads_to(record->getDestructor(), location);
  }
  /// Who has an object may call any of its virtual functions.
  void overriders(const clang::CXXRecordDecl& record, clang::SourceLocation location) {
    for (const auto* method : record.methods())
      if (method->isVirtual()) leads_to(method, location);
    for (const auto& base : record.bases())
      if (const auto* parent = base.getType()->getAsCXXRecordDecl(); parent != nullptr && parent->hasDefinition())
        overriders(*parent->getDefinition(), location);
  }
  Walk& walk_;
  int function_;
  bool is_users_;
  std::map<const clang::Expr*, Callee> callees_;
};

void Walk::follow() {
  while (!queue_.empty()) {
    const clang::Decl* declaration = queue_.back();
    queue_.pop_back();
    const int function = number(declaration);
    const Access access = graph_.functions[static_cast<std::size_t>(function)].access;
    if (access == Access::read || access == Access::write) continue;
    if (const auto* code = llvm::dyn_cast<FunctionDecl>(declaration); code != nullptr && code->isDependentContext())
      continue;
    if (!graph_.functions[static_cast<std::size_t>(function)].of_library) unknown_.look_through(*declaration);
    Body body(*this, function);
    if (const auto* destructor = llvm::dyn_cast<clang::CXXDestructorDecl>(declaration)) body.members_of(*destructor);
    body.look_through(*declaration);
    std::ranges::stable_sort(body.calls(), {}, &Call::order);
  }
}

GraphReader::GraphReader(clang::ASTContext& context, const std::vector<std::string>& folders)
    : walk_(std::make_unique<Walk>(context, folders)) {}
GraphReader::~GraphReader() = default;
GraphReader::GraphReader(GraphReader&&) noexcept = default;

const Graph& GraphReader::read(const std::vector<const FunctionDecl*>& functions) { return walk_->graph(functions); }
const Graph& GraphReader::read_variants() { return walk_->with_variants(); }

}  // namespace physgen::usage
