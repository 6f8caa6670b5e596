// Makes options of the model from the arguments of PHYSGEN_OBJECT and PHYSGEN, which Clang has evaluated.
#pragma once

#include <map>

#include "frontend/report.h"
#include "model/issue.h"
#include "model/model.h"

namespace physgen::frontend {

/// Where each option was written, for errors about its value.
using OptionPlaces = std::map<model::Aspect, clang::SourceRange>;

/// Reads the options of PHYSGEN_OBJECT into `object`, and reports what is repeated or belongs to fields.
OptionPlaces read_options(const clang::Decl& declaration, model::Object& object, Report& report);

/// Reads the options of PHYSGEN into `field`, and reports what is repeated or belongs to objects.
OptionPlaces read_options(const clang::Decl& declaration, model::Field& field, Report& report);

/// Where the declaration carries PHYSGEN_OBJECT or PHYSGEN itself, not through a redeclaration; none: it does not.
[[nodiscard]] std::optional<clang::SourceRange> marker(const clang::Decl& declaration, llvm::StringRef annotation);

inline constexpr llvm::StringRef object_annotation = "physgen.object";
inline constexpr llvm::StringRef field_annotation = "physgen.field";

}  // namespace physgen::frontend
