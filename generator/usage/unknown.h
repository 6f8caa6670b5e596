// Finds what is done to probed arrays in ways that their types do not show, and so nobody can follow.
#pragma once

#include <clang/AST/ASTContext.h>
#include <clang/AST/Decl.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "usage/names.h"

namespace physgen::usage {

/// Casts of views, their sizes, names, memory and unions, and addresses behind which lie other elements.
class UnknownUses {
 public:
  UnknownUses(clang::ASTContext& context, Names& names) : context_(context), names_(names) {}

  /// @param code a function of the program, whose body and initializers are looked through, or a variable
  void look_through(const clang::Decl& code);

  /// The finds in all of them.
  /// @param is_called_by_libraries of a function
  [[nodiscard]] std::vector<UnknownUse> found(
      const std::function<bool(const clang::FunctionDecl&)>& is_called_by_libraries);

 private:
  class Finder;
  class Memory;

  static constexpr const char* address = "the address of an element, behind which lie others,";

  /// Adds a find for each array in a type.
  void add(clang::QualType type, const char* what, clang::SourceLocation location);
  void look_for_memory(const clang::Decl& code);

  /// A call of a function of the program that may return `*&view[i].m()` as a reference: where that is returned, too,
  /// or where more may be done with it than to use the one element.
  struct Call {
    const clang::FunctionDecl* callee = nullptr;
    const clang::FunctionDecl* returned_by = nullptr;
    Place place;
  };

  clang::ASTContext& context_;
  Names& names_;
  std::vector<UnknownUse> uses_;
  std::map<const clang::FunctionDecl*, std::set<std::string>> returned_;  // arrays of elements that functions return
  std::vector<Call> calls_;
};

}  // namespace physgen::usage
