// Reads values that Clang has evaluated: string literals and members of structs.
#pragma once

#include <clang/AST/APValue.h>
#include <clang/AST/Type.h>
#include <llvm/ADT/StringRef.h>

#include <optional>
#include <string>

namespace physgen::frontend {

/// The text of a string literal that a `const char*` points to; none: it points elsewhere.
[[nodiscard]] std::optional<std::string> literal(const clang::APValue& pointer);

/// A value with its type, which has the names of members.
struct Constant {
  const clang::APValue& value;
  clang::QualType type;

  /// @pre it is a struct with a member of this name, or with more members than this
  [[nodiscard]] Constant member(llvm::StringRef name) const;
  [[nodiscard]] Constant member(unsigned number) const;
  /// @pre it is an array
  [[nodiscard]] Constant element(unsigned number) const;
  /// The name of the enumerator that it is; none: it is no enumeration, or another number, by a cast.
  [[nodiscard]] std::optional<std::string> enumerator() const;
};

}  // namespace physgen::frontend
