// Lumped masses of a mesh, and how long a time step of an explicit scheme may be; plain numbers on the host.
#pragma once

#include <fem/materials/material.h>
#include <fem/mesh/mesh.h>

#include <span>
#include <vector>

namespace physgen::fem {

/// A quarter of the mass of each of a node's tets [kg]; 0 of a node in no tet.
/// @param density [kg/m^3]
[[nodiscard]] std::vector<double> lumped_masses(const TetMesh& mesh, std::span<const Point> rest, double density);

/// A time step with which symplectic Euler is stable near rest [s]: the least over all tets of h / c, with c =
/// sqrt((lambda + 2 mu) / density) the speed of pressure waves and 1/h^2 the sum of 1/h_a^2 over the tet's four
/// heights. So h is at most the smallest height and at least half of it.
///
/// That bounds the step 2 / omega of the highest frequency from below, where lambda >= 0: omega^2 is at most the
/// largest u.K u / u.M u of a tet by itself, whose energy is at most (lambda + 2 mu) volume sum 1/h_a^2 |u|^2 / 2 and
/// whose mass at each node is density volume / 4.
/// @throw Error when lambda + 2 mu or the density is not positive
[[nodiscard]] double stable_time_step(const TetMesh& mesh, std::span<const Point> rest, const LameParameters& lame,
                                      double density);

}  // namespace physgen::fem
