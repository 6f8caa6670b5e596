// Walks a parsed schema: finds its objects, builds the model, and reports what cannot be an object or a field.
#pragma once

#include "frontend/report.h"
#include "model/model.h"
#include "model/validate.h"

namespace physgen::frontend {

/// Reports everything that is wrong with the schema, also by the rules of model::validate and of an emitter.
/// @param objections an emitter's rules; null: there are none
/// @param clang_errors Clang has reported errors: what may only follow from these is not reported again
/// @param has_vocabulary <physgen/schema.h> was included
/// @return the model; not complete if anything was reported
[[nodiscard]] model::Schema read_schema(clang::ASTContext& context, bool clang_errors, bool has_vocabulary,
                                        model::Rules objections);

}  // namespace physgen::frontend
