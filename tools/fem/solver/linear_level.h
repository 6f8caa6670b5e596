// The arrays of one level of the preconditioner, by name.
#pragma once

#include <fem/kernels/edge_slices.h>
#include <fem/kernels/symmetric_product.h>
#include <fem/solver/assembled_stiffness.h>
#include <fem/solver/inertia_arrays.h>
#include <fem/solver/over_groups.h>
#include <fem/solver/plane_arrays.h>
#include <fem/solver/schwarz_arrays.h>
#include <fem/solver/solver_arrays.h>
#include <physgen/format/half.h>

#include <algorithm>
#include <memory>

namespace physgen::fem {

/// How preconditioners store the blocks of edges, and the factors of Schwarz blocks: as they compute them.
struct StoredAsComputed {
  static constexpr bool rounds = false;
  template <class Space>
  using Edges = physgen::FormatsOf<elasticity::EdgeStiffnessObject, Space>;
  template <class Space>
  using Factors = physgen::FormatsOf<quasistatic::SchwarzFactorObject, Space>;
};
/// In half. Blocks of edges are scaled to a unit diagonal; what they lose is added to those of nodes
/// (KeepTranslations): without that, nearly incompressible bodies take a tenth more iterations, with it none.
struct StoredInHalf {
  static constexpr bool rounds = true;
  template <class Space>
  struct Edges : elasticity::EdgeStiffnessFormats<Space> {
    using E = format::Half<>;
  };
  template <class Space>
  struct Factors : quasistatic::SchwarzFactorFormats<Space> {
    using W = format::Half<>;
  };
};

/// What a level needs whose stiffness is not assembled.
struct MatrixFree {
  bool blocks;   ///< whether the inverses of nodes' blocks precondition
  bool coarser;  ///< whether the next coarser level is solved on, too
};

/// @tparam Real of the stiffness
/// @tparam Stored StoredAsComputed or StoredInHalf
template <class Real_, class Space_, class Stored_>
struct LinearLevel {
  using Real = Real_;
  using Space = Space_;
  using Stored = Stored_;
  using Choices = AnyChoice;

  bool assembled = true;  ///< else there are no edges, and what else MatrixFree does not ask for
  quasistatic::NodeConstraintArray<Real, Space> constraints;
  elasticity::EdgeArray<Real, Space> edges;
  PackedRows<Space> node_edges;
  EdgeSums sums;
  EdgeSlices slices;  ///< on CUDA, of few nodes

  elasticity::NodeStiffnessArray<Real, Space> node_stiffness;
  /// On CUDA as records, since they are gathered: from tiles a block is read from nine places.
  elasticity::EdgeStiffnessArray<Real, Space,
                                 PerSpace<Space, LayoutOf<elasticity::EdgeStiffnessArray<Real, Host>>, Aos>>
      edge_stiffness;

  // The preconditioner, in unknowns scaled to a unit diagonal.
  quasistatic::NodeScaleArray<Real, Space> scales;
  elasticity::NodeStiffnessArray<Real, Space> scaled_nodes;
  /// In the order of `slices`, where there are any.
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
  quasistatic::GridParentsArray<Real, Space> grid_parents;  ///< in place of `parents`, to a background grid
  PackedRows<Space> children, edge_terms;
  /// Of levels of a background grid, and of the mesh on it.
  quasistatic::TranslationStiffnessArray<Real, Space> translations;
  bool is_grid = false;  ///< a level of a background grid
  // Of the coarsest level alone.
  quasistatic::CoarseInverseArray<Real, Space> coarse_inverse;
  /// Where that preconditioner is used.
  std::unique_ptr<SchwarzArrays<Real, Space, typename Stored::template Factors<Space>>> schwarz;
  std::unique_ptr<PlaneArrays<Real, Space>> planes;  ///< where the body may touch some
  std::unique_ptr<InertiaArrays<Space>> inertia;     ///< where it moves

