// The grading of the cube: which a run can have, and what of its errors half as many cells tell.
#pragma once

namespace physgen::truthcube {

/// The largest width of a cell over that of another. The stiffness along a flat cell over that across it is about the
/// square of that; numbers in half, which the preconditioner is stored in, hold 11 bits beside each other, and its
/// iterations grow with that width, too.
inline constexpr double most_flatness = 45;

/// @throw Error for a number that no cube can have as its grading, or cells that would be too flat, with what fits
void check_grading(int cells, double grading);

/// The order with which errors fall as cells are halved: the bonded edges' singularity gives uniform cells the first,
/// and as much more as cells at the faces narrow faster than others; linear tets give no more than the second.
[[nodiscard]] double order_of_errors(double grading);

}  // namespace physgen::truthcube
