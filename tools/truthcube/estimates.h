// How far results are from those of an ever finer mesh, told from the equilibrium on the next coarser one.
#pragma once

#include <fem/solver/quasistatic.h>

#include <cstddef>
#include <limits>
#include <span>

#include "body_state.h"
#include "output/window.h"

namespace physgen::truthcube {

/// Displacements and reactions of linear tets in uniform cells converge with first order here, because the edges of
/// bonded plates are singular: what halving the cells has changed is about what is still missing.
struct Estimates {
  double reaction = std::numeric_limits<double>::quiet_NaN();   ///< extrapolated force on the upper plate along z [N]
  double error_rms = std::numeric_limits<double>::quiet_NaN();  ///< of displacements [m]
  double error_max = std::numeric_limits<double>::quiet_NaN();  ///< of displacements [m]
};

/// Force on the upper plate along z [N], from the forces on a level's nodes that it holds and what planes push.
/// Negative under compression.
/// @param on_upper the forces on these nodes [N] @param planes the upper one last; none where there is no contact
[[nodiscard]] double plate_reaction(std::span<const fem::Point> on_upper, std::span<const fem::PlaneContact> planes);

/// @param levels finest first, two at least
/// @param coarse_upper the nodes of the next coarser mesh that the upper plate holds
/// @param reaction on the finest mesh [N]
/// @param state all ranks call this with theirs; those that get no numbers estimate nothing
/// @param order of convergence: with p, halving the cells leaves 1/(2^p - 1) of what it has changed
/// @param window bytes
/// @pre state.coarser_contacts()
[[nodiscard]] Estimates make_estimates(std::span<const fem::MeshLevel> levels, std::span<const fem::Index> coarse_upper,
                                       double reaction, BodyState& state, double order = 1,
                                       std::size_t window = window_bytes);

}  // namespace physgen::truthcube
