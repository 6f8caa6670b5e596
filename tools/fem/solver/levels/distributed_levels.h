// The arrays of levels on several ranks: the finest levels are cut, and coarser ones stand on every rank. The arrays of
// level l are level[l].constraints and so on; its sets level[l].node and level[l].edge.
//
//   DistributedArrays arrays(ranks, with_halos_of_levels(scenes::quasistatic_scene::halos));
//   add_levels(arrays, levels, graphs, levels_that_are_cut(graphs, ranks.count()));
//   arrays.cut();
//   std::vector<EdgeSums> sums = fill_levels(arrays, levels, graphs);  // by which products go: level[l].sums
#pragma once

#include <fem/mesh/at.h>
#include <fem/solver/hierarchy/galerkin_block.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/levels/layers_of_levels.h>
#include <fem/solver/levels/linear_level.h>
#include <fem/solver/levels/made_entries.h>
#include <physgen/distributed/arrays.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace physgen::fem {

namespace detail {

[[nodiscard]] inline std::string level_name(std::size_t l, const char* name) {
  return "level[" + std::to_string(l) + "]." + name;
}

/// Whether products of level l go by rows of edges, as those of LevelOver do: of few nodes, which all ranks have. That
/// does not depend on how many ranks there are, since no level is cut that is so small, or it is by any number of them.
template <class Level>
[[nodiscard]] bool has_rows(std::size_t l, std::size_t cut, const LevelGraph& graph) {
  using Edges = std::remove_cvref_t<decltype(contents_of(std::declval<Level&>().scaled_edges))>;
  return l >= cut && Edges::Space::kind == SpaceKind::cuda && graph.nodes <= EdgeRows::most_nodes;
}

/// A row of a list, packed, by numbers of all. @param list an IncidenceList, or MeshRows @param rows whose list it is
/// @param elements of the list, for which its codes must do
/// @param before before(local) is what to add to the number of an element of an entry
/// @throw Error when they do not, and when the list has no entries as yet
template <class Packing, class List, class Before>
[[nodiscard]] auto packed_row_of(const List& list, const ListedObjects& rows, index_t elements, const char* name,
                                 const Before& before) {
  if (elements > Packing::most_elements) {
    throw Error("a level has " + std::to_string(elements) + " " + name + ", but the solver's lists can number only " +
                std::to_string(Packing::most_elements) + "; use fewer cells");
  }
  if (!list.first.empty() && at(list.first.back()) != list.entries.size()) {
    throw Error("a level's graph says how many " + std::string(name) +
                " its rows have, and not which; give graphs that make_level_graphs() made");
  }
  return [&list, offset = rows.offset, before](index_t number) {
    const std::size_t row = at(number - offset);
    return MadeEntries(list.first[row], list.first[row + 1], [&list, before](index_t k) {
      const IncidenceEntry& entry = list.entries[at(k)];
      quasistatic::PackedIncidence<float> packed;
      packed.code = (entry.element + before(entry.local)) << Packing::bits | entry.local;
      return packed;
    });
  };
}

/// To the next coarser level. @param own, coarser the lists of the level, and the rows of the coarser one
template <class Level>
void connect_to_coarser(DistributedArrays& arrays, Level& level, const LevelGraph& graph, std::size_t l,
                        const ListedLevel& own, const ListedLevel& coarser) {
  const auto nodes_before = static_cast<Index>(own.nodes.offset), edges_before = static_cast<Index>(own.edges.offset);
  const std::string node = level_name(l, "node"), edge = level_name(l, "edge"), coarse = level_name(l + 1, "node");
  if (graph.grid_parents.empty()) {
    arrays.connect(
        contents_of(level.parents), "nodes", coarse,
        [&graph, of = own.nodes, before = static_cast<Index>(coarser.nodes.offset)](index_t n) {
          const auto& [p, q] = graph.parents[at(of.here(n))];
          return std::array{p + before, q + before};
        },
        own.nodes.known);
  } else {
    arrays.connect(contents_of(level.grid_parents), "nodes", coarse,
                   [&graph](index_t n) { return graph.grid_parents[at(n)].nodes; });
  }
  arrays.connect_rows(contents_of(level.child_ranges), level_name(l, "child_entries"), contents_of(level.child_entries),
                      "code", node,
                      packed_row_of<ChildEntry>(graph.children, coarser.nodes, own.nodes.size, "nodes",
                                                [nodes_before](Index /*local*/) { return nodes_before; }),
                      ChildEntry::bits, coarser.nodes.known);
  const auto is_of_node = [](int local) { return galerkin_block(local) == GalerkinBlock::node; };
  arrays.connect_rows(
      contents_of(level.edge_term_ranges), level_name(l, "edge_term_entries"), contents_of(level.edge_term_entries),
      "code", {node, edge},
      packed_row_of<EdgeTermEntry>(graph.edge_terms, coarser.edges, std::max(own.nodes.size, own.edges.size), "edges",
                                   [=](Index local) { return is_of_node(local) ? nodes_before : edges_before; }),
      EdgeTermEntry::bits,
      [=](const auto& entry) { return is_of_node(entry.code & ((1 << EdgeTermEntry::bits) - 1)) ? 0 : 1; },
      coarser.edges.known);
}

}  // namespace detail

