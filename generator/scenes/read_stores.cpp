// See read_stores.h.
#include "scenes/read_stores.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/ExprCXX.h>
#include <clang/AST/ExprConcepts.h>
#include <clang/AST/StmtCXX.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "scenes/read_index.h"

namespace physgen::scenes {
namespace {

using usage::Names;

/// Whether control may leave a function from within a statement. Jumps keep a kernel from being joined.
bool leaves(const clang::Stmt* statement) {
  if (statement == nullptr || llvm::isa<clang::LambdaExpr>(statement)) return false;
  return llvm::isa<clang::ReturnStmt>(statement) ||
         std::any_of(statement->child_begin(), statement->child_end(), leaves);
}

/// A static constant of a class or of one that it derives from.
int constant(const clang::CXXRecordDecl& record, llvm::StringRef name) {
  for (const clang::Decl* member : record.decls())
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(member);
        variable != nullptr && variable->getDeclName().isIdentifier() && variable->getName() == name)
      if (const auto* value = const_cast<clang::VarDecl*>(variable)->evaluateValue();
          value != nullptr && value->isInt())
        return static_cast<int>(value->getInt().getExtValue());
  for (const auto& base : record.bases())
    if (const auto* parent = base.getType()->getAsCXXRecordDecl(); parent != nullptr && parent->hasDefinition())
      if (const int found = constant(*parent->getDefinition(), name); found > 0) return found;
  return 0;
}

const clang::ClassTemplateSpecializationDecl* specialization(const clang::TemplateArgument& argument) {
  if (argument.getKind() != clang::TemplateArgument::Type) return nullptr;
  return llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(argument.getAsType()->getAsCXXRecordDecl());
}

}  // namespace

const Stores::Fields& Stores::of(const clang::FunctionDecl& function) {
  const auto [entry, is_new] = known_.try_emplace(function.getCanonicalDecl());
  const clang::FunctionDecl* definition = nullptr;
  if (is_new && function.isDefined(definition) && definition->getBody() != nullptr) {
    Fields stored;
    const bool is_outer = std::exchange(is_library_, names_.is_library(definition->getLocation()));
    (void)statement(definition->getBody(), stored);
    is_library_ = is_outer;
    entry->second = std::move(stored);  // references to map entries stay valid
  }
  return entry->second;
}

/// @return whether what follows is certainly run, too
bool Stores::statement(const clang::Stmt* statement, Fields& stored) {
  if (statement == nullptr) return true;
  if (const auto* compound = llvm::dyn_cast<clang::CompoundStmt>(statement))
    return std::all_of(compound->body_begin(), compound->body_end(),
                       [&](const clang::Stmt* inner) { return this->statement(inner, stored); });
  if (const auto* branch = llvm::dyn_cast<clang::IfStmt>(statement)) return branches(*branch, stored);
  if (const auto* attributed = llvm::dyn_cast<clang::AttributedStmt>(statement))
    return this->statement(attributed->getSubStmt(), stored);
  if (const auto* leave = llvm::dyn_cast<clang::ReturnStmt>(statement)) {
    expression(leave->getRetValue(), stored);
    return false;
  }
  if (const auto* declarations = llvm::dyn_cast<clang::DeclStmt>(statement)) {
    for (const clang::Decl* declared : declarations->decls())
      if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(declared)) expression(variable->getInit(), stored);
    return true;
  }
  if (llvm::isa<clang::Expr>(statement)) {
    expression(statement, stored);
    return true;
  }
  return !leaves(statement);  // loops and the like may run their bodies or not
}

bool Stores::branches(const clang::IfStmt& branch, Fields& stored) {
  if (!statement(branch.getInit(), stored)) return false;
  if (branch.isConstexpr() && !is_library_) return false;  // in another precision the other branch may be taken
  if (branch.isConstexpr()) {
    const auto taken = branch.getNondiscardedCase(context_);
    return taken ? statement(*taken, stored) : !leaves(&branch);
  }
  expression(branch.getCond(), stored);
  Fields yes, no;
  const bool after_yes = statement(branch.getThen(), yes), after_no = statement(branch.getElse(), no);
  std::set_intersection(yes.begin(), yes.end(), no.begin(), no.end(), std::inserter(stored, stored.end()));
  return after_yes && after_no;
}

void Stores::expression(const clang::Stmt* expression, Fields& stored) {
  if (expression == nullptr ||
      llvm::isa<clang::LambdaExpr, clang::UnaryExprOrTypeTraitExpr, clang::CXXNoexceptExpr, clang::RequiresExpr>(
          expression))
    return;
  if (const auto* choice = llvm::dyn_cast<clang::AbstractConditionalOperator>(expression))
    return this->expression(choice->getCond(), stored);
  if (const auto* both = llvm::dyn_cast<clang::BinaryOperator>(expression); both != nullptr && both->isLogicalOp())
    return this->expression(both->getLHS(), stored);
  for (const clang::Stmt* child : expression->children()) this->expression(child, stored);
  if (const auto* called = llvm::dyn_cast<clang::CallExpr>(expression)) call(called->getDirectCallee(), stored);
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expression)) call(made->getConstructor(), stored);
}

void Stores::call(const clang::FunctionDecl* callee, Fields& stored) {
  if (callee == nullptr) return;
  if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(callee)) {
    if (method->isVirtual()) return;
    const auto* parent = method->getParent();
    if (Names::is_physgen(parent, "FieldRef") || Names::is_physgen(parent, "ElementRef")) {
      const std::string name = method->getNameAsString();
      if (name == "operator=" || name == "setZero" || name == "setIdentity") assignment(*parent, stored);
      return;
    }
  }
  // Of the program's own functions, another precision may choose others.
  if (!names_.is_library(callee->getLocation()) || context_.getSourceManager().isInSystemHeader(callee->getLocation()))
    return;
  const Fields& inner = of(*callee);
  stored.insert(inner.begin(), inner.end());
}

/// FieldRef<Shape, Format, T, Cursor>, ElementRef<Format, T, Cursor>, and Cursor<Byte, Layout, record, I>
void Stores::assignment(const clang::CXXRecordDecl& reference, Fields& stored) {
  const auto* special = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&reference);
  if (special == nullptr) return;
  const auto& arguments = special->getTemplateArgs();
  const bool is_field = arguments.size() == 4;
  const auto* format = specialization(arguments[is_field ? 1 : 0]);
  const auto* cursor = specialization(arguments[is_field ? 3 : 2]);
  if (!Names::is_physgen(format, "Probe") || cursor == nullptr) return;
  const auto& index = cursor->getTemplateArgs()[cursor->getTemplateArgs().size() - 1];
  if (index.getKind() != clang::TemplateArgument::Type || !is_pack(index.getAsType())) return;
  int elements = 1;
  if (is_field) {
    const auto* shape = arguments[0].getAsType()->getAsCXXRecordDecl();
    const auto* base = specialization(format->getTemplateArgs()[3]);
    const bool is_quaternion = base != nullptr && base->getName() == "Quaternion";
    elements = is_quaternion                                 ? 4
               : shape == nullptr || !shape->hasDefinition() ? 0
                                                             : constant(*shape->getDefinition(), "count");
  }
  const usage::FieldUse use = names_.field(*format).use;
  const Array* array = find(scene_, use.array);
  if (array == nullptr) return;
  for (const Field& field : array->fields)
    if (field.name == use.field && field.elements == elements) stored.insert({use.array, use.field});
}

}  // namespace physgen::scenes
