// The arrays of one level of the preconditioner, by name.
#pragma once

#include <fem/kernels/edge_rows.h>
#include <fem/kernels/symmetric_product.h>
#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/arrays/run_time_choices.h>
#include <fem/solver/arrays/solver_arrays.h>
#include <fem/solver/arrays/stored.h>
#include <fem/solver/assembled_stiffness.h>
#include <fem/solver/hierarchy/level_counts.h>
#include <fem/solver/loads/inertia_arrays.h>
#include <fem/solver/loads/plane_arrays.h>

#include <algorithm>
#include <utility>

namespace physgen::fem {

/// The settings of a level whose stiffness is not assembled.
struct MatrixFree {
  bool blocks;   ///< whether the inverses of nodes' blocks precondition
  bool coarser;  ///< whether the next coarser level is solved on, too
};

/// @tparam Real_ of the stiffness
/// @tparam Stored_ StoredAsComputed or StoredInHalf
/// @tparam Choices_ what is asked for at run time: AnyChoice, or another of run_time_choices.h
/// @tparam Group with the arrays of Level in solver_groups.h
/// @tparam Extra ExtraOver, Planes PlanesOver, Inertia InertiaOver, or NoArrays
template <class Real_, class Space_, class Stored_, class Choices_, class Group, class Extra, class Planes,
          class Inertia>
struct LevelOver : Group {
  using Real = Real_;
  using Space = Space_;
  using Stored = Stored_;
  using Choices = Choices_;
  using Own = Group;  ///< without what it may have besides

  bool assembled = true;      ///< else there are no edges, and what else MatrixFree does not ask for
  bool is_grid = false;       ///< a level of a background grid
  bool lies_in_grid = false;  ///< the next coarser level is the finest of one
  EdgeSums sums;
  EdgeRows rows;              ///< on CUDA, of few nodes: scaled_edges then has a block for each of their entries
  Optional<Extra> extra;      ///< of the preconditioner that is used
  Optional<Planes> planes;    ///< where the body may touch some
  Optional<Inertia> inertia;  ///< where it moves
  RowsOf<decltype(Group::node_edge_ranges), decltype(Group::node_edge_entries)> node_edges{this->node_edge_ranges,
                                                                                           this->node_edge_entries};
  RowsOf<decltype(Group::child_ranges), decltype(Group::child_entries)> children{this->child_ranges,
                                                                                 this->child_entries};
  RowsOf<decltype(Group::edge_term_ranges), decltype(Group::edge_term_entries)> edge_terms{this->edge_term_ranges,
                                                                                           this->edge_term_entries};

  explicit LevelOver(Group&& arrays) : Group(std::move(arrays)) {}
  /// With an assembled stiffness. @param graph whole, or counted; so `coarser`, the next level, or null
  LevelOver(const LevelGraph& graph, const LevelGraph* coarser)
      : is_grid(graph.is_grid),
        lies_in_grid(!graph.grid_parents.empty()),
        sums(graph.nodes, graph.edges, Space::kind, sizeof(Real), SumOrder::any),
        rows(has_rows(graph.nodes) ? EdgeRows(as_mesh(graph), Space::kind) : EdgeRows()) {
    const index_t nodes = graph.nodes, edges = index_t(graph.edges.size());
    const GraphCounts own = counts_of(graph), next = coarser == nullptr ? GraphCounts() : counts_of(*coarser);
    this->allocate(counts(own, coarser == nullptr ? nullptr : &next));
    if (!rows.is_empty()) this->scaled_edges.resize(2 * edges);
    put_constraints(graph);
    put_each(this->edges, [&](index_t e, auto&& edge) {
      for (int k = 0; k < 2; ++k) edge.nodes()[k] = graph.edges[std::size_t(e)][std::size_t(k)];
    });
    put_packed<NodeEdgeEntry>(this->node_edge_ranges, this->node_edge_entries, graph.node_edges, edges, "edges");
    if (coarser == nullptr) return;
    put_packed<ChildEntry>(this->child_ranges, this->child_entries, graph.children, nodes, "nodes");
    const auto each_terms = [&](const auto& put) { each_edge_terms(graph, *coarser, put); };
    put_packed_parts<EdgeTermEntry>(this->edge_term_ranges, this->edge_term_entries, graph.edge_terms.first, each_terms,
                                    std::max(nodes, edges), "edges");
    if (graph.grid_parents.empty()) {
      put_parents(graph);
    } else {
      put_each(this->grid_parents, [&](index_t n, auto&& parents) {
        const GridLocation& location = graph.grid_parents[std::size_t(n)];
        for (int k = 0; k < 4; ++k) {
          parents.nodes()[k] = location.nodes[std::size_t(k)];
          parents.weights()[k] = static_cast<Real>(location.weights[std::size_t(k)]);
        }
      });
    }
  }
  LevelOver(const LevelGraph& graph, MatrixFree needs) : assembled(false) {
    this->allocate(counts(graph.nodes, needs));
    put_constraints(graph);
    put_each(this->scales, [](index_t /*n*/, auto&& scale) {
      scale.scale() = Real(1);
      scale.inverse() = Real(1);
    });
    if (needs.coarser) put_parents(graph);
  }

