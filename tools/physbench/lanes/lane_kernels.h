// Kernels on which the choice of lanes is measured, of the kinds that programs have: streams, stencils, gathers by
// numbers, rows of small and of large records. Kernels of finite elements that the project has come from tools/fem.
#pragma once

#include <lane_objects.physgen.h>
#include <physgen/kernel.h>
#include <physgen/rows.h>

#include <Eigen/Geometry>

namespace physgen::lane_kernels {

using namespace physgen::math;

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;

/// rho = sum of m W(|x - x_j|) over neighbours.
template <class NeighbourRows, class ParticleView, class Real>
struct Density {
  using Scalar = Real;
  NeighbourRows neighbours;
  ParticleView particles;
  Real radius2, factor;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Vector3<S> x = particles[i].x();
    particles[i].rho() = neighbours.sum(i, S(0), [&](const auto& entry) -> S {
      const lanes_t<std::int32_t, I> j = entry.other();
      const Vector3<S> d = x - particles[j].x().get();
      const S w = max(S(radius2) - d.squaredNorm(), S(0));
      return S(particles[j].m()) * S(factor) * w * w * w;
    });
  }
};

/// Forces of pressure and viscosity.
template <class NeighbourRows, class ParticleView, class Real>
struct ParticleForces {
  using Scalar = Real;
  NeighbourRows neighbours;
  ParticleView particles;
  Real radius, viscosity;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Vector3<S> x = particles[i].x(), v = particles[i].v();
    const S p = particles[i].p();
    particles[i].f() = neighbours.sum(i, Vector3<S>(Vector3<S>::Constant(S(0))), [&](const auto& entry) -> Vector3<S> {
      const lanes_t<std::int32_t, I> j = entry.other();
      const Vector3<S> d = x - particles[j].x().get(), u = particles[j].v().get() - v;
      const S r = sqrt(d.squaredNorm()) + S(Real(1e-6)), w = max(S(radius) - r, S(0));
      const S volume = S(particles[j].m()) / S(particles[j].rho());
      return d * S(volume * (p + S(particles[j].p())) * w * w / r) + u * S(S(viscosity) * volume * w);
    });
  }
};

/// q = sum over springs of J (p_j - p), and the term p . q of a dot product.
template <class SpringRows, class SpringView, class DirectionView>
struct SpringProduct {
  using Scalar = typename DirectionView::Precision;
  SpringRows touching;
  SpringView springs;
  DirectionView directions;

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Number = lanes_t<std::int32_t, I>;
    const Vector3<S> p = directions[i].p();
    const Vector3<S> q = touching.sum(i, p, [&](const auto& entry) -> Vector3<S> {
      const Number spring = entry.other();
      const auto ends = springs[spring].ends();
      const Number first = ends[0], second = ends[1];
      const Number other = first + second - numbers(i);
      const Vector3<S> d = directions[other].p().get() - p;
      const Eigen::Matrix<S, 3, 3> J = springs[spring].J();
      return J * d;
    });
    directions[i].q() = q;
    return S(p.dot(q));
  }
};

/// Forces of springs on nodes, gathered.
template <class SpringRows, class SpringView, class NodeView>
struct SpringForces {
  using Scalar = typename NodeView::Precision;
  SpringRows touching;
  SpringView springs;
  NodeView nodes;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Number = lanes_t<std::int32_t, I>;
    const Vector3<S> x = nodes[i].x(), v = nodes[i].v();
    nodes[i].f() = touching.sum(i, Vector3<S>(Vector3<S>::Constant(S(0))), [&](const auto& entry) -> Vector3<S> {
      const Number spring = entry.other();
      const auto ends = springs[spring].ends();
      const Number first = ends[0], second = ends[1];
      const Number other = first + second - numbers(i);
      const Vector3<S> d = nodes[other].x().get() - x, u = nodes[other].v().get() - v;
      const S length = sqrt(d.squaredNorm());
      const S pull = S(springs[spring].stiffness()) * (length - S(springs[spring].length())) / length;
      return d * pull + u * S(springs[spring].damping());
    });
  }
};

/// Forces of springs, added at both ends.
template <class SpringView, class NodeView>
struct AddSpringForces {
  using Scalar = typename NodeView::Precision;
  SpringView springs;
  NodeView nodes;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Number = lanes_t<std::int32_t, I>;
    const auto ends = springs[i].ends();
    const Number a = ends[0], b = ends[1];
    const Vector3<S> d = nodes[b].x().get() - nodes[a].x().get();
    const S length = sqrt(d.squaredNorm());
    const S pull = S(springs[i].stiffness()) * (length - S(springs[i].length())) / length;
    add(i, nodes[a].f(), Vector3<S>(d * pull));
    add(i, nodes[b].f(), Vector3<S>(-d * pull));
  }
};

