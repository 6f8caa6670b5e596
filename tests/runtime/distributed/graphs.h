// Random graphs, and kernels over them: own objects, others through one and through two index fields, through rows,
// sets that follow and sets that do not, sums and what is done with them.
#pragma once

#include <elasticity.physgen.h>
#include <physgen/kernel.h>

#include <array>
#include <random>
#include <vector>

namespace graphs {
using namespace physgen;
// One object at a time: relax.cpp has packs. All sums are of doubles, so that a compiler that fuses them does so for
// all.

template <class EdgeView, class PositionView, class SpringView>
struct Pull {
  using Scalar = typename SpringView::Precision;
  EdgeView edges;
  PositionView positions;
  SpringView springs;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    const auto nodes = edges[i].nodes().get();
    springs[i].f() = (positions[nodes[1]].x().get() - positions[nodes[0]].x().get()).eval();
  }
};
template <class... V>
Pull(V...) -> Pull<V...>;

template <class Rows, class SpringView, class ForceView>
struct SumPulls {
  using Scalar = typename ForceView::Precision;
  Rows ends;
  SpringView springs;
  ForceView forces;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    using Vector = Eigen::Matrix<typename ForceView::Precision, 3, 1>;
    Vector sum = Vector::Zero();
    ends.for_each(i, [&](const auto& end, bool) {
      const Vector f = springs[end.element()].f();
      if (end.local() == 0)
        sum += f;
      else
        sum -= f;
    });
    forces[i].f() = sum;
  }
};
template <class... V>
SumPulls(V...) -> SumPulls<V...>;

/// Reads positions of nodes at the other ends of edges: through two index fields.
template <class Rows, class EdgeView, class PositionView, class MeanView>
struct Smooth {
  using Scalar = typename MeanView::Precision;
  Rows ends;
  EdgeView edges;
  PositionView positions;
  MeanView means;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    using Vector = Eigen::Matrix<typename MeanView::Precision, 3, 1>;
    Vector sum = positions[i].x();
    ends.for_each(i, [&](const auto& end, bool) {
      const index_t other = edges[end.element()].nodes()[1 - int(end.local())];
      sum = sum + positions[other].x().get();
    });
    means[i].dx() = Vector(sum * (1.0F / float(1 + ends.size(i))));
  }
};
template <class... V>
Smooth(V...) -> Smooth<V...>;

template <class ForceView, class MeanView, class PositionView>
struct Move {
  using Scalar = typename PositionView::Precision;
  ForceView forces;
  MeanView means;
  PositionView positions;
  float step;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    positions[i].x() =
        (positions[i].x().get() * 0.5F + means[i].dx().get() * 0.25F + forces[i].f().get() * step).eval();
  }
};
template <class F, class M, class P>
Move(F, M, P, float) -> Move<F, M, P>;

/// A quad follows no set. It has the mean of its nodes, and what it had.
template <class QuadView, class PositionView, class ShareView>
struct Share {
  using Scalar = typename ShareView::Precision;
  QuadView quads;
  PositionView positions;
  ShareView shares;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    const auto nodes = quads[i].nodes().get();
    auto sum = (positions[nodes[0]].x().get() + positions[nodes[1]].x().get()).eval();
    sum = sum + positions[nodes[2]].x().get() + positions[nodes[3]].x().get();
    shares[i].df() = (shares[i].df().get() * 0.5F + sum * 0.125F).eval();
  }
};
template <class... V>
Share(V...) -> Share<V...>;

template <class Rows, class ShareView, class ForceView>
struct AddShares {
  using Scalar = typename ForceView::Precision;
  Rows touches;
  ShareView shares;
  ForceView forces;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    using Vector = Eigen::Matrix<typename ForceView::Precision, 3, 1>;
    Vector sum = forces[i].f();
    touches.for_each(i, [&](const auto& touch, bool) { sum += shares[touch.element()].df().get() * 0.0625F; });
    forces[i].f() = sum;
  }
};
template <class... V>
AddShares(V...) -> AddShares<V...>;

/// Nothing of others: it can be done for ghosts, too.
template <class ForceView, class MeanView>
struct Mix {
  using Scalar = typename MeanView::Precision;
  ForceView forces;
  MeanView means;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    means[i].dx() = (means[i].dx().get() * 0.5F + forces[i].f().get() * 0.5F).eval();
  }
};
template <class... V>
Mix(V...) -> Mix<V...>;

template <class MeanView, class PositionView>
struct Drift {
  using Scalar = typename PositionView::Precision;
  MeanView means;
  PositionView positions;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    positions[i].x() = (positions[i].x().get() + means[i].dx().get() * 0.5F).eval();
  }
};
template <class... V>
Drift(V...) -> Drift<V...>;

