// The solvers on several ranks (runtime/distributed.md): each has a part of the finest mesh and of large coarser ones,
// and all have the others. Results on the CPU have the bits of one process.
#pragma once

#include <fem/solver/dynamic_solver.h>
#include <fem/solver/quasistatic.h>
#include <physgen/distributed/transport.h>

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
