// The rules of C++ for a schema, beyond the rules of the model: names that it, the C library, Eigen and the generated
// code leave free, types that do not clash, and code and values of a bearable size.
#pragma once

#include <vector>

#include "model/issue.h"
#include "model/model.h"

namespace physgen::emit::cpp {

/// Bytes of the largest value of one field's entry, with double: what Eigen keeps on the stack,
/// EIGEN_STACK_ALLOCATION_LIMIT.
inline constexpr int max_value_bytes = 128 * 1024;

/// All broken rules, by object in order of declaration (imported ones first). They are found in any model, sound or
/// not.
[[nodiscard]] std::vector<model::Issue> objections(const model::Schema& schema);

}  // namespace physgen::emit::cpp
