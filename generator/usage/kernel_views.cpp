// See kernel_views.h.
#include "usage/kernel_views.h"

#include <clang/AST/DeclTemplate.h>

namespace physgen::usage {
namespace {

/// The class template's arguments; none: it is not physgen::`name`<...>.
const clang::TemplateArgumentList* arguments_of(const clang::CXXRecordDecl& record, llvm::StringRef name) {
  const auto* special = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&record);
  return special != nullptr && Names::is_physgen(special, name) ? &special->getTemplateArgs() : nullptr;
}

/// The kernel that lanes<W>() calls, or the kernel itself.
const clang::CXXRecordDecl& without_lanes(const clang::CXXRecordDecl& kernel) {
  const auto* arguments = arguments_of(kernel, "InLanes");
  const auto* inner = arguments == nullptr ? nullptr : arguments->get(1).getAsType()->getAsCXXRecordDecl();
  return inner == nullptr ? kernel : without_lanes(*inner);
}

class Views {
 public:
  explicit Views(Names& names) : names_(names) {}

  KernelViews of(const clang::CXXRecordDecl& kernel) && {
    members(kernel);
    return std::move(views_);
  }

 private:
  void members(const clang::CXXRecordDecl& record) {
    if (!record.hasDefinition()) return;
    const auto& definition = *record.getDefinition();
    for (const auto& base : definition.bases())
      if (const auto* parent = base.getType()->getAsCXXRecordDecl(); parent != nullptr) member(*parent, base.getType());
    for (const auto* field : definition.fields())
      if (const auto type = field->getType().getNonReferenceType(); type->getAsCXXRecordDecl() != nullptr)
        member(*type->getAsCXXRecordDecl(), type);
  }
  void member(const clang::CXXRecordDecl& record, clang::QualType type) {
    if (const auto* rows = arguments_of(record, "Rows"); rows != nullptr) {
      const std::string ranges = view(rows->get(0).getAsType()), entries = view(rows->get(1).getAsType());
      if (!ranges.empty() && !entries.empty()) views_.rows.emplace_back(ranges, entries);
    } else if (arguments_of(record, "View") != nullptr) {
      view(type);
    } else if (arguments_of(record, "Local") != nullptr) {
      views_.arrays.emplace_back();  // for_each_view() shows it, too
    } else {
      members(record);
    }
  }
  std::string view(clang::QualType type) {
    const auto arrays = names_.arrays(type);
    return views_.arrays.emplace_back(arrays.size() == 1 ? arrays.front() : std::string());
  }

  Names& names_;
  KernelViews views_;
};

/// Of the kernel's members in order: a View is one, as is a local of a fused kernel, Rows are two, structs count with
/// their own members.
KernelViews views_of(const clang::CXXRecordDecl& kernel, Names& names) {
  return Views(names).of(without_lanes(kernel));
}

/// The name of the program's class or class template; empty: it is a lambda, or of the runtime's.
std::string class_name(const clang::CXXRecordDecl& kernel, const Names& names) {
  const auto& own = without_lanes(kernel);
  return own.isLambda() || names.is_library(own.getLocation()) ? std::string() : own.getQualifiedNameAsString();
}

}  // namespace

Part part_of(int call_operator, const clang::CXXRecordDecl& kernel, int behind, Names& names) {
  return {call_operator, names.kernel_name(kernel), behind, class_name(kernel, names), views_of(kernel, names)};
}

void add_kernel(const clang::FunctionDecl& function, Names& names, Step& step) {
  if (function.getName() != "step" && function.getName() != "reduce_step") return;
  const auto* kernel = function.getTemplateSpecializationArgs()->get(0).getAsType()->getAsCXXRecordDecl();
  if (kernel == nullptr) return;
  step.kernel = class_name(*kernel, names);
  step.views = views_of(*kernel, names);
}

}  // namespace physgen::usage
