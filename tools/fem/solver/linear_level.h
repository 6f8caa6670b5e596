// The arrays of one level of the preconditioner, by name.
#pragma once

#include <fem/kernels/symmetric_product.h>
#include <fem/solver/assembled_stiffness.h>
#include <fem/solver/solver_arrays.h>
#include <physgen/format/half.h>

#include <algorithm>

namespace physgen::fem {

/// Above this the coarsest level is not inverted.
inline constexpr index_t most_coarse_nodes = 125;

/// How the preconditioner stores the blocks of edges: as it computes them.
struct StoredAsComputed {
  static constexpr bool rounds = false;
  template <class Space>
  using Edges = physgen::FormatsOf<elasticity::EdgeStiffnessObject, Space>;
};
/// In half. Blocks are scaled to a unit diagonal; what they lose is added to those of nodes (KeepTranslations): without
/// that, nearly incompressible bodies take a tenth more iterations, with it none.
struct StoredInHalf {
  static constexpr bool rounds = true;
  template <class Space>
  struct Edges : elasticity::EdgeStiffnessFormats<Space> {
    using E = format::Half<>;
  };
};

/// @tparam Real of the stiffness
/// @tparam Stored StoredAsComputed or StoredInHalf
template <class Real_, class Space_, class Stored_>
struct LinearLevel {
  using Real = Real_;
  using Space = Space_;
  using Stored = Stored_;

  quasistatic::NodeConstraintArray<Real, Space> constraints;
  elasticity::EdgeArray<Real, Space> edges;
  IncidenceRows<Space> node_edges;
  EdgeSums sums;

  elasticity::NodeStiffnessArray<Real, Space> node_stiffness;
  /// On CUDA as records, since they are gathered: from tiles a block is read from nine places.
  elasticity::EdgeStiffnessArray<Real, Space,
                                 PerSpace<Space, LayoutOf<elasticity::EdgeStiffnessArray<Real, Host>>, Aos>>
      edge_stiffness;

  // The preconditioner, in unknowns scaled to a unit diagonal.
  quasistatic::NodeScaleArray<Real, Space> scales;
  elasticity::NodeStiffnessArray<Real, Space> scaled_nodes;
  elasticity::EdgeStiffnessArray<Real, Space, LayoutOf<elasticity::EdgeStiffnessArray<Real, Space>>,
                                 typename Stored::template Edges<Space>>
      scaled_edges;
  quasistatic::NodeInverseArray<Real, Space> inverse;
  quasistatic::SmootherArray<double, Space> smoother;
  elasticity::NodeForceDifferentialArray<Real, Space> residual;  ///< r
  elasticity::NodeDisplacementArray<Real, Space> correction;     ///< z
  elasticity::NodeDisplacementArray<Real, Space> direction;      ///< d
  elasticity::NodeDisplacementArray<Real, Space> power;          ///< the eigenvector that power iterations approach

  // To the next coarser level; empty on the coarsest.
  quasistatic::NodeParentsArray<Real, Space> parents;
  IncidenceRows<Space> children, edge_terms;
  // Of the coarsest level alone.
  quasistatic::CoarseInverseArray<Real, Space> coarse_inverse;

  LinearLevel(const LevelGraph& graph, const LevelGraph* coarser)
      : constraints(moved_to<decltype(constraints)>(host_constraints(graph))),
        edges(moved_to<decltype(edges)>(host_edges(graph))),
        node_edges(incidence_rows<IncidenceRows<Host>>(graph.node_edges, index_t(graph.edges.size()))),
        sums(as_mesh(graph), Space::kind, sizeof(Real), SumOrder::any),
        node_stiffness(graph.nodes),
        edge_stiffness(index_t(graph.edges.size())),
        scales(graph.nodes),
        scaled_nodes(graph.nodes),
        scaled_edges(index_t(graph.edges.size())),
        inverse(graph.nodes),
        smoother(1),
        residual(graph.nodes),
        correction(graph.nodes),
        direction(graph.nodes),
        power(graph.nodes) {
    if (coarser == nullptr) {
      if (nodes() <= most_coarse_nodes) coarse_inverse = decltype(coarse_inverse)(nodes() * nodes());
      return;
    }
    parents = moved_to<decltype(parents)>(host_parents(graph));
    const auto blocks = std::max(index_t{graph.nodes}, index_t(graph.edges.size()));
    children = IncidenceRows<Space>(incidence_rows<IncidenceRows<Host>>(graph.children, graph.nodes));
    edge_terms = IncidenceRows<Space>(incidence_rows<IncidenceRows<Host>>(graph.edge_terms, blocks));
  }

