// Which fields an instantiated function stores whole, whatever path it takes. Uses Clang's types, as read.h does.
#pragma once

#include <clang/AST/DeclCXX.h>
#include <clang/AST/Stmt.h>

#include <map>
#include <set>
#include <string>
#include <utility>

#include "scenes/scene.h"
#include "usage/names.h"

namespace physgen::scenes {

/// Finds assignments to whole fields at a pack, in the text of a function and in what of the runtime it certainly
/// calls. What stands in a loop, in or behind an `if constexpr`, or behind a return that is not always reached counts
/// as not stored.
class Stores {
 public:
  using Fields = std::set<std::pair<std::string, std::string>>;  ///< array, field

  Stores(usage::Names& names, const Scene& scene, const clang::ASTContext& context)
      : names_(names), scene_(scene), context_(context) {}

  [[nodiscard]] const Fields& of(const clang::FunctionDecl& function);

 private:
  bool statement(const clang::Stmt* statement, Fields& stored);
  bool branches(const clang::IfStmt& branch, Fields& stored);
  void expression(const clang::Stmt* expression, Fields& stored);
  void call(const clang::FunctionDecl* callee, Fields& stored);
  void assignment(const clang::CXXRecordDecl& reference, Fields& stored);

  usage::Names& names_;
  const Scene& scene_;
  const clang::ASTContext& context_;
  std::map<const clang::Decl*, Fields> known_;
  bool is_library_ = false;  // where the function at hand stands
};

}  // namespace physgen::scenes
