// The arrays of a program over a graph: of all objects, or on several ranks; on the host, or on a device.
#pragma once

#include <physgen/distributed/arrays.h>

#include <vector>

#include "graphs.h"

namespace graphs {

/// Arrays of a program, of all objects or of a rank's.
template <class Space, class Real, class X, class F, class M, class S, class Stored>
struct Body {
  using OnHost = Body<Host, Real, X, F, M, S, Stored>;
  Array<elasticity::NodePositionObject, Real, Space, X> positions;
  Array<elasticity::NodeForceObject, Real, Space, F> forces;
  Array<elasticity::NodeForceObject, Real, Space, S, Stored> springs;
  Array<elasticity::NodeDisplacementObject, Real, Space, M> means;
  Array<elasticity::NodeForceDifferentialObject, Real, Space, S> shares;
  Array<elasticity::EdgeObject, Real, Space, M> edges, others;
  Array<elasticity::TetObject, Real, Space, F> quads;
  elasticity::IncidenceRangeArray<float, Space> ranges, touched, member_ranges;
  elasticity::IncidenceArray<float, Space> ends, touches, members;
  // Of groups; and of nodes.
  Array<elasticity::NodeForceObject, Real, Space, S, Stored> totals;
  Array<elasticity::NodeDisplacementObject, Real, Space, F> calms;
  Array<elasticity::EdgeObject, Real, Space, X> links, homes;
  elasticity::NodeForceArray<double, Space> state;
};
template <class Space>
struct HalfForces : elasticity::NodeForceFormats<Space> {
  using f = format::Half<>;
};
template <class Space>
using InFloat = Body<Space, float, AosPadded, Soa, Aosoa<16>, Aos, elasticity::NodeForceFormats<Space>>;
template <class Space>
using InDouble = Body<Space, double, Soa, Aosoa<8>, Aos, AosPadded, elasticity::NodeForceFormats<Space>>;
template <class Space>
using InHalf = Body<Space, float, Aosoa<16>, AosPadded, Soa, Soa, HalfForces<Space>>;

/// The array as the host reaches it.
template <class Array>
decltype(auto) on_host(const Array& array) {
  return detail::in_form_of<detail::OnHost<Array>>(array);
}

template <class Body>
typename decltype(Body::positions)::Value position(index_t node) {
  typename decltype(Body::positions)::Value value{};
  for (int k = 0; k < 3; ++k) value.x[k] = static_cast<float>((node * (2 * k + 3)) % 101 - 50) / 64;
  return value;
}

template <class Body>
void fill(Body& body, const Graph& graph) {
  const auto entries = [](auto& ranges, auto& array, const auto& rows) {
    std::vector<elasticity::Incidence<float>> all;
    ranges.resize(static_cast<index_t>(rows.size()));
    for (index_t i = 0; i < ranges.size(); ++i) {
      ranges[i].begin() = static_cast<std::int32_t>(all.size());
      all.insert(all.end(), rows[Graph::at(i)].begin(), rows[Graph::at(i)].end());
      ranges[i].end() = static_cast<std::int32_t>(all.size());
    }
    array.resize(static_cast<index_t>(all.size()));
    for (index_t k = 0; k < array.size(); ++k) array.view().put(k, all[Graph::at(k)]);
  };
  body.positions.resize(graph.nodes);
  body.forces.resize(graph.nodes);
  body.means.resize(graph.nodes);
  body.homes.resize(graph.nodes);
  body.state.resize(1);
  body.links.resize(static_cast<index_t>(graph.links.size()));
  body.totals.resize(body.links.size());
  body.calms.resize(body.links.size());
  body.edges.resize(static_cast<index_t>(graph.edges.size()));
  body.others.resize(body.edges.size());
  body.springs.resize(body.edges.size());
  body.quads.resize(static_cast<index_t>(graph.quads.size()));
  body.shares.resize(body.quads.size());
  entries(body.ranges, body.ends, graph.ends);
  entries(body.touched, body.touches, graph.touches);
  entries(body.member_ranges, body.members, graph.members);
  for (index_t i = 0; i < graph.nodes; ++i) body.positions.view().put(i, position<Body>(i));
  const auto pairs = [](auto& array, const auto& named) {
    for (index_t e = 0; e < array.size(); ++e)
      for (int k = 0; k < 2; ++k) array[e].nodes()[k] = static_cast<std::int32_t>(named[Graph::at(e)][Graph::at(k)]);
  };
  pairs(body.edges, graph.edges);
  pairs(body.others, graph.others);
  pairs(body.links, graph.links);
  pairs(body.homes, graph.homes);
  for (index_t t = 0; t < body.quads.size(); ++t)
    for (int k = 0; k < 4; ++k)
      body.quads[t].nodes()[k] = static_cast<std::int32_t>(graph.quads[Graph::at(t)][Graph::at(k)]);
}

/// The same in any memory.
template <class Body>
void fill_anywhere(Body& body, const Graph& graph) {
  if constexpr (std::is_same_v<Body, typename Body::OnHost>) {
    fill(body, graph);
  } else {
    typename Body::OnHost here;
    fill(here, graph);
    const auto take = [](auto& array, const auto& from) {
      array.resize(from.size());
      copy(array, from);
    };
    take(body.positions, here.positions), take(body.forces, here.forces), take(body.springs, here.springs);
    take(body.means, here.means), take(body.shares, here.shares), take(body.edges, here.edges);
    take(body.quads, here.quads), take(body.ranges, here.ranges), take(body.touched, here.touched);
    take(body.member_ranges, here.member_ranges), take(body.ends, here.ends), take(body.touches, here.touches);
    take(body.members, here.members), take(body.totals, here.totals), take(body.calms, here.calms);
    take(body.links, here.links), take(body.homes, here.homes), take(body.state, here.state);
    take(body.others, here.others);
    synchronize();
  }
}

/// All objects.
struct AllKnown {
  KnownObjects operator()(const char* /*set*/) const { return {}; }
};
/// @param has_others whether edges name other nodes, too, in an array that a program may swap with theirs
/// @param known known(set) are those of which this rank tells what they name
template <class Body, class Known = AllKnown>
void distribute(DistributedArrays& arrays, Body& body, const Graph& graph, bool follows, bool has_others,
                const Known& known = {}) {
  arrays.add_set("node", graph.nodes);
  arrays.add_set("edge", static_cast<index_t>(graph.edges.size()));
  arrays.add_set("quad", static_cast<index_t>(graph.quads.size()));
  if (follows) arrays.follow("edge", "node");
  // Other names of the sets, counted by themselves.
  arrays.add_set("mean", graph.nodes);
  arrays.add_set("spring", static_cast<index_t>(graph.edges.size()));
  arrays.same_set("mean", "node");
  arrays.add_replicated_set("one", 1);
  arrays.add("b.state", "one", body.state);
  arrays.add("b.positions", "node", body.positions);
  arrays.add("b.forces", "node", body.forces);
  arrays.add("b.means", "mean", body.means);
  arrays.add("b.ranges", "node", body.ranges);
  arrays.add("b.touched", "node", body.touched);
  arrays.add("b.edges", "edge", body.edges);
  arrays.add("b.springs", "spring", body.springs);
  arrays.add("b.quads", "quad", body.quads);
  arrays.add("b.shares", "quad", body.shares);
  arrays.connect(body.edges, "nodes", "node", [&](index_t e) { return graph.edges[Graph::at(e)]; }, known("edge"));
  if (has_others) {
    arrays.add("b.others", "edge", body.others);
    arrays.connect(body.others, "nodes", "node", [&](index_t e) { return graph.others[Graph::at(e)]; }, known("edge"));
  }
  arrays.connect(body.quads, "nodes", "node", [&](index_t t) { return graph.quads[Graph::at(t)]; }, known("quad"));
  arrays.connect_rows(
      body.ranges, "b.ends", body.ends, "element", "edge",
      [&](index_t i) -> const auto& { return graph.ends[Graph::at(i)]; }, 0, known("node"));
  arrays.same_set("spring", "edge");  // behind what has them
  arrays.connect_rows(
      body.touched, "b.touches", body.touches, "element", "quad",
      [&](index_t i) -> const auto& { return graph.touches[Graph::at(i)]; }, 0, known("node"));
  arrays.add_replicated_set("group", static_cast<index_t>(graph.links.size()));
  arrays.add("b.totals", "group", body.totals);
  arrays.add("b.calms", "group", body.calms);
  arrays.add("b.links", "group", body.links);
  arrays.add("b.homes", "mean", body.homes);
  arrays.add("b.member_ranges", "group", body.member_ranges);
  arrays.connect(body.links, "nodes", "group", [&](index_t g) { return graph.links[Graph::at(g)]; });
  arrays.connect(body.homes, "nodes", "group", [&](index_t n) { return graph.homes[Graph::at(n)]; }, known("node"));
  arrays.connect_rows(
      body.member_ranges, "b.members", body.members, "element", {"spring", "node"},
      [&](index_t g) -> const auto& { return graph.members[Graph::at(g)]; }, 0,
      [](const auto& member) { return int(member.local); }, known("group"));
  arrays.cut();
}

}  // namespace graphs