  [[nodiscard]] index_t nodes() const { return node_stiffness.size(); }
  [[nodiscard]] index_t bytes() const {
    return bytes_of(constraints, edges, node_edges.ranges(), node_edges.entries(), node_stiffness, edge_stiffness,
                    scales, scaled_nodes, scaled_edges, inverse, smoother, residual, correction, direction, power,
                    parents, children.ranges(), children.entries(), edge_terms.ranges(), edge_terms.entries(),
                    coarse_inverse) +
           sums.bytes();
  }
  [[nodiscard]] index_t edge_count() const { return edge_stiffness.size(); }

  /// The stiffness as plain blocks. @pre nothing is under way in it
  [[nodiscard]] AssembledStiffness stiffness() const {
    const auto node_blocks = moved_to<elasticity::NodeStiffnessArray<Real>>(node_stiffness);
    const auto edge_blocks = moved_to<elasticity::EdgeStiffnessArray<Real>>(edge_stiffness);
    const auto ends = moved_to<elasticity::EdgeArray<Real>>(edges);
    AssembledStiffness plain;
    plain.nodes.resize(static_cast<std::size_t>(nodes()));
    plain.edges.resize(static_cast<std::size_t>(edge_count()));
    plain.edge_blocks.resize(plain.edges.size());
    const auto copy_block = [](const Matrix3<Real>& from, AssembledStiffness::Block& to) {
      std::copy_n(from.data(), 9, to.begin());
    };
    for (index_t n = 0; n < nodes(); ++n) copy_block(node_blocks.const_view()[n].K(), plain.nodes[std::size_t(n)]);
    for (index_t e = 0; e < edge_count(); ++e) {
      copy_block(edge_blocks.const_view()[e].E(), plain.edge_blocks[std::size_t(e)]);
      for (int k = 0; k < 2; ++k) plain.edges[std::size_t(e)][std::size_t(k)] = ends.const_view()[e].nodes()[k];
    }
    return plain;
  }

 private:
  static auto host_constraints(const LevelGraph& graph) {
    quasistatic::NodeConstraintArray<Real> array(graph.nodes);
    for (index_t n = 0; n < array.size(); ++n) array.view()[n].fixed() = graph.fixed[std::size_t(n)];
    return array;
  }
  static auto host_edges(const LevelGraph& graph) {
    elasticity::EdgeArray<Real> array(index_t(graph.edges.size()));
    for (index_t e = 0; e < array.size(); ++e) {
      for (int k = 0; k < 2; ++k) array.view()[e].nodes()[k] = graph.edges[std::size_t(e)][std::size_t(k)];
    }
    return array;
  }
  static auto host_parents(const LevelGraph& graph) {
    quasistatic::NodeParentsArray<Real> array(graph.nodes);
    for (index_t n = 0; n < array.size(); ++n) {
      for (int k = 0; k < 2; ++k) array.view()[n].nodes()[k] = graph.parents[std::size_t(n)][std::size_t(k)];
    }
    return array;
  }
  /// As the product wants it.
  static TetMesh as_mesh(const LevelGraph& graph) {
    TetMesh mesh;
    mesh.nodes = graph.nodes;
    mesh.edges = graph.edges;
    mesh.node_edges = graph.node_edges;
    return mesh;
  }
};

}  // namespace physgen::fem
