// Equilibrium of a linear elastic body as a program over an executor and arrays by name: the stiffness once, then one
// linear solve for each load.
#pragma once

#include <fem/solver/conjugate_gradients.h>
#include <fem/solver/evaluate.h>
#include <fem/solver/linear_body.h>
#include <fem/solver/newton_steps.h>

namespace physgen::fem {

/// Prescribed components go where the load takes them.
template <class MotionView, class ConstraintView, class DisplacementView>
struct PrescribeDisplacements {
  using Scalar = double;
  double load;
  MotionView motion;               ///< elasticity::NodeDisplacement, at a load of 1
  ConstraintView constraints;      ///< quasistatic::NodeConstraint
  DisplacementView displacements;  ///< elasticity::NodeDisplacement

  PHYSGEN_FUNCTION void operator()(index_t node) const {
    const int fixed = constraints[node].fixed();
    for (int k = 0; k < 3; ++k) {
      if ((fixed >> k & 1) != 0) displacements[node].dx()[k] = double(motion[node].dx()[k]) * load;
    }
  }
};
template <class... Views>
PrescribeDisplacements(double, Views...) -> PrescribeDisplacements<Views...>;

/// u += dx in free components.
template <class StepView, class ConstraintView, class DisplacementView>
struct AddLinearStep {
  using Scalar = double;
  StepView steps;                  ///< elasticity::NodeDisplacement: dx
  ConstraintView constraints;      ///< quasistatic::NodeConstraint
  DisplacementView displacements;  ///< elasticity::NodeDisplacement: u

  PHYSGEN_FUNCTION void operator()(index_t node) const {
    const int fixed = constraints[node].fixed();
    for (int k = 0; k < 3; ++k) {
      if ((fixed >> k & 1) == 0) displacements[node].dx()[k] += double(steps[node].dx()[k]);
    }
  }
};
template <class... Views>
AddLinearStep(Views...) -> AddLinearStep<Views...>;

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

  PHYSGEN_FUNCTION Vector3<double> operator()(index_t node) const {
    using Vector = Vector3<double>;
    const Vector own = Vector(loads[node].f().get()) * load, u = displacements[node].dx();
    const Vector f = force(node) + own;
    forces[node].f() = f;
    const Vector free = detail::free_part<double>(f, constraints[node]), fixed = f - free;
    return Vector(dot3<double>(free, free), dot3<double>(fixed, fixed), -dot3<double>(own, u));
  }
};
template <class... Arguments>
MeasureLinearForces(double, Arguments...) -> MeasureLinearForces<Arguments...>;

/// Energy and forces at a.displacements.
template <class On, class Body, class Level>
auto evaluate_linear(On& on, Body& a, const Level& level, double load) {
  const auto u = a.displacements.const_view();
  const auto tets = a.tets.const_view();
  const auto rest = a.rest.const_view();
  const auto state = a.state.view();
  on.reduce(a.nodes(),
            MeasureLinearForces{load, linear_force<double>(a.lame, tets, rest, a.node_tets.const_view(), u),
                                a.loads.const_view(), level.constraints.const_view(), u, a.forces.view()},
            Sum{}, StoreForces{state});
  on.reduce(a.tets.size(), LinearEnergy{a.lame, tets, rest, u}, Sum{}, AddElastic{state, true});
  return on.value(a.state);
}

/// Stiffness and preconditioner, which no load changes.
template <class On, class Body, class Levels>
void prepare_linear(On& on, Body& a, Levels& levels, const PreconditionerSettings& settings) {
  auto& level = *levels[0];
  if (!level.assembled) return prepare_nodes(on, a, level, settings);
  on.run(level.edge_count(),
         SumLinearEdgeStiffness{a.lame, a.rest.const_view(), a.edge_tets.const_view(), level.edge_stiffness.view()});
  on.run(level.nodes(), SumNodeStiffness{level.node_edges.const_view(), level.edge_stiffness.const_view(),
                                         level.node_stiffness.view()});
  prepare(on, levels, 0, settings, true);
}

/// One linear solve for the forces that evaluate_linear() has left.
/// @pre prepare_linear()
template <class On, class Body, class Levels, class Vectors>
LinearResult solve_linear(On& on, typename On::Loop& loop, Body& a, Levels& levels, Vectors& v,
                          const NewtonSettings& settings, double tolerance) {
  const auto constraints = levels[0]->constraints.const_view();
  on.run(a.nodes(), BeginResidual{a.forces.const_view(), constraints, false, v.residual.view()});
  solve(on, loop, a, levels, 0, v, settings.preconditioner, tolerance, settings.most_iterations);
  on.run(a.nodes(), AddLinearStep{v.step.const_view(), constraints, a.displacements.view()});
  return linear_result(on, v);
}

}  // namespace physgen::fem
