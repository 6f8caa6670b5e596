// Checks of what solvers are given.
#pragma once

#include <fem/solver/dynamic_solver.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

/// @throw Error when the value is not a positive number. @param what "the density"
void require_positive(const std::string& what, double value);

/// @throw Error when there is no tet, and as require_rest() of each level
void require_meshes(const std::vector<MeshLevel>& levels);
/// @throw Error naming a number out of range, or choices that exclude each other
void require_settings(const SolverSettings& settings);
/// @throw Error naming the node of level `l` whose rest position is not finite, or the tet without positive volume
void require_rest(std::size_t l, const MeshLevel& level);
/// @throw Error where a tangent in single precision would overflow or vanish for that modulus and the level's tets
void require_single_range(const MeshLevel& level, const SolverSettings& settings);
/// @throw Error naming what is wrong with materials and the tets that have them
void require_materials(const std::vector<MeshLevel>& levels, const SolverSettings& settings);
/// Of several materials the largest constants, for what is told from them: how much rounding makes of forces, and the
/// stiffness of planes.
[[nodiscard]] SolverSettings with_largest(SolverSettings settings);
/// @throw Error when there is not a finite vector per node, or a plane is none; when a pressure is not finite, or
/// pushes a face of other nodes
void require_loading(const MeshLevel& level, const Loading& loading);

/// The faces that pressures push, one after the other.
[[nodiscard]] std::vector<Face> pressed_nodes(const std::vector<FollowingPressure>& pressures);
/// @param faces that the loading before pushed @throw Error as EquilibriumSolver::set_loading()
void require_next_loading(const Loading& loading, std::size_t nodes, bool had_planes, const std::vector<Face>& faces);

/// As require_loading(), of solvers that have neither rigid planes, averaged volumes, several materials nor pressures
/// that follow the surface. @param who "linear elasticity"
void require_plain(const char* who, const MeshLevel& level, const Loading& loading);
/// @throw Error as make_linear_solver() does, but for a device or memory that is not there
void require_linear_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                           const SolverSettings& settings);
/// @throw Error naming what is wrong with density or damping
void require_motion(const DynamicSettings& settings);
/// @throw Error when the length [s] of a time step is not a positive number, or the load at its end is not finite
void require_step(double length, double load);
/// @throw Error when there is not one finite vector per node. @param what "the velocity"
void require_vectors(const std::string& what, std::span<const Point> vectors, std::size_t nodes);
/// @param nodes of each level on which equilibrium is solved
/// @throw Error when the state has other levels or nodes, or a load or a position that is not finite
void require_state(const SolverState& state, std::span<const std::size_t> nodes);

/// @throw Error saying that this build has no CUDA
[[noreturn]] void refuse_cuda();

}  // namespace physgen::fem
