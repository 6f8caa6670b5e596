// The solvers on several ranks (runtime/distributed.md): each has a part of the finest mesh and of large coarser ones,
// and all have the others. Results on the CPU have the bits of one process.
#pragma once

#include <fem/solver/dynamic_solver.h>
#include <fem/solver/quasistatic.h>
#include <physgen/distributed/transport.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

/// What a rank has of the finest mesh.
struct PartOfMesh {
  index_t owned_nodes = 0, ghost_nodes = 0, owned_tets = 0, ghost_tets = 0;
  int neighbours = 0;  ///< ranks that own its ghost nodes
};

/// What all solvers on several ranks tell. All ranks call each function of these and of the solvers, with the same
/// arguments, and get the same values, but for what there is of each node or tet of the whole mesh: the first rank gets
/// that, by blocks of at most 64 MB, and others get none. Of what they are given of each node, such as a state that is
/// restored, that of the first rank is taken.
class RankReport {
 public:
  virtual ~RankReport() = default;

  [[nodiscard]] virtual PartOfMesh part() const = 0;
  [[nodiscard]] virtual index_t bytes() const = 0;  ///< of this rank, as EquilibriumSolver::bytes()

  /// How many nodes the levels have on which equilibrium is solved, finest first.
  [[nodiscard]] virtual std::vector<Index> nodes_of_levels() const = 0;
  /// What the solver hands out of some nodes or tets, such as those of a window, in the order in which they are named:
  /// positions [m] and forces [N] of nodes of these levels, and stresses [Pa] of tets of the finest mesh. Forces and
  /// stresses are those that were computed last.
  /// @throw Error when there is no such level, node or tet
  [[nodiscard]] virtual std::vector<Point> positions_of(std::size_t level, std::span<const Index> nodes) const = 0;
  [[nodiscard]] virtual std::vector<Point> forces_of(std::size_t level, std::span<const Index> nodes) const = 0;
  [[nodiscard]] virtual std::vector<std::array<double, 9>> stresses_of(std::span<const Index> tets) const = 0;
  /// Computes forces of a level, or stresses, at the positions as they are.
  virtual void compute_forces(std::size_t level) = 0;
  virtual void compute_stresses() = 0;
  /// The contact of planes with the next coarser mesh, where EquilibriumSolver::coarser_equilibrium() has found one.
  [[nodiscard]] virtual std::optional<std::vector<PlaneContact>> coarser_contacts() { return std::nullopt; }

  /// What has crossed so far, seen from this rank.
  [[nodiscard]] virtual Traffic traffic() const = 0;
  /// By what it crosses: "MPI", or on CUDA as DistributedExecutor's transport_name() says.
  [[nodiscard]] virtual std::string transport() const = 0;
  /// What an iteration of the linear solver sends: solves at the positions as they are are counted, of which one has an
  /// iteration more. Of explicit steps, which solve nothing, what a step sends.
  [[nodiscard]] virtual Traffic traffic_of_iteration() = 0;
  /// Names of kernels so far of which the table of the scene has no rows, so that more crosses for them than they read.
  [[nodiscard]] virtual std::vector<std::string> unknown_kernels() const = 0;
};

class SolverOnRanks : public EquilibriumSolver, public RankReport {
 public:
  [[nodiscard]] index_t bytes() const override = 0;
};
class MotionOnRanks : public DynamicSolver, public RankReport {
 public:
  [[nodiscard]] index_t bytes() const override = 0;
};

}  // namespace physgen::fem
