// The kernels of the scene relax, and their table as it is written by hand.
#pragma once

#include <elasticity.physgen.h>
#include <physgen/distributed/halo_uses.h>
#include <physgen/error.h>
#include <physgen/kernel.h>
#include <physgen/rows.h>

#include <string>

namespace springs {

using namespace physgen;
using namespace physgen::math;

/// The force of a spring on its first node.
template <class EdgeView, class PositionView, class SpringView>
struct Pull {
  using Scalar = typename SpringView::Precision;
  EdgeView edges;
  PositionView positions;
  SpringView springs;
  Scalar length;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const lanes_t<std::int32_t, I> a = edges[i].nodes()[0], b = edges[i].nodes()[1];
    const Vector d = positions[b].x().get() - positions[a].x().get();
    springs[i].f() = Vector(d * (S(Scalar(1)) - S(length) / sqrt(S(d.squaredNorm()))));
  }
};
template <class E, class P, class S>
Pull(E, P, S, float) -> Pull<E, P, S>;

template <class EndRows, class SpringView, class ForceView>
struct SumPulls {
  using Scalar = typename ForceView::Precision;
  EndRows ends;
  SpringView springs;
  ForceView forces;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    forces[i].f() = ends.sum(i, Vector(Vector::Zero()), [&](const auto& end) -> Vector {
      const lanes_t<std::int32_t, I> which = end.local();
      const Vector f = springs[end.element()].f();
      return f * select(which == lanes_t<std::int32_t, I>(0), S(Scalar(1)), S(Scalar(-1)));
    });
  }
};
template <class R, class S, class F>
SumPulls(R, S, F) -> SumPulls<R, S, F>;

template <class ForceView, class PositionView>
struct Move {
  using Scalar = typename PositionView::Precision;
  ForceView forces;
  PositionView positions;
  Scalar step;
  index_t refused;  ///< the local number of a node at which it throws on the host, or -1

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
#ifndef __CUDA_ARCH__
    if (object_number(node) == refused) throw Error("node " + std::to_string(refused) + " may not move");
#endif
    positions[node].x() = positions[node].x().get() + forces[node].f().get() * step;
  }
};
template <class F, class P>
Move(F, P, float, index_t) -> Move<F, P>;

template <class ForceView>
struct SquaredForce {
  using Scalar = typename ForceView::Precision;
  ForceView forces;
  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    const Eigen::Matrix<lanes_t<Scalar, I>, 3, 1> f = forces[i].f();
    return f.squaredNorm();
  }
};
template <class F>
SquaredForce(F) -> SquaredForce<F>;

/// f = (squared force of all, the node with the largest, steps)
template <class StateView>
struct StoreSquare {
  StateView state;
  PHYSGEN_FUNCTION void operator()(double square) const {
    state[index_t{0}].f()[0] = square;
    state[index_t{0}].f()[2] += 1.0;
  }
};
template <class S>
StoreSquare(S) -> StoreSquare<S>;
template <class StateView>
struct StoreNode {
  StateView state;
  template <class Found>
  PHYSGEN_FUNCTION void operator()(const Found& found) const {
    state[index_t{0}].f()[1] = static_cast<double>(found.index);
  }
};
template <class S>
StoreNode(S) -> StoreNode<S>;
template <class StateView>
struct IsAtRest {
  StateView state;
  double most;
  PHYSGEN_FUNCTION bool operator()() const { return double(state[index_t{0}].f()[0]) <= most; }
};
template <class S>
IsAtRest(S, double) -> IsAtRest<S>;

inline constexpr HaloUse halos[] = {
    {"springs::Pull", 0, "nodes", {.reads_own = true}},
    {"springs::Pull", 1, "x", {.reads_others = true}, "body.edges.nodes"},
    {"springs::Pull", 2, "f", {.writes_own = true}},
    {"springs::SumPulls", 0, "begin", {.reads_own = true}},
    {"springs::SumPulls", 0, "end", {.reads_own = true}},
    {"springs::SumPulls", 1, "element", {.reads_others = true}, "body.ranges.begin, body.ranges.end"},
    {"springs::SumPulls", 1, "local", {.reads_others = true}, "body.ranges.begin, body.ranges.end"},
    {"springs::SumPulls", 2, "f", {.reads_others = true}, "body.ends.element"},
    {"springs::SumPulls", 3, "f", {.writes_own = true}},
    {"springs::Move", 0, "f", {.reads_own = true}},
    {"springs::Move", 1, "x", {.reads_own = true, .writes_own = true}},
    {"springs::SquaredForce", 0, "f", {.reads_own = true}},
};

}  // namespace springs
