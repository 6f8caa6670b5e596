// The arrays of a body in explicit dynamics, by name: in Real what is kept of the tets, in double what the
// nodes' motion adds up in.
#pragma once

#include <dynamics.physgen.h>
#include <fem/kernels/node_sums.h>
#include <fem/solver/loading_arrays.h>
#include <fem/solver/masses.h>
#include <fem/solver/quasistatic.h>
#include <fem/solver/rest_shapes.h>
#include <fem/solver/solver_arrays.h>

#include <type_traits>
#include <vector>

namespace physgen::fem {

/// How the forces of tets on their corners are summed at nodes.
enum class NodeSums {
  gathered,  ///< from corner forces, in the order of the nodes' rows
  added,     ///< by tets, in an order that is open
  placed     ///< from their places in the nodes' rows, in the order of these
};
/// The fastest, or the fastest whose order is fixed.
template <class Space>
[[nodiscard]] constexpr NodeSums node_sums(bool fixed_order) {
  if (std::is_same_v<Space, Host>) return NodeSums::gathered;
  return fixed_order ? NodeSums::placed : NodeSums::added;
}

template <class Real_, class Space_>
struct ExplicitBody {
  using Real = Real_;
  using Space = Space_;

  // Per tet.
  elasticity::TetArray<Real, Space> tets;
  elasticity::RestShapeArray<Real, Space> rest;
  elasticity::CornerForcesArray<Real, Space> corners;  ///< where sums are gathered
  elasticity::TetPlacesArray<Real, Space> places;      ///< where forces are placed
  elasticity::PlacedForceArray<Real, Space> placed;    ///< per corner, there

  // Per node, and its list of tets, where forces are not added.
  elasticity::IncidenceRangeArray<float, Space> node_tet_ranges;
  elasticity::IncidenceArray<float, Space> node_tets;  ///< where they are gathered
  quasistatic::NodeConstraintArray<Real, Space> constraints;
  dynamics::NodeMassArray<double, Space> masses;
  elasticity::NodeForceArray<double, Space> loads;                 ///< external, at a load of 1
  elasticity::NodeDisplacementArray<double, Space> motion;         ///< of prescribed components, at a load of 1
  elasticity::NodeDisplacementArray<double, Space> displacements;  ///< u, from rest
  elasticity::NodeDisplacementArray<Real, Space> rounded;          ///< u as tets read it
  dynamics::NodeVelocityArray<double, Space> velocities;
  elasticity::NodeForceArray<Real, Space> forces;  ///< elastic

  dynamics::MotionArray<double, Space> measured;

  /// At rest. @param masses_of_nodes [kg] @param fixed_order whether sums have the same bits on every run
  ExplicitBody(const MeshLevel& level, const Loading& loading, const std::vector<double>& masses_of_nodes,
               bool fixed_order)
      : ExplicitBody(level, incidence_rows<HostRows>(level.mesh.node_tets, index_t(level.mesh.tets.size())),
                     node_sums<Space>(fixed_order)) {
    store_loading(*this, level, loading.motion, loading.forces);
    dynamics::NodeMassArray<double> host_masses(nodes());
    quasistatic::NodeConstraintArray<Real> host_constraints(nodes());
    for (index_t n = 0; n < nodes(); ++n) {
      host_masses.view()[n].mass() = masses_of_nodes[std::size_t(n)];
      host_constraints.view()[n].fixed() = level.fixed[std::size_t(n)];
    }
    copy(masses, host_masses);
    copy(constraints, host_constraints);
    synchronize();
  }

  [[nodiscard]] index_t nodes() const { return velocities.size(); }
  [[nodiscard]] index_t bytes() const {
    return bytes_of(tets, rest, corners, places, placed, node_tet_ranges, node_tets, constraints, masses, loads, motion,
                    displacements, rounded, velocities, forces, measured);
  }

 private:
  using HostRows = RowArrays<elasticity::IncidenceRangeArray<float>, elasticity::IncidenceArray<float>>;

  ExplicitBody(const MeshLevel& level, const HostRows& rows, NodeSums sums)
      : tets(moved_to<decltype(tets)>(host_tets(level))),
        rest(moved_to<decltype(rest)>(host_rest_shapes(level))),
        corners(sums == NodeSums::gathered ? tets.size() : 0),
        places(moved_to<decltype(places)>(host_places(rows, sums == NodeSums::placed ? tets.size() : 0))),
        placed(4 * places.size()),
        node_tet_ranges(sums == NodeSums::added ? decltype(node_tet_ranges)()
                                                : moved_to<decltype(node_tet_ranges)>(rows.ranges())),
        node_tets(sums == NodeSums::gathered ? moved_to<decltype(node_tets)>(rows.entries()) : decltype(node_tets)()),
        constraints(level.mesh.nodes),
        masses(level.mesh.nodes),
        loads(level.mesh.nodes),
        motion(level.mesh.nodes),
        displacements(level.mesh.nodes),
        rounded(level.mesh.nodes),
        velocities(level.mesh.nodes),
        forces(level.mesh.nodes),
        measured(1) {}

  /// @param tet_count of all tets, or 0
  static auto host_places(const HostRows& rows, index_t tet_count) {
    elasticity::TetPlacesArray<Real> found(tet_count);
    const FindPlaces find{rows.entries().const_view(), found.view()};
    for (index_t entry = 0; entry < 4 * tet_count; ++entry) find(entry);
    return found;
  }
};

}  // namespace physgen::fem
