// Finds the shape, element type and sizes of a field by its C++ type.
#pragma once

#include "frontend/report.h"
#include "model/model.h"

namespace physgen::frontend {

/// Fills shape, element, rows, cols, object and array_extent of `field` from the declaration.
/// @return whether the type is one of a schema; if not, that has been reported
bool read_type(const clang::FieldDecl& declaration, model::Field& field, Report& report);

/// Whether the struct carries PHYSGEN_OBJECT.
[[nodiscard]] bool is_object(const clang::CXXRecordDecl& record);

/// Namespaces around a declaration, "a::b".
[[nodiscard]] std::string scope_of(const clang::Decl& declaration);

}  // namespace physgen::frontend
