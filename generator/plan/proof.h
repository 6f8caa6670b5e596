// Proof that a planned record is sound in every layout, for every number of objects. It looks at the finished offsets
// only, not at how they came about.
//
// An element of `size` bytes at byte B of a record of R bytes lies, for object i in a layout of pitch P, at
// (i / P) P R + B P + (i % P) size: in each tile of P R bytes, the channel takes the bytes from B P up to B P + size P.
// These bounds are multiples of P, so what holds of them for P = 1 holds for every P.
#pragma once

#include <string>
#include <vector>

#include "plan/plan.h"

namespace physgen::plan {

/// The faults of a record, for either precision, one sentence each: an element that is not aligned to its size,
/// that lies outside its tile, or that shares bytes with another. Empty: there is no such element, in no layout and for
/// no number of objects.
[[nodiscard]] std::vector<std::string> violations(const Record& record);

/// @throws std::logic_error with the first violation: a defect of physgen, and nothing may be generated
void require_sound(const Record& record);

}  // namespace physgen::plan
