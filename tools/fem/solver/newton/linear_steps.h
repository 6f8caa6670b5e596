// Equilibrium of a linear elastic body as a program over an executor and arrays by name: the stiffness once, then one
// linear solve for each load.
#pragma once

#include <fem/solver/elastic/evaluate.h>
#include <fem/solver/elastic/linear_elastic.h>
#include <fem/solver/linear/conjugate_gradients.h>
#include <fem/solver/newton/newton_steps.h>

namespace physgen::fem {

/// Prescribed components go where the load takes them, free ones to rest: what is found does not depend on what was
/// before.
template <class MotionView, class ConstraintView, class DisplacementView>
struct BeginAtLoad {
  using Scalar = double;
  double load;
  MotionView motion;               ///< elasticity::NodeDisplacement, at a load of 1
  ConstraintView constraints;      ///< quasistatic::NodeConstraint
  DisplacementView displacements;  ///< elasticity::NodeDisplacement, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    const int fixed = constraints[node].fixed();
    for (int k = 0; k < 3; ++k) {
      displacements[node].dx()[k] = (fixed >> k & 1) != 0 ? double(motion[node].dx()[k]) * load : 0.0;
    }
  }
};

/// u += dx in free components.
template <class StepView, class ConstraintView, class DisplacementView>
struct AddLinearStep {
  using Scalar = double;
  StepView steps;                  ///< elasticity::NodeDisplacement: dx
  ConstraintView constraints;      ///< quasistatic::NodeConstraint
  DisplacementView displacements;  ///< elasticity::NodeDisplacement: u

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    const int fixed = constraints[node].fixed();
    for (int k = 0; k < 3; ++k) {
      if ((fixed >> k & 1) == 0) displacements[node].dx()[k] += double(steps[node].dx()[k]);
    }
  }
};

/// f = elastic and external forces. Returns |f|^2 over free and over prescribed components, and the load's potential.
template <class Force, class LoadView, class ConstraintView, class DisplacementView, class ForceView>
struct MeasureLinearForces {
  using Scalar = double;
  double load;
  Force force;                     ///< LinearForce at u
  LoadView loads;                  ///< elasticity::NodeForce, at a load of 1
  ConstraintView constraints;      ///< quasistatic::NodeConstraint
  DisplacementView displacements;  ///< elasticity::NodeDisplacement: u
  ForceView forces;                ///< elasticity::NodeForce, written

  PHYSGEN_FUNCTION Vector3<double> operator()(SingleObject auto node) const {
    using Vector = Vector3<double>;
    const Vector own = Vector(loads[node].f().get()) * load, u = displacements[node].dx();
    const Vector f = force(node) + own;
    forces[node].f() = f;
    const Vector free = detail::free_part<double>(f, constraints[node]), fixed = f - free;
    return Vector(dot3<double>(free, free), dot3<double>(fixed, fixed), -dot3<double>(own, u));
  }
};

/// The tets of each node.
template <class Body>
[[nodiscard]] auto node_tets_of(const Body& a) {
  return Rows(a.node_tet_ranges.const_view(), a.node_tets.const_view(), a.tets.size());
}

/// Forces on nodes at displacements u, in the precision Scalar. @param a the arrays of Linear in solver_groups.h
template <class Scalar, class Body, class DisplacementView>
[[nodiscard]] auto forces_of(const Body& a, const LameParameters& lame, const DisplacementView& u) {
  return linear_force<Scalar>(lame, a.tets.const_view(), a.rest.const_view(), node_tets_of(a), u);
}

/// Forces at a.displacements; energy and residual are left in a.state.
/// @param a the arrays of Linear in solver_groups.h. @param level whose constraints are its own
template <class On, class Body, class Level>
void evaluate_linear(On& on, Body& a, const Level& level, const LameParameters& lame, double load) {
  const auto u = a.displacements.const_view();
  const auto state = a.state.view();
  on.reduce(a.displacements.size(),
            MeasureLinearForces{load, forces_of<double>(a, lame, u), a.loads.const_view(),
                                level.constraints.const_view(), u, a.forces.view()},
            Sum{}, StoreForces{state});
  on.reduce(a.tets.size(), LinearEnergy{lame, a.tets.const_view(), a.rest.const_view(), u}, Sum{},
            StoreElasticEnergy{state, true});
}

/// Leaves prescribed components where a load takes them, and the forces there.
template <class On, class Body, class Level>
void begin_linear(On& on, Body& a, const Level& level, const LameParameters& lame, double load) {
  on.run(a.displacements.size(),
         BeginAtLoad{load, a.motion.const_view(), level.constraints.const_view(), a.displacements.view()});
  evaluate_linear(on, a, level, lame, load);
}

