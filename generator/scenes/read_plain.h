// What is sure to be the same before a step as behind it, as far as reading tells: a short list of expressions and
// declarations. What is not on it is unknown, be it harmless or not. Uses Clang's types, as read.h does.
#pragma once

#include <clang/AST/Expr.h>

#include <set>
#include <string>

#include "scenes/scene.h"
#include "usage/names.h"

namespace physgen::scenes {

/// The list: literals; arithmetic; numbers and structs of a program's own variables and parameters that only statements
/// of its text change; view(), const_view() and size() of the scene's arrays; and aggregates of these.
class Plain {
 public:
  Plain(const clang::FunctionDecl& program, const Scene& scene, const usage::Names& names);

  /// @return what of it is not on the list, "'log(2)' at x.h:3:5"; empty: all of it is
  [[nodiscard]] std::string not_in(const clang::Expr* expression) const;
  /// The same of a statement between steps: only a declaration `const auto x = ...;` of such a value is on the list.
  [[nodiscard]] std::string not_in_statement(const clang::Stmt& statement) const;

 private:
  [[nodiscard]] bool is_readable(const clang::VarDecl& variable) const;

  const clang::ASTContext& context_;
  const Scene& scene_;
  const usage::Names& names_;
  std::set<const clang::VarDecl*> escaped_;  // may be changed by what does not name them
};

/// The beginning of its text, and where it stands: "'log(2)' at x.h:3:5"
[[nodiscard]] std::string in_quotes(const clang::Stmt& statement, const clang::ASTContext& context,
                                    const usage::Names& names);

/// Whether a type holds numbers, views of the scene's arrays, and structs of these, and nothing that could lead to
/// other memory, of which nobody sees what kernels do there for which object.
[[nodiscard]] bool holds_values(clang::QualType type, usage::Names& names);

}  // namespace physgen::scenes
