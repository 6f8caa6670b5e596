// Kernels are read in one precision and run in others: what these may choose in place of what was read.
#pragma once

#include <clang/AST/DeclCXX.h>

#include <map>
#include <vector>

#include "usage/names.h"

namespace physgen::scenes {

/// Whether a class or a template is of the libraries that kernels calculate with.
[[nodiscard]] bool is_of_libraries(const clang::Decl& declared, const usage::Names& names);

/// Numbers, and classes of the libraries that kernels calculate with, whose own types differ in the precision alone.
[[nodiscard]] bool is_of_precision(clang::QualType type, const usage::Names& names);

/// Functions of the program, friends among them, by their names: what another precision may choose in place of a
/// function, be it the program's or a library's.
class OtherFunctions {
 public:
  OtherFunctions(const clang::DeclContext& all, const usage::Names& names) : names_(names) { collect(all); }

  /// @param call where it is called, or null
  /// @param is_known false, if these may be others than those that are returned, of a template with others of its name,
  ///        or return other classes
  [[nodiscard]] std::vector<const clang::FunctionDecl*> of(const clang::FunctionDecl& function, const clang::Expr* call,
                                                           bool& is_known) const;
  /// Whether a class has the same text in another precision: the program specialises neither it nor a member of it.
  [[nodiscard]] bool is_one_text(const clang::CXXRecordDecl& record) const;
  /// Whether an operator that is the language's here may be one of the program.
  [[nodiscard]] bool has(clang::DeclarationName name) const { return functions_.contains(name); }

 private:
  void collect(const clang::DeclContext& outer);
  /// Whether the program specialises a template, or a member of it.
  template <class Template>
  [[nodiscard]] bool is_specialised(const Template& whole) const;

  const usage::Names& names_;
  std::map<clang::DeclarationName, std::vector<const clang::NamedDecl*>> functions_;
  mutable std::map<const clang::Decl*, bool> specialised_;  // templates that were looked at
};

}  // namespace physgen::scenes