template <class PositionView, class EdgeView>
struct Lengths {
  using Scalar = typename PositionView::Precision;
  PositionView positions;
  EdgeView edges;
  PHYSGEN_FUNCTION double operator()(index_t i) const {
    const auto nodes = edges[i].nodes().get();
    return double((positions[nodes[1]].x().get() - positions[nodes[0]].x().get()).squaredNorm());
  }
};
template <class... V>
Lengths(V...) -> Lengths<V...>;

/// Forces of a part of the springs, and their squares.
template <class EdgeView, class PositionView, class SpringView>
struct PullPart {
  using Scalar = typename SpringView::Precision;
  index_t first;
  EdgeView edges;
  PositionView positions;
  SpringView springs;
  PHYSGEN_FUNCTION double operator()(SingleObject auto i) const {
    const auto own = object_of_part(first, i);
    const auto nodes = edges[own].nodes().get();
    const auto d = (positions[nodes[0]].x().get() - positions[nodes[1]].x().get()).eval();
    springs[own].f() = d;
    return double(d.squaredNorm());
  }
};
template <class... V>
PullPart(index_t, V...) -> PullPart<V...>;

template <class StateView>
struct Store {
  StateView state;
  int at;
  template <class Value>
  PHYSGEN_FUNCTION void operator()(const Value& value) const {
    if constexpr (requires { value.index; })
      state[index_t{0}].f()[at] = double(value.index);
    else
      state[index_t{0}].f()[at] = double(value);
  }
};
template <class S>
Store(S, int) -> Store<S>;

/// A graph of nodes, edges and quads (of four nodes, some of them twice); and groups of nodes and edges, which all
/// ranks have.
struct Graph {
  index_t nodes;
  std::vector<std::array<index_t, 2>> edges;
  std::vector<std::array<index_t, 4>> quads;
  std::vector<std::vector<elasticity::Incidence<float>>> ends, touches;
  std::vector<std::vector<elasticity::Incidence<float>>> members;  ///< of each group: nodes (local 1) and edges (0)
  std::vector<std::array<index_t, 2>> homes, links;                ///< two groups of each node, and of each group
  std::vector<std::array<index_t, 2>> others;                      ///< of each edge two nodes, anywhere

  Graph(index_t count, std::mt19937& random) : nodes(count), ends(at(count)), touches(at(count)) {
    const auto number = [&](index_t below) { return static_cast<index_t>(random()) % below; };
    const bool is_local = random() % 2 == 0;  // names are near, or anywhere
    const auto near = [&](index_t node) { return is_local ? (node + 1 + number(40)) % nodes : number(nodes); };
    const index_t edge_count = nodes == 0 ? 0 : number(3 * nodes + 1), quad_count = nodes == 0 ? 0 : number(nodes + 1);
    const bool is_ordered = random() % 2 == 0;
    for (index_t e = 0; e < edge_count; ++e) {
      const index_t node = is_ordered ? e * nodes / edge_count : number(nodes);
      edges.push_back({node, near(node)});
      for (int k = 0; k < 2; ++k) ends[at(edges.back()[static_cast<std::size_t>(k)])].push_back(incidence(e, k));
    }
    for (index_t t = 0; t < quad_count; ++t) {
      const index_t node = is_ordered ? t * nodes / quad_count : number(nodes);
      quads.push_back({node, near(node), near(node), number(nodes)});
      touches[at(node)].push_back(incidence(t, 0));
      touches[at(quads.back()[3])].push_back(incidence(t, 3));
    }
    members.resize(at(1 + number(nodes / 4 + 1)));
    const auto groups = static_cast<index_t>(members.size());
    for (index_t g = 0; g < groups; ++g) {
      links.push_back({number(groups), number(groups)});
      for (index_t k = number(9); k > 0; --k) members[at(g)].push_back(incidence(near(g * nodes / groups), 1));
      for (index_t k = number(4); k > 0 && edge_count > 0; --k) {
        members[at(g)].push_back(
            incidence(is_local ? (g * edge_count / groups + k) % edge_count : number(edge_count), 0));
      }
    }
    for (index_t n = 0; n < nodes; ++n) homes.push_back({n * groups / nodes, number(groups)});
    std::mt19937 of_others(static_cast<unsigned>(edge_count));
    for (index_t e = 0; e < edge_count; ++e) {
      others.push_back({static_cast<index_t>(of_others()) % nodes, static_cast<index_t>(of_others()) % nodes});
    }
  }
  static std::size_t at(index_t i) { return static_cast<std::size_t>(i); }
  static elasticity::Incidence<float> incidence(index_t element, int local) {
    elasticity::Incidence<float> value{};
    value.element = static_cast<std::int32_t>(element);
    value.local = local;
    return value;
  }
};

}  // namespace graphs