/// First Piola-Kirchhoff stress of all tets. @param stresses an array of elasticity::Stress in double, one per tet
template <class On, class Body, class Stresses>
void compute_linear_stresses(On& on, Body& a, const LameParameters& lame, Stresses& stresses) {
  on.run(a.tets.size(), ComputeLinearStress{lame, a.tets.const_view(), a.rest.const_view(),
                                            a.displacements.const_view(), stresses.view()});
}

/// Leaves the smallest current over rest volume of a tet in a.state.
template <class On, class Body>
void measure_smallest_ratio(On& on, Body& a) {
  on.reduce(a.tets.size(), DisplacedVolumeRatio{a.tets.const_view(), a.rest.const_view(), a.displacements.const_view()},
            Min{}, StoreSmallestRatio{a.state.view()});
}

/// Assembled stiffness and its preconditioner, which no load changes. @param levels LevelOver, finest first
template <class On, class Body, class Levels>
void prepare_linear(On& on, Body& a, Levels& levels, const LameParameters& lame,
                    const PreconditionerSettings& settings) {
  auto& level = *levels[0];
  on.run(level.edge_count(),
         SumLinearEdgeStiffness{lame, a.rest.const_view(),
                                Rows(a.edge_tet_ranges.const_view(), a.edge_tets.const_view(), a.tets.size()),
                                level.edge_stiffness.view()});
  on.run(level.nodes(), SumNodeStiffness{level.node_edges.const_view(), level.edge_stiffness.const_view(),
                                         level.node_stiffness.view()});
  prepare(on, levels, 0, settings, true);
}

/// Where nothing is assembled: the inverses of nodes' blocks.
template <class On, class Body, class Level>
void prepare_linear_nodes(On& on, Body& a, Level& level, const LameParameters& lame) {
  const index_t n = a.displacements.size();
  const auto blocks = level.node_stiffness.view();
  const auto scales = level.scales.view();
  on.run(n, SumLinearNodeStiffness{lame, a.rest.const_view(), node_tets_of(a), blocks});
  on.run(n, ComputeNodeScale{false, level.node_stiffness.const_view(), scales});
  on.run(n, ScaleNodes{level.node_stiffness.const_view(), level.constraints.const_view(), level.scales.const_view(),
                       blocks, level.inverse.view()});
}

/// The force left on free components, for a solve, and what a solve has found.
template <class On, class Body, class Level, class Vectors, class Solve>
void take_linear_step(On& on, Body& a, const Level& level, Vectors& v, const Solve& solve) {
  const auto constraints = level.constraints.const_view();
  const index_t n = a.displacements.size();
  on.run(n, BeginResidual{a.forces.const_view(), constraints, false, v.residual.view()});
  solve();
  on.run(n, AddLinearStep{v.step.const_view(), constraints, a.displacements.view()});
}

/// Solves for the forces that evaluate_linear() has left, without blocks of edges.
/// @param blocks whether the inverses of nodes' blocks precondition. @pre then prepare_linear_nodes()
template <class On, class Body, class Level, class Vectors>
void solve_linear_matrix_free(On& on, typename On::Loop& loop, Body& a, Level& level, Vectors& v,
                              const LameParameters& lame, bool blocks, double tolerance, int most_iterations) {
  using Real = typename decltype(v.step.view())::Precision;
  const index_t n = a.displacements.size();
  const auto product = v.product.view();
  const auto multiply = [&] {
    on.run(n, TurnDirectionAlone{v.state.const_view(), level.scales.const_view(), level.correction.const_view(),
                                 v.direction.view(), product});
    on.run(n, MultiplyLinear{forces_of<Real>(a, lame, v.direction.const_view()), product});
  };
  const auto precondition = [&] {
    if (blocks) {
      BlockJacobi::apply(on, level);
    } else {
      NoPreconditioner::apply(on, level);
    }
  };
  take_linear_step(on, a, level, v, [&] {
    conjugate_gradients(on, loop, level, v, tolerance, most_iterations, 0, multiply, precondition);
  });
}

/// The same with assembled stiffness. @pre prepare_linear()
template <class On, class Body, class Levels, class Vectors>
void solve_linear(On& on, typename On::Loop& loop, Body& a, Levels& levels, Vectors& v, const NewtonSettings& settings,
                  double tolerance) {
  take_linear_step(on, a, *levels[0], v, [&] {
    solve_assembled(on, loop, levels, 0, v, settings.preconditioner, tolerance, settings.most_iterations);
  });
}

}  // namespace physgen::fem
