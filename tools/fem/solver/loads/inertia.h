// Inertia and damping of a time step of backward Euler, as an energy of the positions x at its end: m/(2 dt^2) |x -
// xh|^2 with xh = x_n + dt v_n, and for the damping force -d m v also d m/(2 dt) |x - x_n|^2. Their sum is c/2 |x -
// y|^2 and a constant, with c = m (1/dt^2 + d/dt) and y = x_n + dt v_n / (1 + d dt): one more spring on each node.
#pragma once

#include <fem/numerics/scalar.h>
#include <fem/solver/free_part.h>
#include <physgen/kernel.h>

namespace physgen::fem {

/// The force and stiffness of inertia at a node.
struct InertiaPull {
  Vector3<double> force = Vector3<double>::Zero();  ///< [N]
  double energy = 0;                                ///< [J]
};

/// No inertia: statics.
struct NoInertia {
  static constexpr bool pulls = false;
};

/// Inertia of a time step, for kernels.
template <class MassView, class CentreView>
struct Inertia {
  static constexpr bool pulls = true;
  double per_mass;     ///< c / m [1/s^2]
  MassView masses;     ///< dynamics::NodeMass
  CentreView centres;  ///< elasticity::NodePosition: y

  PHYSGEN_FUNCTION InertiaPull on_node(SingleObject auto node, const Vector3<double>& x) const {
    const double c = per_mass * double(masses[node].mass());
    const Vector3<double> away = x - Vector3<double>(centres[node].x().get());
    return {away * -c, 0.5 * c * dot3<double>(away, away)};
  }
};

/// K(node) -= c. On coarser levels m is the sum over a node's children, each times its weight: that is P^T C P, whose
/// blocks of edges come from the finer nodes' blocks (CoarsenEdgeStiffness), and those of nodes from these edges, as if
/// nothing resisted translations (SumNodeStiffness).
template <class MassView, class NodeStiffnessView>
struct AddInertiaStiffness {
  using Scalar = double;
  double per_mass;              ///< c / m [1/s^2]
  MassView masses;              ///< dynamics::NodeMass, of the level
  NodeStiffnessView stiffness;  ///< elasticity::NodeStiffness

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Real = typename NodeStiffnessView::Precision;
    Matrix3<Real> K = stiffness[node].K();
    const auto c = static_cast<Real>(per_mass * double(masses[node].mass()));
    for (int k = 0; k < 3; ++k) K(k, k) -= c;
    stiffness[node].K() = K;
  }
};

/// T takes in what inertia adds to the nodes' blocks, for levels of a background grid.
template <class ConstraintView, class MassView, class TranslationView>
struct AddInertiaTranslations {
  using Scalar = double;
  double per_mass;               ///< c / m [1/s^2]
  ConstraintView constraints;    ///< quasistatic::NodeConstraint
  MassView masses;               ///< dynamics::NodeMass
  TranslationView translations;  ///< quasistatic::TranslationStiffness

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Real = typename TranslationView::Precision;
    const int fixed = constraints[node].fixed();
    const auto c = static_cast<Real>(per_mass * double(masses[node].mass()));
    Matrix3<Real> T = translations[node].T();
    for (int k = 0; k < 3; ++k) {
      if ((fixed >> k & 1) == 0) T(k, k) -= c;
    }
    translations[node].T() = T;
  }
};

/// y, and where Newton's method begins: free components at y, prescribed ones where they are.
template <class PositionView, class VelocityView, class ConstraintView, class CentreView, class StartView>
struct PredictPositions {
  using Scalar = double;
  double length;               ///< of the step [s]
  double damping;              ///< [1/s]
  PositionView positions;      ///< elasticity::NodePosition: x_n
  VelocityView velocities;     ///< dynamics::NodeVelocity: v_n
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  CentreView centres;          ///< elasticity::NodePosition: y, written
  StartView start;             ///< elasticity::NodePosition, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    const Vector3<double> x = positions[node].x(), v = velocities[node].v();
    const Vector3<double> way = v * (length / (1 + damping * length));
    centres[node].x() = Vector3<double>(x + way);
    start[node].x() = Vector3<double>(x + detail::free_part<double>(way, constraints[node]));
  }
};

/// v = (x - x_n) / dt
template <class PositionView, class BeforeView, class VelocityView>
struct UpdateVelocities {
  using Scalar = double;
  double length;            ///< of the step [s]
  PositionView positions;   ///< elasticity::NodePosition: x
  BeforeView before;        ///< elasticity::NodePosition: x_n
  VelocityView velocities;  ///< dynamics::NodeVelocity, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    const Vector3<double> way = Vector3<double>(positions[node].x().get()) - Vector3<double>(before[node].x().get());
    velocities[node].v() = Vector3<double>(way / length);
  }
};

}  // namespace physgen::fem