/// J of springs from their ends: gathers two nodes, writes a record.
template <class SpringView, class NodeView>
struct SpringJacobians {
  using Scalar = typename NodeView::Precision;
  SpringView springs;
  NodeView nodes;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Number = lanes_t<std::int32_t, I>;
    const auto ends = springs[i].ends();
    const Number a = ends[0], b = ends[1];
    const Vector3<S> d = nodes[b].x().get() - nodes[a].x().get();
    const S inverse = S(1) / sqrt(d.squaredNorm());
    const Vector3<S> n = d * inverse;
    const S k = springs[i].stiffness(), ratio = S(springs[i].length()) * inverse;
    Eigen::Matrix<S, 3, 3> J;
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r) J(r, c) = k * ratio * n[r] * n[c] + (r == c ? k * (S(1) - ratio) : S(0));
    }
    springs[i].J() = J;
  }
};

/// Volumes of hexahedra from 8 gathered corners, as three tripple products of diagonals.
template <class HexahedronView, class NodeView>
struct HexahedronVolume {
  using Scalar = typename NodeView::Precision;
  HexahedronView hexahedra;
  NodeView nodes;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const auto corners = hexahedra[i].nodes();
    const auto x = [&](int c) -> Vector3<S> {
      const lanes_t<std::int32_t, I> node = corners[c];
      return nodes[node].x();
    };
    const Vector3<S> x0 = x(0), x1 = x(1), x2 = x(2), x3 = x(3), x4 = x(4), x5 = x(5), x6 = x(6), x7 = x(7);
    const Vector3<S> d = x6 - x0, a = x1 - x0, b = x2 - x5, c = x3 - x0, e = x4 - x0, f = x7 - x2, g = x6 - x3;
    hexahedra[i].volume() = (d.dot(a.cross(b)) + d.dot(c.cross(f)) + d.dot(e.cross(g))) * S(Scalar(1.0 / 6));
  }
};

/// Forces on nodes from forces on the corners of hexahedra: a gather of small records.
template <class CornerRows, class ForceView, class NodeView>
struct GatherCornerForces {
  using Scalar = typename NodeView::Precision;
  CornerRows corners;
  ForceView forces;
  NodeView nodes;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    nodes[i].f() = corners.sum(i, Vector3<S>(Vector3<S>::Constant(S(0))), [&](const auto& entry) -> Vector3<S> {
      const lanes_t<std::int32_t, I> corner = entry.other();
      return forces[corner].f().get();
    });
  }
};

/// A sparse matrix times a vector, row by row.
template <class MatrixRows, class CellView>
struct SparseProduct {
  using Scalar = typename CellView::Precision;
  MatrixRows matrix;
  CellView cells;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    cells[i].next() = matrix.sum(i, S(0), [&](const auto& entry) -> S {
      const lanes_t<std::int32_t, I> column = entry.column();
      return S(entry.value()) * S(cells[column].u());
    });
  }
};

/// Five points of a grid of `width` columns.
template <class CellView, class Real>
struct Stencil {
  using Scalar = Real;
  CellView cells;
  Real rate;
  std::int32_t width, last;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Number = lanes_t<std::int32_t, I>;
    const Number at = numbers(i), zero = Number(0), end = Number(last);
    const S u = cells[i].u();
    const S west = cells[max(at - 1, zero)].u(), east = cells[min(at + 1, end)].u();
    const S south = cells[max(at - width, zero)].u(), north = cells[min(at + width, end)].u();
    cells[i].next() = u + S(rate) * (west + east + south + north - S(4) * u);
  }
};

/// x += dt v, v += dt f: a stream.
template <class NodeView, class Real>
struct Advance {
  using Scalar = Real;
  NodeView nodes;
  Real dt;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Vector3<S> v = nodes[i].v().get() + nodes[i].f().get() * S(dt);
    nodes[i].v() = v;
    nodes[i].x() += v * S(dt);
  }
};

/// The term of a dot product: a reduction.
template <class DirectionView>
struct Dot {
  using Scalar = typename DirectionView::Precision;
  DirectionView directions;

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const {
    using Vector = Vector3<lanes_t<Scalar, I>>;
    const Vector p = directions[i].p(), q = directions[i].q();
    return lanes_t<Scalar, I>(p.dot(q));
  }
};

/// Of cells alone: an expensive function.
template <class CellView>
struct Potential {
  using Scalar = typename CellView::Precision;
  CellView cells;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const S u = cells[i].u();
    cells[i].next() = exp(-u * u) * log(S(1) + u * u);
  }
};

}  // namespace physgen::lane_kernels
