// See constants.h.
#include "frontend/constants.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>

#include <stdexcept>

namespace physgen::frontend {

std::optional<std::string> literal(const clang::APValue& pointer) {
  if (!pointer.isLValue() || !pointer.getLValueOffset().isZero()) return std::nullopt;
  const auto* base = pointer.getLValueBase().dyn_cast<const clang::Expr*>();
  if (base == nullptr) return std::nullopt;
  const auto* string = llvm::dyn_cast<clang::StringLiteral>(base->IgnoreParenImpCasts());
  if (string == nullptr || string->getCharByteWidth() != 1) return std::nullopt;
  return string->getString().str();
}

Constant Constant::member(llvm::StringRef name) const {
  for (const auto* field : type->getAsCXXRecordDecl()->fields())
    if (field->getName() == name) return member(field->getFieldIndex());
  throw std::logic_error("a value has no member " + name.str());
}

Constant Constant::member(unsigned number) const {
  return {value.getStructField(number), std::next(type->getAsCXXRecordDecl()->field_begin(), number)->getType()};
}

Constant Constant::element(unsigned number) const {
  const auto* array = type->getAsArrayTypeUnsafe();
  return {number < value.getArrayInitializedElts() ? value.getArrayInitializedElt(number) : value.getArrayFiller(),
          array->getElementType()};
}

std::optional<std::string> Constant::enumerator() const {
  const auto* enumeration = llvm::dyn_cast_or_null<clang::EnumDecl>(type->getAsTagDecl());
  if (enumeration == nullptr || !value.isInt()) return std::nullopt;
  for (const auto* candidate : enumeration->enumerators())
    if (llvm::APSInt::isSameValue(candidate->getInitVal(), value.getInt())) return candidate->getName().str();
  return std::nullopt;
}

}  // namespace physgen::frontend
