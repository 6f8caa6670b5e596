// See read_kernel.h.
#include "scenes/read_kernel.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclTemplate.h>

#include <algorithm>

#include "scenes/read_body.h"
#include "scenes/read_index.h"
#include "scenes/read_plain.h"
#include "scenes/read_stores.h"

namespace physgen::scenes {
namespace {

using usage::Names;

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

}  // namespace

KernelFacts read_kernel(Names& names, const OtherFunctions& others, const Scene& scene, clang::QualType kernel,
                        const clang::FunctionDecl& step) {
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
  if (facts.obstacle.empty())
    if (const std::string other = not_in_body(*packs, names, others); !other.empty()) facts.obstacle = "it " + other;
  if (others.is_one_text(*record)) facts.stores = Stores(names, scene, context).of(*packs);
  return facts;
}

}  // namespace physgen::scenes
