// Kernels: elastic forces of each tet on its corners, G = -V P Dm^-T, and their sums at the nodes. The sums are gathers
// over rows of tets in a fixed order: no atomics, and the same bits on every run. Kernels that gather blocks of
// elements take one object at a time: packs of them, which collect lane by lane, were measured at three to nine times
// the time.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/scalar.h>
#include <physgen/rows.h>

namespace physgen::fem {

namespace detail {

/// -volume P Dm^-T
template <class S>
PHYSGEN_FUNCTION inline Matrix3<S> corner_forces(const Matrix3<S>& P, const Matrix3<S>& dm_inverse, const S& volume) {
  const Matrix3<S> scaled = P * (-volume);
  return multiply_transpose<S>(scaled, dm_inverse);
}

/// Sum over the tets of a node of the force on it: column c - 1 of G at corner c > 0, minus all columns at corner 0.
template <class Scalar, class NodeTets, class ForceView>
PHYSGEN_FUNCTION inline Vector3<Scalar> gather_corners(const NodeTets& node_tets, const ForceView& forces,
                                                       SingleObject auto node) {
  Vector3<Scalar> sum = Vector3<Scalar>::Zero();
  node_tets.for_each(node, [&](const auto& incidence, bool /*active*/) {
    const auto tet = forces[index_t{incidence.element()}];
    const int corner = incidence.local();
    if (corner == 0) {
      const Matrix3<Scalar> all = tet.G();
      sum -= all.col(0) + all.col(1) + all.col(2);
    } else {
      const auto G = tet.G();
      const int first = 3 * (corner - 1);
      sum += Vector3<Scalar>(G[first], G[first + 1], G[first + 2]);
    }
  });
  return sum;
}

}  // namespace detail

/// G = -volume P Dm^-T [N], for corners j, k, l; the force on i is minus their sum.
template <class RestView, class StressView, class CornerView>
struct ComputeCornerForces {
  using Scalar = typename CornerView::Precision;
  RestView rest;      ///< elasticity::RestShape
  StressView stress;  ///< elasticity::Stress
  CornerView forces;  ///< elasticity::CornerForces, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const auto shape = rest[i];
    const Matrix3<S> P = stress[i].P(), dm_inverse = shape.dm_inverse();
    const S volume = shape.volume();
    forces[i].G() = detail::corner_forces<S>(P, dm_inverse, volume);
  }
};

/// f(node) = sum over its tets.
template <class NodeTets, class CornerView, class NodeView>
struct GatherForces {
  using Scalar = typename NodeView::Precision;
  NodeTets node_tets;  ///< Rows of elasticity::Incidence: tet, corner
  CornerView forces;   ///< elasticity::CornerForces of each tet
  NodeView nodes;      ///< elasticity::NodeForce, written

  /// Throws an Error when there is not a row for each node, or rows do not name these tets.
  bool has_rows = (node_tets.require("GatherForces: node_tets", nodes.size(), forces.size()), true);

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    nodes[node].f() = detail::gather_corners<Scalar>(node_tets, forces, node);
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
