// Explicit dynamics of an elastic body on linear tets: the solver as programs use it, whatever it runs on.
#pragma once

#include <fem/solver/dynamic_solver.h>

namespace physgen::fem {

/// Symplectic Euler: v += dt f(x) / m, x += dt v. Change of volume is that of each tet by itself.
/// @throw Error naming what is wrong with settings, level or loading, patches and planes among it; or when the memory
/// cannot be had
[[nodiscard]] std::unique_ptr<DynamicSolver> make_explicit_solver(const MeshLevel& level, const Loading& loading,
                                                                  const DynamicSettings& settings);

/// @throw Error as make_explicit_solver() does, but for a device or memory that is not there
void require_explicit_solver(const MeshLevel& level, const Loading& loading, const DynamicSettings& settings);

/// With which explicit steps of a body at rest are stable [s]: stable_time_step() of its material.
[[nodiscard]] double stable_time_step(const MeshLevel& level, const DynamicSettings& settings);

}  // namespace physgen::fem
