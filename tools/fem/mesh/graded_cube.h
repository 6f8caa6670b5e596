// Cells of a cube that are narrower towards all of its faces, where bonded plates make the error.
#pragma once

#include <fem/mesh/mesh.h>

#include <span>

namespace physgen::fem {

/// Positions 0 .. cells of nodes along a side of a cube [m]: side/2 (2 k/cells)^grading up to the middle, and the
/// mirror images of these behind it. The cube of half as many cells has every second of them, to the last bit.
[[nodiscard]] std::vector<double> graded_positions(Index cells, double side, double grading);

/// The width of a cube's widest cell over that of its narrowest.
[[nodiscard]] double graded_flatness(Index cells, double grading);

/// Moves the nodes of make_box_mesh(cells, cells, cells) to their graded positions; with a grading of 1, none.
/// @param rest of each node [m], that of a cube whose corner is the origin
void grade_cube(std::span<Point> rest, Index cells, double side, double grading);

}  // namespace physgen::fem
