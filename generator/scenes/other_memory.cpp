// See other_memory.h.
#include "scenes/other_memory.h"

#include <clang/AST/DeclTemplate.h>

#include <set>
#include <utility>

namespace physgen::scenes {
namespace {

using usage::Names;

class OtherMemory {
 public:
  explicit OtherMemory(Names& names) : names_(names) {}

  /// @return what it holds; empty: nothing
  std::string find(const clang::CXXRecordDecl& record, bool is_shared = false) {
    if (!record.hasDefinition() || !seen_.insert({record.getCanonicalDecl(), is_shared}).second) return {};
    for (const auto& base : record.getDefinition()->bases())
      if (std::string found = find(base.getType(), is_shared); !found.empty()) return found;
    for (const auto* member : record.getDefinition()->fields())
      if (std::string found = is_shared && member->isMutable()
                                  ? "holds a pointer or a reference to something that may change"
                                  : find(member->getType(), is_shared);
          !found.empty())
        return found + (names_.is_library(member->getLocation())
                            ? ""
                            : " at " + usage::text_of(names_.place(member->getLocation())));
    return {};
  }

  /// @param is_shared by all objects: behind a pointer or a reference, or a variable of the program
  std::string find(clang::QualType type, bool is_shared) {
    type = type.getCanonicalType();
    while (type->isArrayType()) type = type->castAsArrayTypeUnsafe()->getElementType();
    if (type->isMemberPointerType()) return "holds a pointer to a member";
    if (type->isPointerType() || type->isReferenceType())
      return type->getPointeeType().isConstQualified()
                 ? find(type->getPointeeType(), true)
                 : "holds a pointer or a reference to something that is not an array";
    const auto* record = type->getAsCXXRecordDecl();
    if (record == nullptr) return {};
    const auto* view = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
    if (view == nullptr || !Names::is_physgen(record, "View")) return find(*record, is_shared);
    const bool is_read_only = view->getTemplateArgs()[1].getAsType().isConstQualified();
    return is_read_only || !names_.arrays(type).empty() ? "" : "holds a view of an array that the scene has not";
  }

 private:
  Names& names_;
  std::set<std::pair<const clang::Decl*, bool>> seen_;  // and whether it is shared
};

}  // namespace

std::string other_memory_of(const clang::CXXRecordDecl& kernel, usage::Names& names) {
  return OtherMemory(names).find(kernel);
}
std::string other_memory_of(clang::QualType variable, usage::Names& names) {
  return OtherMemory(names).find(variable, true);
}

}  // namespace physgen::scenes
