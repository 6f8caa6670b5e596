// Kernels: out of a start with inverted or flat tets. Such a start may lie in the valley of an equilibrium that is not
// the body's, as where a row of tets winds twice around an edge, and no method that descends leaves it. So Newton's
// method begins on the straight way from rest to the start, before the first tet is flat: what lies on it can be
// deformed into the rest shape without inverting a tet.
#pragma once

#include <fem/kernels/deformation_gradient.h>
#include <fem/solver/free_part.h>
#include <physgen/kernel.h>

namespace physgen::fem {

/// The part of the way from rest on which Newton's method begins, of that to the first flat tet.
inline constexpr double part_before_flat = 0.9;

namespace detail {

/// Rest, but prescribed components where they are.
template <class Constraint>
PHYSGEN_FUNCTION inline Vector3<double> anchor_of(const Vector3<double>& rest, const Vector3<double>& x,
                                                  const Constraint& constraint) {
  return x + free_part<double>(Vector3<double>(rest - x), constraint);
}

/// The smallest root in (0, 1] of 1 + a t + b t^2 + c t^3, from below; or 1.
PHYSGEN_FUNCTION inline double first_root(double a, double b, double c) {
  const auto value = [=](double t) { return 1 + t * (a + t * (b + t * c)); };
  // Between 0, the extrema and 1 the cubic rises or falls: extrema solve a + 2 b t + 3 c t^2 = 0.
  double ends[3] = {0, 0, 1};
  const double discriminant = b * b - 3 * a * c;
  if (discriminant > 0) {
    const double q = -(b + (b > 0 ? 1 : -1) * math::sqrt(discriminant));
    const double first = 3 * c != 0 ? q / (3 * c) : 1, second = q != 0 ? a / q : 1;
    const double lower = first < second ? first : second, upper = first < second ? second : first;
    if (lower > 0 && lower < 1) ends[0] = lower;
    ends[1] = upper > 0 && upper < 1 ? upper : ends[0];
  }
  double begin = 0;
  for (const double end : ends) {
    if (value(end) > 0) {
      begin = end;
      continue;
    }
    double low = begin, high = end;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (value(middle) > 0 ? low : high) = middle;
    }
    return low;
  }
  return 1;
}

}  // namespace detail

/// Returns how far on the straight way from rest to its position a tet goes before it is flat: a part in [0, 1]. A tet
/// whose prescribed components alone invert it counts as 1, since free ones cannot mend it.
template <class TetView, class RestView, class PositionView, class ConstraintView>
struct PartBeforeFlat {
  using Scalar = double;
  TetView tets;                ///< elasticity::Tet
  RestView rest;               ///< elasticity::NodePosition
  PositionView positions;      ///< elasticity::NodePosition
  ConstraintView constraints;  ///< quasistatic::NodeConstraint

  PHYSGEN_FUNCTION double operator()(SingleObject auto tet) const {
    const auto anchor = [this](index_t node) {
      return detail::anchor_of(rest[node].x(), positions[node].x(), constraints[node]);
    };
    const Matrix3<double> A = edges(tet, anchor);
    const Matrix3<double> B = edges(
        tet, [&](index_t node) { return Vector3<double>(Vector3<double>(positions[node].x().get()) - anchor(node)); });
    const double volume = determinant(A.col(0), A.col(1), A.col(2));
    if (!(volume > 0)) return 1;
    // det(A + t B) / det A
    const double a = determinant(B.col(0), A.col(1), A.col(2)) + determinant(A.col(0), B.col(1), A.col(2)) +
                     determinant(A.col(0), A.col(1), B.col(2));
    const double b = determinant(A.col(0), B.col(1), B.col(2)) + determinant(B.col(0), A.col(1), B.col(2)) +
                     determinant(B.col(0), B.col(1), A.col(2));
    return detail::first_root(a / volume, b / volume, determinant(B.col(0), B.col(1), B.col(2)) / volume);
  }

 private:
  template <class Vectors>
  PHYSGEN_FUNCTION Matrix3<double> edges(SingleObject auto tet, const Vectors& vectors) const {
    const auto nodes = tets[tet].nodes();
    const Vector3<double> origin = vectors(index_t{nodes[0]});
    Matrix3<double> result;
    for (int c = 0; c < 3; ++c) result.col(c) = Vector3<double>(vectors(index_t{nodes[c + 1]}) - origin);
    return result;
  }
  PHYSGEN_FUNCTION static double determinant(const Vector3<double>& a, const Vector3<double>& b,
                                             const Vector3<double>& c) {
    return dot3<double>(a, cross3<double>(b, c));
  }
};

/// Keeps the part, as the length of a step from rest.
template <class StateView>
struct StorePart {
  StateView state;  ///< quasistatic::LinearSolve
  PHYSGEN_FUNCTION void operator()(double part) const { state[index_t{0}].alpha() = part; }
};

/// Moves free components back to a part of their way from rest.
template <class RestView, class ConstraintView, class PositionView>
struct ReturnToPart {
  using Scalar = double;
  double part;
  RestView rest;               ///< elasticity::NodePosition
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  PositionView positions;      ///< elasticity::NodePosition

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    const Vector3<double> x = positions[node].x();
    const Vector3<double> anchor = detail::anchor_of(rest[node].x(), x, constraints[node]);
    positions[node].x() = Vector3<double>(anchor + Vector3<double>(x - anchor) * part);
  }
};

/// Moves positions back towards rest, until no tet is inverted or flat on the way.
/// @param v its number of a step's length is overwritten
template <class On, class Arrays, class Level, class Vectors>
void return_to_rest(On& on, Arrays& a, Level& level, Vectors& v) {
  on.reduce(a.tet_count(),
            PartBeforeFlat{a.tets.const_view(), a.rest.const_view(), a.positions.const_view(),
                           level.constraints.const_view()},
            Min{}, StorePart{v.state.view()});
  const double part = part_before_flat * on.value(v.state).alpha;
  on.run(a.nodes(), ReturnToPart{part, a.rest.const_view(), level.constraints.const_view(), a.positions.view()});
}

}  // namespace physgen::fem
