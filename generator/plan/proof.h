// Proof that a planned record is sound in every layout, for every number of objects. It looks at the finished offsets
// only, not at how they came about.
//
// An element of `size` bytes at byte B of a record of R bytes lies, for object i in a layout of pitch P, at
// (i / P) P R + B P + (i % P) size: in each tile of P R bytes, the channel takes the bytes from B P up to B P + size P.
// These bounds are affine in P, so what must hold of them for all P >= 1 is decided from two numbers.
#pragma once

#include <string>
#include <vector>

#include "plan/plan.h"

namespace physgen::plan {

/// times_pitch * P + constant, for a pitch P of 1 or more.
struct Affine {
  long long times_pitch = 0;
  long long constant = 0;
};
[[nodiscard]] constexpr Affine operator-(Affine a, Affine b) {
  return {a.times_pitch - b.times_pitch, a.constant - b.constant};
}
/// Whether it is 0 or more for every P >= 1: it is at P = 1, and does not fall.
[[nodiscard]] constexpr bool never_negative(Affine a) { return a.times_pitch >= 0 && a.times_pitch + a.constant >= 0; }
/// Whether it is a multiple of `size` for every P: both its parts are.
[[nodiscard]] constexpr bool always_multiple(Affine a, int size) {
  return a.times_pitch % size == 0 && a.constant % size == 0;
}

/// What is wrong with a record, for either precision, one sentence each: an element that is not aligned to its size,
/// that lies outside its tile, or that shares bytes with another. Empty: there is no such element, in no layout and for
/// no number of objects.
[[nodiscard]] std::vector<std::string> violations(const Record& record);

/// @throws std::logic_error with the first violation: a defect of physgen, and nothing may be generated
void require_sound(const Record& record);

}  // namespace physgen::plan
