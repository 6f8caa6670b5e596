// See constructs.h.
#include "frontend/constructs.h"

#include <clang/AST/Attr.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/Expr.h>

namespace physgen::frontend {

bool is_plain_record(const clang::CXXRecordDecl& record, Report& report) {
  const std::string what = "object " + in_quotes(record.getName());
  for (const auto& base : record.bases())
    report.error(base.getSourceRange(), what + " has a base class; write a field of the base's type instead");
  const auto* aligned = record.getAttr<clang::AlignedAttr>();
  if (aligned != nullptr)
    report.error(aligned->getRange(), "alignas has no effect on generated records; write PHYSGEN_OBJECT(align(...))");
  const auto* packed = record.getAttr<clang::PackedAttr>();
  if (packed != nullptr)
    report.error(packed->getRange(), "generated records have no gaps to pack; remove the attribute");
  return record.getNumBases() == 0 && aligned == nullptr && packed == nullptr;
}

bool is_harmless(const clang::CXXRecordDecl& record, const clang::Decl& member, Report& report) {
  if (member.isImplicit() || llvm::isa<clang::AccessSpecDecl, clang::StaticAssertDecl, clang::EmptyDecl>(member))
    return true;
  if (llvm::isa<clang::IndirectFieldDecl>(member)) return false;  // its anonymous struct is reported
  const std::string within = " in object " + in_quotes(record.getName());
  const auto error = [&](const std::string& what) {
    report.error(member.getLocation(), what);
    return false;
  };
  if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&member); method != nullptr && method->isVirtual())
    return error("virtual function" + within + "; an object is a record of numbers, remove it");
  if (llvm::isa<clang::FunctionDecl, clang::FunctionTemplateDecl>(member))
    return error("member function" + within +
                 "; an object is a record of numbers, write a function beside it that "
                 "takes the generated value");
  if (llvm::isa<clang::VarDecl>(member))
    return error("static member" + within + "; write a constexpr constant beside the object");
  if (const auto* nested = llvm::dyn_cast<clang::CXXRecordDecl>(&member))
    return error((nested->getName().empty() ? "anonymous " + nested->getKindName().str()
                                            : nested->getKindName().str() + " " + in_quotes(nested->getName())) +
                 " is defined" + within + "; write it as an object of its own before this one and nest it by name");
  return error("declaration" + within + " that is not a field; write it beside the object");
}

bool is_plain_field(const clang::FieldDecl& declaration, Report& report) {
  bool good = true;
  const auto refuse = [&](clang::SourceRange range, const std::string& what) {
    report.error(range, "field " + in_quotes(declaration.getName()) + what);
    good = false;
  };
  if (declaration.getAccess() != clang::AS_public) {
    const std::string access = declaration.getAccess() == clang::AS_private ? "private" : "protected";
    refuse(declaration.getLocation(),
           " is " + access + ", but generated code must reach it; write 'struct' and no '" + access + ":'");
  }
  if (const auto* initializer = declaration.getInClassInitializer())
    refuse(initializer->getSourceRange(), " has a C++ initializer; write PHYSGEN(initial(...)) before its type");
  if (const auto* aligned = declaration.getAttr<clang::AlignedAttr>())
    refuse(aligned->getRange(),
           " has an alignment, which is the layout's choice; remove alignas, or write PHYSGEN_OBJECT(align(...)) for "
           "the whole record");
  return good;
}

void report_recursion(const clang::CXXRecordDecl& record, const clang::FieldDecl& declaration, Report& report) {
  const auto* type = declaration.getType()->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();
  if (type == nullptr || type->getCanonicalDecl() != record.getCanonicalDecl()) return;
  report.error(declaration.getLocation(), "object " + in_quotes(record.getName()) + " contains itself in field " +
                                              in_quotes(declaration.getName()) +
                                              "; store an Index of the other object instead");
}

}  // namespace physgen::frontend