/// Tells which arrays levels have, and what names what. Before cut().
/// @param levels pointers to groups of Level in solver_groups.h, without objects, finest first
/// @param graphs of them, all of each; they outlive cut()
/// @param cut the finest so many are cut, none of them of a background grid
/// @param listed where graphs are of parts, of which
/// @throw Error when such a one is, when one has more edges than lists can number, or was only counted
template <class Levels>
void add_levels(DistributedArrays& arrays, const Levels& levels, std::span<const LevelGraph> graphs, std::size_t cut,
                const ListedLevels& listed = {}) {
  for (std::size_t l = 0; l < graphs.size(); ++l) {
    const ListedLevel own = listed.of(l, graphs[l]);
    const index_t nodes = own.nodes.size, edges = own.edges.size;
    if (l < cut && graphs[l].is_grid) {
      throw Error("level " + std::to_string(l) +
                  " is one of a background grid, which all ranks have; cut the levels above it alone");
    }
    const auto add_set = [&](const char* name, index_t size) {
      l < cut ? arrays.add_set(detail::level_name(l, name), size)
              : arrays.add_replicated_set(detail::level_name(l, name), size);
    };
    add_set("node", nodes);
    add_set("edge", edges);
    if (l < cut) arrays.follow(detail::level_name(l, "edge"), detail::level_name(l, "node"));
    const bool is_inverted = l >= cut && l + 1 == graphs.size() && nodes <= most_coarse_nodes;
    if (is_inverted) arrays.add_replicated_set(detail::level_name(l, "coarse_pair"), nodes * nodes);
  }
  for (std::size_t l = 0; l < graphs.size(); ++l) {
    auto& level = *levels[l];
    const LevelGraph& graph = graphs[l];
    const std::string node = detail::level_name(l, "node"), edge = detail::level_name(l, "edge");
    const ListedLevel own = listed.of(l, graph);
    const auto add = [&](const char* name, const std::string& set, auto& array) {
      arrays.add(detail::level_name(l, name), set, contents_of(array));
    };
    add("constraints", node, level.constraints);
    add("edges", edge, level.edges);
    add("node_edge_ranges", node, level.node_edge_ranges);
    add("node_stiffness", node, level.node_stiffness);
    add("edge_stiffness", edge, level.edge_stiffness);
    add("scales", node, level.scales);
    add("scaled_nodes", node, level.scaled_nodes);
    const bool is_by_rows = detail::has_rows<std::remove_cvref_t<decltype(level)>>(l, cut, graph);
    if (is_by_rows) arrays.add_replicated_set(detail::level_name(l, "edge_end"), 2 * own.edges.size);
    add("scaled_edges", is_by_rows ? detail::level_name(l, "edge_end") : edge, level.scaled_edges);
    add("inverse", node, level.inverse);
    add("residual", node, level.residual);
    add("correction", node, level.correction);
    add("direction", node, level.direction);
    add("power", node, level.power);
    arrays.connect(
        contents_of(level.edges), "nodes", node,
        [&graph, of = own.edges, before = static_cast<Index>(own.nodes.offset)](index_t e) {
          const auto& [m, n] = graph.edges[at(of.here(e))];
          return std::array{m + before, n + before};
        },
        own.edges.known);
    arrays.connect_rows(contents_of(level.node_edge_ranges), detail::level_name(l, "node_edge_entries"),
                        contents_of(level.node_edge_entries), "code", edge,
                        detail::packed_row_of<NodeEdgeEntry>(
                            graph.node_edges, own.nodes, own.edges.size, "edges",
                            [before = static_cast<Index>(own.edges.offset)](Index /*local*/) { return before; }),
                        NodeEdgeEntry::bits, own.nodes.known);
    if (graph.is_grid || !graph.grid_parents.empty()) add("translations", node, level.translations);
    if (l + 1 < graphs.size()) {
      if (graph.grid_parents.empty()) {
        add("parents", node, level.parents);
      } else {
        add("parents", node, level.grid_parents);  // which the table means by that name, too
      }
      add("child_ranges", detail::level_name(l + 1, "node"), level.child_ranges);
      add("edge_term_ranges", detail::level_name(l + 1, "edge"), level.edge_term_ranges);
      detail::connect_to_coarser(arrays, level, graph, l, own, listed.coarser_of(l, graphs[l + 1]));
    } else if (l >= cut && graph.nodes <= most_coarse_nodes) {
      add("coarse_inverse", detail::level_name(l, "coarse_pair"), level.coarse_inverse);
    }
  }
}

