// An implicit step of cloth (Baraff and Witkin 1998) as kernels: forces and their derivatives by springs, and conjugate
// gradients without a matrix, over the springs of each node.
#pragma once

#include <physgen/kernel.h>
#include <physgen/rows.h>
#include <sheet.physgen.h>

namespace sheet {

using namespace physgen;
using namespace physgen::math;

/// The force of a spring, and its derivative, less what makes it indefinite under compression.
template <class SpringView, class NodeView>
struct ComputeSprings {
  using Scalar = typename NodeView::Precision;
  SpringView springs;
  NodeView nodes;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Number = lanes_t<std::int32_t, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    using Matrix = Eigen::Matrix<S, 3, 3>;
    const auto ends = springs[i].ends();
    const Number a = ends[0], b = ends[1];
    const Vector edge = nodes[b].x().get() - nodes[a].x().get();
    const S length = sqrt(edge.squaredNorm()), rest = springs[i].length(), stiffness = springs[i].stiffness();
    const Vector d = edge / length;
    const S across = stiffness * max(S(1) - rest / length, S(0)), along = stiffness - across;
    springs[i].f() = Vector(d * S(stiffness * (length - rest)));
    springs[i].J() = Matrix(Matrix(d * d.transpose()) * along + Matrix(Matrix::Identity()) * across);
  }
};
template <class... Views>
ComputeSprings(Views...) -> ComputeSprings<Views...>;

/// Residual of dv = 0: h (f - h J v), of free nodes. Returns its square.
template <class TouchRows, class SpringView, class NodeView, class SearchView>
struct BeginSearch {
  using Scalar = typename NodeView::Precision;
  TouchRows touches;
  SpringView springs;
  NodeView nodes;
  SearchView search;
  Scalar step, gravity;

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using S = lanes_t<Scalar, I>;
    using Number = lanes_t<std::int32_t, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const Vector v = nodes[i].v();
    const S m = nodes[i].m(), free = nodes[i].free(), h = S(step);
    Vector force = touches.sum(i, Vector(Vector::Constant(S(0))), [&](const auto& touch) -> Vector {
      const Number k = touch.spring();
      const auto ends = springs[k].ends();
      const Number first = ends[0], second = ends[1], other = first + second - numbers(i);
      const Vector f = springs[k].f(), dv = v - nodes[other].v().get();
      const Eigen::Matrix<S, 3, 3> J = springs[k].J();
      return f * select(first == numbers(i), S(1), S(-1)) - Vector(J * dv) * h;
    });
    force[2] += m * S(gravity);
    const Vector r = force * S(h * free);
    search[i].dv() = Vector(Vector::Constant(S(0)));
    search[i].r() = r;
    search[i].p() = r;
    return r.squaredNorm();
  }
};
template <class TouchRows, class SpringView, class NodeView, class SearchView, class Real>
BeginSearch(TouchRows, SpringView, NodeView, SearchView, Real, Real)
    -> BeginSearch<TouchRows, SpringView, NodeView, SearchView>;

/// q = (M + h^2 J) p, of free nodes. Returns p . q.
template <class TouchRows, class SpringView, class NodeView, class SearchView>
struct Multiply {
  using Scalar = typename NodeView::Precision;
  TouchRows touches;
  SpringView springs;
  NodeView nodes;
  SearchView search;
  Scalar step;

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using S = lanes_t<Scalar, I>;
    using Number = lanes_t<std::int32_t, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const Vector p = search[i].p();
    const S m = nodes[i].m(), free = nodes[i].free(), square = S(step * step);
    const Vector sum = touches.sum(i, Vector(Vector::Constant(S(0))), [&](const auto& touch) -> Vector {
      const Number k = touch.spring();
      const auto ends = springs[k].ends();
      const Number first = ends[0], second = ends[1], other = first + second - numbers(i);
      const Eigen::Matrix<S, 3, 3> J = springs[k].J();
      const Vector dp = p - search[other].p().get();
      return J * dp;
    });
    const Vector q = (p * m + sum * square) * free;
    search[i].q() = q;
    return p.dot(q);
  }
};
template <class TouchRows, class SpringView, class NodeView, class SearchView, class Real>
Multiply(TouchRows, SpringView, NodeView, SearchView, Real) -> Multiply<TouchRows, SpringView, NodeView, SearchView>;

/// A step along p. Returns the square of the residual.
template <class SearchView>
struct Step {
  using Scalar = typename SearchView::Precision;
  SearchView search;
  Scalar alpha;

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using S = lanes_t<Scalar, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const Vector p = search[i].p(), q = search[i].q(), dv = search[i].dv(), old = search[i].r();
    const Vector r = old - q * S(alpha);
    search[i].dv() = Vector(dv + p * S(alpha));
    search[i].r() = r;
    return r.squaredNorm();
  }
};
template <class View, class Real>
Step(View, Real) -> Step<View>;

/// The next direction.
template <class SearchView>
struct Turn {
  using Scalar = typename SearchView::Precision;
  SearchView search;
  Scalar beta;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const Vector p = search[i].p(), r = search[i].r();
    search[i].p() = Vector(r + p * S(beta));
  }
};
template <class View, class Real>
Turn(View, Real) -> Turn<View>;

/// The end of a time step.
template <class NodeView, class SearchView>
struct Move {
  using Scalar = typename NodeView::Precision;
  NodeView nodes;
  SearchView search;
  Scalar step;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const Vector v = nodes[i].v().get() + search[i].dv().get();
    const Vector x = nodes[i].x();
    nodes[i].v() = v;
    nodes[i].x() = Vector(x + v * S(step));
  }
};
template <class NodeView, class SearchView, class Real>
Move(NodeView, SearchView, Real) -> Move<NodeView, SearchView>;

}  // namespace sheet
