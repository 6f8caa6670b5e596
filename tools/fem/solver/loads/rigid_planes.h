// Contact with rigid frictionless planes: a node of the surface that is behind a plane by d > 0 has the energy
// k A d^2 / 2, k being a stiffness per area and A the node's share of the surface at rest. The force k A d along the
// normal is continuous; the stiffness k A n n^T begins where a node touches. A node that lies in a plane touches it, so
// that a plane holds a body that rests on it before anything has moved.
#pragma once

#include <fem/numerics/scalar.h>
#include <fem/solver/arrays/packed_rows.h>
#include <fem/solver/free_part.h>
#include <physgen/kernel.h>

namespace physgen::fem {

/// The load at which a state is evaluated. Where the load grows inside a linear solve, planes already lie where it
/// leads and the body does not: then those nodes touch that touched before.
struct AtLoad {
  double load;
  double touching;  ///< the load whose planes decide which nodes touch

  AtLoad(double both) : AtLoad(both, both) {}  // NOLINT(google-explicit-constructor): it is a load
  AtLoad(double now, double deciding) : load(now), touching(deciding) {}
};

/// The force and stiffness of a plane, or of all planes, at a node.
struct PlanePush {
  Vector3<double> force = Vector3<double>::Zero();  ///< [N]
  double energy = 0;                                ///< [J]
};

/// No plane.
struct NoPlanes {
  static constexpr bool push = false;
};

/// Planes and the surface that they push, for kernels.
template <class PlaneView, class AreaView>
struct RigidPlanes {
  static constexpr bool push = true;
  double stiffness;       ///< k [Pa/m]
  double load, touching;  ///< those of AtLoad
  PlaneView planes;       ///< contact::RigidPlane
  AreaView areas;         ///< contact::NodeArea

  /// The distance of a position behind a plane at a load [m]; below 0 in front of it.
  template <class Plane>
  PHYSGEN_FUNCTION static double depth(const Plane& plane, const Vector3<double>& x, double load) {
    const double offset = plane.offset(), travel = plane.travel();
    return offset + travel * load - dot3<double>(Vector3<double>(plane.normal().get()), x);
  }

  /// Whether a plane touches a node: one that lies in it or behind it, on the surface, and can move along the normal.
  template <class Constraint>
  PHYSGEN_FUNCTION bool touches(index_t plane, SingleObject auto node, const Vector3<double>& x,
                                const Constraint& constraint) const {
    if (!(double(areas[node].area()) > 0)) return false;
    const auto p = planes[plane];
    const Vector3<double> along = detail::free_part<double>(Vector3<double>(p.normal().get()), constraint);
    return dot3<double>(along, along) > 0 && depth(p, x, touching) >= 0;
  }

  /// The sum over all planes on a node.
  template <class Constraint>
  PHYSGEN_FUNCTION PlanePush on_node(SingleObject auto node, const Vector3<double>& x,
                                     const Constraint& constraint) const {
    PlanePush sum;
    for (index_t plane = 0; plane < planes.size(); ++plane) {
      if (!touches(plane, node, x, constraint)) continue;
      const double d = depth(planes[plane], x, load), force = stiffness * double(areas[node].area()) * d;
      sum.force += Vector3<double>(planes[plane].normal().get()) * force;
      sum.energy += 0.5 * force * d;
    }
    return sum;
  }

  /// d force / d x of a node: -k A n n^T of the planes that touch it.
  template <class Constraint>
  PHYSGEN_FUNCTION Matrix3<double> tangent(SingleObject auto node, const Vector3<double>& x,
                                           const Constraint& constraint) const {
    Matrix3<double> sum = Matrix3<double>::Zero();
    for (index_t plane = 0; plane < planes.size(); ++plane) {
      if (!touches(plane, node, x, constraint)) continue;
      const Vector3<double> n = planes[plane].normal();
      const double k = stiffness * double(areas[node].area());
      for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) sum(r, c) -= k * n[r] * n[c];
      }
    }
    return sum;
  }
};

/// The planes' part of the tangent, which is kept for coarser levels, joins the nodes' blocks.
template <class Planes, class PositionView, class ConstraintView, class PartView, class NodeStiffnessView>
struct AddPlaneStiffness {
  using Scalar = double;
  Planes planes;
  PositionView positions;       ///< elasticity::NodePosition
  ConstraintView constraints;   ///< quasistatic::NodeConstraint
  PartView part;                ///< elasticity::NodeStiffness, written
  NodeStiffnessView stiffness;  ///< elasticity::NodeStiffness

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Real = typename NodeStiffnessView::Precision;
    const Matrix3<double> own = planes.tangent(node, positions[node].x(), constraints[node]);
    const Matrix3<Real> K = own.template cast<Real>();
    part[node].K() = K;
    stiffness[node].K() = Matrix3<Real>(Matrix3<Real>(stiffness[node].K().get()) + K);
  }
};

/// The same for a coarser level, exactly as P^T C P has it: blocks of edges have their part of it from the finer nodes
/// (CoarsenEdgeStiffness), a coarse node's follows from its edges as if nothing resisted translations
/// (SumNodeStiffness), and what resists them is the sum over its children, C of each times its weight.
template <class Children, class FineView, class PartView, class NodeStiffnessView>
struct CoarsenPlaneStiffness {
  using Scalar = typename NodeStiffnessView::Precision;
  Children children;            ///< Rows of ChildEntry
  FineView fine;                ///< elasticity::NodeStiffness: the part that planes have of the finer level
  PartView part;                ///< elasticity::NodeStiffness, written
  NodeStiffnessView stiffness;  ///< elasticity::NodeStiffness

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Matrix = Matrix3<Scalar>;
    const Matrix sum = children.sum(node, Matrix(Matrix::Zero()), [&](const auto& entry) -> Matrix {
      const index_t child = ChildEntry::element(entry);
      const int parents = ChildEntry::local(entry);
      return Matrix(fine[child].K().get()) * (Scalar(0.5) * Scalar(parents));
    });
    part[node].K() = sum;
    stiffness[node].K() = Matrix(Matrix(stiffness[node].K().get()) + sum);
  }
};

/// The distance of a node behind the plane that touches it [m]; else 0.
template <class Planes, class PositionView, class ConstraintView>
struct PlaneDepth {
  using Scalar = double;
  index_t plane;
  Planes planes;
  PositionView positions;      ///< elasticity::NodePosition
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  PHYSGEN_FUNCTION double operator()(SingleObject auto node) const {
    const Vector3<double> x = positions[node].x();
    return planes.touches(plane, node, x, constraints[node]) ? planes.depth(planes.planes[plane], x, planes.load) : 0;
  }
};

/// The force of a plane on a node along the normal [N].
template <class Planes, class PositionView, class ConstraintView>
struct PlaneForce {
  using Scalar = double;
  index_t plane;
  Planes planes;
  PositionView positions;      ///< elasticity::NodePosition
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  PHYSGEN_FUNCTION double operator()(SingleObject auto node) const {
    return planes.stiffness * double(planes.areas[node].area()) *
           PlaneDepth{plane, planes, positions, constraints}(node);
  }
};

template <class ContactView>
struct StorePlaneDepth {
  ContactView contact;  ///< contact::PlaneContact
  PHYSGEN_FUNCTION void operator()(double depth) const { contact[index_t{0}].depth() = depth; }
};

template <class ContactView>
struct StorePlaneForce {
  ContactView contact;  ///< contact::PlaneContact
  PHYSGEN_FUNCTION void operator()(double force) const { contact[index_t{0}].force() = force; }
};

}  // namespace physgen::fem