  LinearLevel(const LevelGraph& graph, const LevelGraph* coarser)
      : constraints(moved_to<decltype(constraints)>(host_constraints(graph))),
        edges(moved_to<decltype(edges)>(host_edges(graph))),
        node_edges(packed_rows<NodeEdgeEntry>(graph.node_edges, index_t(graph.edges.size()), "edges")),
        sums(as_mesh(graph), Space::kind, sizeof(Real), SumOrder::any),
        slices(Space::kind == SpaceKind::cuda && graph.nodes <= EdgeSlices::most_nodes
                   ? EdgeSlices(as_mesh(graph), Space::kind)
                   : EdgeSlices()),
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
        power(graph.nodes),
        translations(graph.is_grid || !graph.grid_parents.empty() ? graph.nodes : 0),
        is_grid(graph.is_grid) {
    if (coarser == nullptr) {
      if (nodes() <= most_coarse_nodes) coarse_inverse = decltype(coarse_inverse)(nodes() * nodes());
      return;
    }
    if (graph.grid_parents.empty()) {
      parents = moved_to<decltype(parents)>(host_parents(graph));
    } else {
      grid_parents = moved_to<decltype(grid_parents)>(host_grid_parents(graph));
    }
    const auto blocks = std::max(index_t{graph.nodes}, index_t(graph.edges.size()));
    children = PackedRows<Space>(packed_rows<ChildEntry>(graph.children, graph.nodes, "nodes"));
    edge_terms = PackedRows<Space>(packed_rows<EdgeTermEntry>(graph.edge_terms, blocks, "edges"));
  }

  LinearLevel(const LevelGraph& graph, MatrixFree needs)
      : assembled(false),
        constraints(moved_to<decltype(constraints)>(host_constraints(graph))),
        scales(moved_to<decltype(scales)>(host_unit_scales(graph))),
        residual(graph.nodes),
        correction(graph.nodes) {
    if (needs.blocks) {
      node_stiffness = decltype(node_stiffness)(graph.nodes);
      inverse = decltype(inverse)(graph.nodes);
    }
    if (needs.coarser) parents = moved_to<decltype(parents)>(host_parents(graph));
  }

  /// @param rest position of each node
  void use_schwarz(const LevelGraph& graph, const std::vector<Point>& rest) {
    schwarz =
        std::make_unique<typename decltype(schwarz)::element_type>(make_schwarz_hierarchy(graph, rest), edge_count());
  }

  [[nodiscard]] index_t nodes() const { return constraints.size(); }
  [[nodiscard]] index_t bytes() const {
    return bytes_of(constraints, edges, node_edges.ranges(), node_edges.entries(), node_stiffness, edge_stiffness,
                    scales, scaled_nodes, scaled_edges, inverse, smoother, residual, correction, direction, power,
                    parents, grid_parents, children.ranges(), children.entries(), edge_terms.ranges(),
                    edge_terms.entries(), translations, coarse_inverse) +
           sums.bytes() + slices.bytes() + (schwarz == nullptr ? 0 : schwarz->bytes()) +
           (planes == nullptr ? 0 : planes->bytes()) + (inertia == nullptr ? 0 : inertia->bytes());
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
  static auto host_unit_scales(const LevelGraph& graph) {
    quasistatic::NodeScaleArray<Real> array(graph.nodes);
    for (index_t n = 0; n < array.size(); ++n) {
      array.view()[n].scale() = Real(1);
      array.view()[n].inverse() = Real(1);
    }
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
  static auto host_grid_parents(const LevelGraph& graph) {
    quasistatic::GridParentsArray<Real> array(graph.nodes);
    for (index_t n = 0; n < array.size(); ++n) {
      const GridLocation& location = graph.grid_parents[std::size_t(n)];
      for (int k = 0; k < 4; ++k) {
        array.view()[n].nodes()[k] = location.nodes[std::size_t(k)];
        array.view()[n].weights()[k] = static_cast<Real>(location.weights[std::size_t(k)]);
      }
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
