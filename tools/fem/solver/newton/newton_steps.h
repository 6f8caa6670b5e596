// Kernels: steps of Newton's method over the nodes of a mesh, in double.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/scalar.h>
#include <fem/solver/elastic/corner_sums.h>
#include <fem/solver/free_part.h>
#include <fem/solver/loads/inertia.h>
#include <fem/solver/loads/rigid_planes.h>
#include <physgen/kernel.h>

namespace physgen::fem {

/// f = the load on the node + the forces of its tets: those of one chunk are added.
template <class NodeTets, class CornerView, class LoadView, class ForceView>
struct SumForces {
  using Scalar = typename ForceView::Precision;
  TetChunk chunk;      ///< whose tets are added; with the first, the load. Called with 0 .. chunk.nodes() - 1
  double load;         ///< what `loads` are multiplied by
  NodeTets node_tets;  ///< Rows of NodeTetEntry
  CornerView corners;  ///< elasticity::CornerForces of the chunk
  LoadView loads;      ///< elasticity::NodeForce
  ForceView forces;    ///< elasticity::NodeForce: begun with the first chunk

  PHYSGEN_FUNCTION void operator()(SingleObject auto i) const {
    using Vector = Vector3<Scalar>;
    const auto node = object_of_part(chunk.first_node, i);
    const Vector before =
        chunk.is_first() ? Vector(Vector(loads[node].f().get()) * load) : Vector(forces[node].f().get());
    const Vector f = detail::add_corners<Scalar>(chunk, node_tets, corners, node, before);
    forces[node].f() = f;
  }
};

/// f takes in what planes push the node with and inertia pulls it with. Returns |f|^2 over free components, and of the
/// forces that hold the body, those on prescribed components, of planes and of inertia; and the load's potential, -load
/// . (x - rest), with those of planes and inertia.
template <class LoadView, class ConstraintView, class RestView, class PositionView, class ForceView, class Planes,
          class Inertia>
struct MeasureForces {
  using Scalar = typename ForceView::Precision;
  double load;                 ///< what `loads` are multiplied by
  LoadView loads;              ///< elasticity::NodeForce
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  RestView rest;               ///< elasticity::NodePosition
  PositionView positions;      ///< elasticity::NodePosition
  ForceView forces;            ///< elasticity::NodeForce: planes' and inertia's are added
  Planes planes;               ///< RigidPlanes or NoPlanes
  Inertia inertia;             ///< Inertia or NoInertia

  PHYSGEN_FUNCTION Vector3<Scalar> operator()(SingleObject auto node) const {
    using Vector = Vector3<Scalar>;
    Vector f = forces[node].f(), more = Vector::Zero();  // more: what planes and inertia add to what is returned
    const Vector x = positions[node].x();
    if constexpr (Planes::push) {
      const PlanePush push = planes.on_node(node, x, constraints[node]);
      f += push.force;
      forces[node].f() = f;
      more = Vector(0, dot3<Scalar>(push.force, push.force), push.energy);
    }
    if constexpr (Inertia::pulls) {
      const InertiaPull pull = inertia.on_node(node, x);
      f += pull.force;
      forces[node].f() = f;
      more += Vector(0, dot3<Scalar>(pull.force, pull.force), pull.energy);
    }
    const Vector free = detail::free_part<Scalar>(f, constraints[node]);
    const Vector fixed = f - free;
    const Vector own = Vector(loads[node].f().get()) * load;
    const Vector moved = x - Vector(rest[node].x().get());
    return Vector(dot3<Scalar>(free, free), dot3<Scalar>(fixed, fixed), -dot3<Scalar>(own, moved)) + more;
  }
};

template <class StateView>
struct StoreForces {
  StateView state;  ///< quasistatic::Equilibrium
  PHYSGEN_FUNCTION void operator()(const Eigen::Matrix<double, 3, 1>& sums) const {
    const auto s = state[index_t{0}];
    s.free_square() = sums[0];
    s.fixed_square() = sums[1];
    s.loads() = sums[2];
  }
};

/// r = f in free components, in the precision of the linear solve, with what the prescribed increment adds: K d.
template <class ForceView, class ConstraintView, class ResidualView>
struct BeginResidual {
  using Scalar = double;
  ForceView forces;            ///< elasticity::NodeForce
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  bool has_increment;          ///< whether `residual` holds K d
  ResidualView residual;       ///< elasticity::NodeForceDifferential

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Real = typename ResidualView::Precision;
    using Vector = Eigen::Matrix<double, 3, 1>;
    Vector f = forces[node].f();
    if (has_increment) {
      for (int k = 0; k < 3; ++k) f[k] += static_cast<double>(Real(residual[node].df()[k]));
    }
    const Vector free = detail::free_part<double>(f, constraints[node]);
    for (int k = 0; k < 3; ++k) residual[node].df()[k] = static_cast<Real>(free[k]);
  }
};

