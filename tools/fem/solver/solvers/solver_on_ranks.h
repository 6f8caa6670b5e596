// The solver on several ranks (runtime/distributed.md): each has a part of the finest mesh and of large coarser ones,
// and all have the others. Equilibria on the CPU have the bits of one process.
#pragma once

#include <fem/solver/quasistatic.h>
#include <physgen/distributed/transport.h>

#include <string>

namespace physgen::fem {

/// What a rank has of the finest mesh.
struct PartOfMesh {
  index_t owned_nodes = 0, ghost_nodes = 0, owned_tets = 0, ghost_tets = 0;
  int neighbours = 0;  ///< ranks that own its ghost nodes
};

/// All ranks call each function, with the same arguments, and get the same values, but for what there is of each node
/// or tet of the whole mesh: the first rank gets that, by blocks of at most 64 MB, and others get none. Of a state that
/// is restored the first rank's positions are taken.
class SolverOnRanks : public EquilibriumSolver {
 public:
  [[nodiscard]] virtual PartOfMesh part() const = 0;
  /// What has crossed so far, seen from this rank.
  [[nodiscard]] virtual Traffic traffic() const = 0;
  /// By what it crosses: "MPI", or on CUDA as DistributedExecutor's transport_name() says.
  [[nodiscard]] virtual std::string transport() const = 0;
  /// What an iteration of the linear solver sends: two solves at the positions as they are are counted, of which one
  /// has an iteration more.
  [[nodiscard]] virtual Traffic traffic_of_iteration() = 0;
};

}  // namespace physgen::fem
