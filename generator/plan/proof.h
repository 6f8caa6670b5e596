// Proof that a planned record is sound. It looks at the finished offsets only, not at how they came about.
#pragma once

#include <string>
#include <vector>

#include "plan/plan.h"

namespace physgen::plan {

/// What is wrong with a record, for either precision, one sentence each: an element that is not aligned to its size,
/// that lies outside the record, or that shares bytes with another. Empty: there is no such element.
[[nodiscard]] std::vector<std::string> violations(const Record& record);

}  // namespace physgen::plan