/// The prescribed increment in the precision of the linear solve.
template <class IncrementView, class DirectionView>
struct CastIncrement {
  using Scalar = double;
  IncrementView increment;  ///< elasticity::NodeDisplacement, in double
  DirectionView direction;  ///< elasticity::NodeDisplacement, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Real = typename DirectionView::Precision;
    for (int k = 0; k < 3; ++k) direction[node].dx()[k] = static_cast<Real>(double(increment[node].dx()[k]));
  }
};

/// dx takes in the prescribed increment.
template <class IncrementView, class StepView>
struct AddIncrement {
  using Scalar = double;
  IncrementView increment;  ///< elasticity::NodeDisplacement, in double, 0 in free components
  StepView steps;           ///< elasticity::NodeDisplacement: dx

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Real = typename StepView::Precision;
    for (int k = 0; k < 3; ++k) steps[node].dx()[k] += static_cast<Real>(double(increment[node].dx()[k]));
  }
};

/// trial = x + length dx; where there is an increment, prescribed components take that part of it, so that after all of
/// it they are where they are prescribed, to the last bit. Returns f . dx, the work that the forces at x would do.
template <class PositionView, class ForceView, class StepView, class IncrementView, class ConstraintView,
          class TrialView>
struct Advance {
  using Scalar = double;
  double length;
  bool has_increment;
  PositionView positions;      ///< elasticity::NodePosition
  ForceView forces;            ///< elasticity::NodeForce: at x
  StepView steps;              ///< elasticity::NodeDisplacement: dx
  IncrementView increment;     ///< elasticity::NodeDisplacement, in double, 0 in free components
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  TrialView trial;             ///< elasticity::NodePosition, written

  PHYSGEN_FUNCTION double operator()(SingleObject auto node) const {
    using Vector = Eigen::Matrix<double, 3, 1>;
    using Real = typename StepView::Precision;
    const Vector x = positions[node].x(), f = forces[node].f();
    Vector dx;
    for (int k = 0; k < 3; ++k) dx[k] = static_cast<double>(Real(steps[node].dx()[k]));
    dx = detail::free_part<double>(dx, constraints[node]);
    Vector moved = x + dx * length;
    if (has_increment) moved += Vector(increment[node].dx().get()) * length;
    trial[node].x() = moved;
    return dot3<double>(f, dx);
  }
};

template <class StateView>
struct StoreWork {
  StateView state;  ///< quasistatic::Equilibrium
  PHYSGEN_FUNCTION void operator()(double work) const { state[index_t{0}].work() = work; }
};

template <class StateView>
struct StoreSmallestRatio {
  StateView state;  ///< quasistatic::Equilibrium
  PHYSGEN_FUNCTION void operator()(double ratio) const { state[index_t{0}].smallest_ratio() = ratio; }
};

/// The distance of prescribed components from where the load takes them: d = rest + load motion - x, 0 in free ones.
template <class RestView, class MotionView, class ConstraintView, class PositionView, class IncrementView>
struct ComputeIncrement {
  using Scalar = double;
  double load;
  RestView rest;               ///< elasticity::NodePosition
  MotionView motion;           ///< elasticity::NodeDisplacement of prescribed components, at a load of 1
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  PositionView positions;      ///< elasticity::NodePosition
  IncrementView increment;     ///< elasticity::NodeDisplacement, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Vector = Eigen::Matrix<double, 3, 1>;
    const Vector target = Vector(rest[node].x().get()) + Vector(motion[node].dx().get()) * load;
    const Vector d = target - Vector(positions[node].x().get());
    increment[node].dx() = Vector(d - detail::free_part<double>(d, constraints[node]));
  }
};

/// x += d
template <class IncrementView, class PositionView>
struct MovePrescribed {
  using Scalar = typename PositionView::Precision;
  IncrementView increment;  ///< elasticity::NodeDisplacement
  PositionView positions;   ///< elasticity::NodePosition
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    positions[i].x() += increment[i].dx().get();
  }
};

/// Copies positions.
template <class FromView, class ToView>
struct KeepPositions {
  using Scalar = typename ToView::Precision;
  FromView from;  ///< elasticity::NodePosition
  ToView to;      ///< elasticity::NodePosition, written
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    to[i].x() = from[i].x().get();
  }
};

/// Copies forces.
template <class FromView, class ToView>
struct KeepForces {
  using Scalar = typename ToView::Precision;
  FromView from;  ///< elasticity::NodeForce
  ToView to;      ///< elasticity::NodeForce, written
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    to[i].f() = from[i].f().get();
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