  /// The bytes() of such levels before they are made, without extra arrays, planes and inertia. @param coarser or null
  [[nodiscard]] static index_t bytes_for(const GraphCounts& level, const GraphCounts* coarser) {
    index_t bytes =
        Group::bytes(counts(level, coarser)) + EdgeSums::bytes_for<Real>(level.nodes, level.edges, Space::kind);
    if (has_rows(level.nodes)) {
      using Blocks = decltype(Group::scaled_edges);
      bytes += EdgeRows::bytes_for(level.nodes, level.edges) + bytes_of_array<Blocks>(2 * level.edges) -
               bytes_of_array<Blocks>(level.edges);
    }
    return bytes;
  }
  [[nodiscard]] static index_t bytes_for(const GraphCounts& level, MatrixFree needs) {
    return Group::bytes(counts(level.nodes, needs));
  }

  [[nodiscard]] index_t nodes() const { return this->constraints.size(); }
  [[nodiscard]] index_t edge_count() const { return this->edge_stiffness.size(); }
  [[nodiscard]] index_t bytes() const {
    return Group::bytes() + sums.bytes() + rows.bytes() + bytes_where(extra) + bytes_where(planes) +
           bytes_where(inertia);
  }

  /// The stiffness as plain blocks. @pre nothing is under way in it
  [[nodiscard]] AssembledStiffness stiffness() const {
    const auto node_blocks = moved_to<elasticity::NodeStiffnessArray<Real>>(this->node_stiffness);
    const auto edge_blocks = moved_to<elasticity::EdgeStiffnessArray<Real>>(this->edge_stiffness);
    const auto ends = moved_to<elasticity::EdgeArray<Real>>(this->edges);
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
  static auto counts(const GraphCounts& level, const GraphCounts* coarser) {
    const index_t n = level.nodes;
    const bool last = coarser == nullptr;
    return typename Group::Counts{.node = n,
                                  .edge = level.edges,
                                  .edge_node = n,
                                  .edge_end = 2 * level.edges,
                                  .block_node = n,
                                  .smoother = 1,
                                  .child = last ? 0 : n - level.grid_parents,
                                  .grid_child = last ? 0 : level.grid_parents,
                                  .parent = last ? 0 : coarser->nodes,
                                  .child_entry = last ? 0 : level.children,
                                  .coarse_edge = last ? 0 : coarser->edges,
                                  .edge_term = last ? 0 : level.edge_terms,
                                  .grid_node = level.is_grid ? n : level.grid_parents,
                                  .coarse_pair = last && n <= most_coarse_nodes ? n * n : 0};
  }
  static auto counts(index_t nodes, MatrixFree needs) {
    return typename Group::Counts{
        .node = nodes, .block_node = needs.blocks ? nodes : 0, .child = needs.coarser ? nodes : 0};
  }
  static bool has_rows(index_t nodes) { return Space::kind == SpaceKind::cuda && nodes <= EdgeRows::most_nodes; }
  void put_constraints(const LevelGraph& graph) {
    put_each(this->constraints, [&](index_t n, auto&& node) { node.fixed() = graph.fixed[std::size_t(n)]; });
  }
  void put_parents(const LevelGraph& graph) {
    put_each(this->parents, [&](index_t n, auto&& parents) {
      for (int k = 0; k < 2; ++k) parents.nodes()[k] = graph.parents[std::size_t(n)][std::size_t(k)];
    });
  }
  /// As rows of edges want it.
  static TetMesh as_mesh(const LevelGraph& graph) {
    TetMesh mesh;
    mesh.nodes = graph.nodes;
    mesh.edges = graph.edges;
    mesh.node_edges = graph.node_edges;
    return mesh;
  }
};

}  // namespace physgen::fem
