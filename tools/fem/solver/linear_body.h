// The arrays of a linear elastic body, by name, and products with its stiffness: ten numbers are kept per tet, its
// shape at rest.
#pragma once

#include <fem/solver/linear_elastic.h>
#include <fem/solver/rest_shapes.h>
#include <fem/solver/scaled_blocks.h>
#include <fem/solver/settings.h>
#include <fem/solver/solver_arrays.h>

namespace physgen::fem {

template <class Real_, class Space_>
struct LinearBody {
  using Real = Real_;
  using Space = Space_;

  LameParameters lame;
  elasticity::TetArray<Real, Space> tets;
  elasticity::RestShapeArray<double, Space> rest;
  PackedRows<Space> node_tets;
  PackedRows<Space> edge_tets;  ///< of stiffness that is assembled

  elasticity::NodeDisplacementArray<double, Space> displacements;  ///< u, from rest
  elasticity::NodeDisplacementArray<double, Space> motion;         ///< of prescribed components, at a load of 1
  elasticity::NodeForceArray<double, Space> loads;                 ///< external, at a load of 1
  elasticity::NodeForceArray<double, Space> forces;  ///< elastic and external; in prescribed components -reaction
  quasistatic::EquilibriumArray<double, Space> state;

  LinearBody(const LameParameters& constants, const MeshLevel& level, const LevelGraph& graph, bool assembled)
      : lame(constants),
        tets(moved_to<decltype(tets)>(host_tets(level))),
        rest(moved_to<decltype(rest)>(host_rest_shapes(level))),
        node_tets(packed_rows<NodeTetEntry>(level.mesh.node_tets, tets.size(), "tets")),
        displacements(graph.nodes),
        motion(graph.nodes),
        loads(graph.nodes),
        forces(graph.nodes),
        state(1) {
    if (!assembled) return;
    edge_tets =
        PackedRows<Space>(packed_rows<EdgeTetEntry>(make_edge_parts(level, graph).edge_tets, tets.size(), "tets"));
  }

  [[nodiscard]] index_t nodes() const { return displacements.size(); }
  [[nodiscard]] index_t bytes() const {
    return bytes_of(tets, rest, node_tets.ranges(), node_tets.entries(), edge_tets.ranges(), edge_tets.entries(),
                    displacements, motion, loads, forces, state);
  }
};

/// df += K dx, without blocks of edges; df is 0 before.
template <class On, class Real, class Space, class DisplacementView, class DifferentialView>
void add_tangents(On& on, LinearBody<Real, Space>& a, const DisplacementView& dx, const DifferentialView& df) {
  on.run(a.nodes(),
         MultiplyLinear{
             linear_force<Real>(a.lame, a.tets.const_view(), a.rest.const_view(), a.node_tets.const_view(), dx), df});
}

/// What prepare() does where nothing is assembled: the inverses of nodes' blocks.
template <class On, class Real, class Space, class Level>
void prepare_nodes(On& on, LinearBody<Real, Space>& a, Level& level, const PreconditionerSettings& settings) {
  if (settings.kind == Preconditioner::none) return;
  const auto blocks = level.node_stiffness.view();
  on.run(a.nodes(), SumLinearNodeStiffness{a.lame, a.rest.const_view(), a.node_tets.const_view(), blocks});
  const auto scales = level.scales.view();
  on.run(a.nodes(), ComputeNodeScale{false, level.node_stiffness.const_view(), scales});
  on.run(a.nodes(), ScaleNodes{level.node_stiffness.const_view(), level.constraints.const_view(),
                               level.scales.const_view(), blocks, level.inverse.view()});
}

}  // namespace physgen::fem
