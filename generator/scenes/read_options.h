// Makes an array of the model from the arguments of PHYSGEN_ARRAY, which Clang has evaluated, and the type behind it.
#pragma once

#include <clang/AST/DeclCXX.h>

#include <vector>

#include "frontend/report.h"
#include "scenes/scene.h"

namespace physgen::scenes {

inline constexpr llvm::StringRef scene_annotation = "physgen.scene";
inline constexpr llvm::StringRef array_annotation = "physgen.array";

/// Whether it is Array<Object, Real>, as a scene declares it.
[[nodiscard]] bool is_array(clang::QualType type);

/// Reads object, precision and fields from the array's type.
/// @return whether it could be read; if not, that is reported
[[nodiscard]] bool read_type(const clang::FieldDecl& declaration, Array& array, frontend::Report& report);

/// Reads the options of PHYSGEN_ARRAY, and reports those that are repeated, missing, or name fields that are not there.
/// @pre its type has been read
void read_options(const clang::FieldDecl& declaration, Array& array, frontend::Report& report);

/// Reports sets that names() and follows() say and the scene has not, and sets that follow each other in a circle.
/// @param declarations of the groups' arrays, in order
void check_names(const Scene& scene, const std::vector<const clang::FieldDecl*>& declarations,
                 frontend::Report& report);

/// Line and column of `where`, in the file's own terms.
[[nodiscard]] Location location(const clang::ASTContext& context, clang::SourceLocation where);

}  // namespace physgen::scenes