/// The rows by which products of small levels go, of each level; none of others. Behind cut(), when graphs may have no
/// lists any more. @param cut as add_levels() takes it
template <class Levels>
[[nodiscard]] std::vector<EdgeRows> rows_of_levels(const Levels& levels, std::span<const LevelGraph> graphs,
                                                   std::size_t cut) {
  using Level = std::remove_cvref_t<decltype(*levels[0])>;
  const auto on_host = [](const auto& array, const auto& use) {
    using Array = std::remove_cvref_t<decltype(array)>;
    const auto& here = physgen::detail::in_form_of<physgen::detail::OnHost<Array>>(array);
    const auto view = here.const_view();
    for (index_t i = 0; i < view.size(); ++i) use(view[i]);
  };
  std::vector<EdgeRows> rows(graphs.size());
  for (std::size_t l = 0; l < graphs.size(); ++l) {
    if (!detail::has_rows<Level>(l, cut, graphs[l])) continue;
    const Level& level = *levels[l];
    TetMesh mesh;
    mesh.nodes = static_cast<Index>(level.constraints.size());
    on_host(contents_of(level.edges), [&](const auto& edge) {
      mesh.edges.push_back({static_cast<Index>(edge.nodes()[0]), static_cast<Index>(edge.nodes()[1])});
    });
    on_host(contents_of(level.node_edge_ranges),
            [&](const auto& row) { mesh.node_edges.first.push_back(static_cast<Index>(row.begin())); });
    on_host(contents_of(level.node_edge_entries), [&](const auto& entry) {
      mesh.node_edges.entries.push_back(
          {static_cast<Index>(NodeEdgeEntry::element(entry)), static_cast<Index>(NodeEdgeEntry::local(entry))});
    });
    mesh.node_edges.first.push_back(static_cast<Index>(mesh.node_edges.entries.size()));
    rows[l] = EdgeRows(mesh, SpaceKind::cuda);
  }
  return rows;
}

/// Fills in constraints, and weights in a background grid. Behind cut(). @return the lists that products of each level
/// go by
template <class Levels>
[[nodiscard]] std::vector<EdgeSums> fill_levels(DistributedArrays& arrays, const Levels& levels,
                                                std::span<const LevelGraph> graphs, const ListedLevels& listed = {}) {
  std::vector<EdgeSums> sums;
  for (std::size_t l = 0; l < graphs.size(); ++l) {
    auto& level = *levels[l];
    level.smoother.resize(1);  // on the device that cut() took
    const ListedObjects nodes = listed.of(l, graphs[l]).nodes;
    arrays.fill(contents_of(level.constraints), [&](index_t node) {
      typename std::remove_cvref_t<decltype(level.constraints)>::Value value{};
      value.fixed = graphs[l].fixed[at(nodes.here(node))];
      return value;
    });
    if (!graphs[l].grid_parents.empty()) {
      arrays.fill(contents_of(level.grid_parents), [&](index_t node) {
        typename std::remove_cvref_t<decltype(level.grid_parents)>::Value value{};
        for (int k = 0; k < 4; ++k) {
          value.weights[k] = static_cast<std::remove_cvref_t<decltype(value.weights[k])>>(
              graphs[l].grid_parents[at(node)].weights[at(k)]);
        }
        return value;
      });
    }
    // Of the edges that are here; objects before the first and behind the last stand for none.
    const LocalSet& edges = arrays.objects_of(contents_of(level.edges));
    std::vector<std::array<Index, 2>> ends(static_cast<std::size_t>(edges.size()));
    using Edges = std::remove_cvref_t<decltype(contents_of(level.edges))>;
    const auto& on_host = physgen::detail::in_form_of<physgen::detail::OnHost<Edges>>(contents_of(level.edges));
    const auto view = on_host.const_view();
    for (index_t e = edges.first(); e < edges.last(); ++e) {
      for (int k = 0; k < 2; ++k) ends[at(e)][static_cast<std::size_t>(k)] = view[e].nodes()[k];
    }
    const bool has_edges = edges.first() < edges.last();
    using Real = typename std::remove_cvref_t<decltype(level.edge_stiffness)>::Precision;
    const LocalSet& here = arrays.objects_of(contents_of(level.constraints));
    const std::vector<Index> groups =
        groups_of_part(here.first(), here.last(), here.runs().size(), [&](index_t node) { return here.global(node); });
    sums.emplace_back(static_cast<Index>(level.constraints.size()), ends, Edges::Space::kind, sizeof(Real),
                      SumOrder::fixed, has_edges ? edges.first() : edges.size(), groups);
  }
  return sums;
}

}  // namespace physgen::fem
