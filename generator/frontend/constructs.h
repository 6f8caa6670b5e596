// Refuses constructs that C++ allows in a struct and a schema does not: an object has public fields, and nothing else.
#pragma once

#include "frontend/report.h"

namespace physgen::frontend {

/// Reports base classes, alignas and packed attributes.
/// @return whether the object has none of them
bool is_plain_record(const clang::CXXRecordDecl& record, Report& report);

/// Reports a member that is not a field, if it may not stand in an object.
/// @return whether it may
bool is_harmless(const clang::CXXRecordDecl& record, const clang::Decl& member, Report& report);

/// Reports access other than public, C++ initializers and alignas.
/// @return whether the field has none of them
bool is_plain_field(const clang::FieldDecl& declaration, Report& report);

/// Says what to do about a field of its own object's type: Clang has only said that the type is incomplete.
void report_recursion(const clang::CXXRecordDecl& record, const clang::FieldDecl& declaration, Report& report);

}  // namespace physgen::frontend
