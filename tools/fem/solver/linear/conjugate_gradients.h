// Preconditioned conjugate gradients over the stiffness of one level, as a program over an executor: on CUDA nothing in
// it waits for the host.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/solver/levels/vector_steps.h>
#include <fem/solver/linear/residual_norms.h>
#include <fem/solver/linear/tangent_product.h>
#include <fem/solver/preconditioners/all.h>

namespace physgen::fem {

/// Sets the tolerance on the device.
template <class StateView>
struct SetTolerance {
  using Scalar = double;
  StateView state;  ///< quasistatic::LinearSolve
  double tolerance;
  PHYSGEN_FUNCTION void operator()(SingleObject auto /*i*/) const { state[index_t{0}].tolerance() = tolerance; }
};

/// Begins with dx = 0.
template <class StepView>
struct ClearStep {
  using Scalar = typename StepView::Precision;
  StepView steps;  ///< elasticity::NodeDisplacement, written
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    steps[i].dx() = Vector3<S>(Vector3<S>::Constant(S(Scalar(0))));
  }
};

/// Solves K dx = -f to sqrt(r . z) <= tolerance times its first value.
/// @param loop of this level, these vectors, `multiply`, and `residual_length`, which it is recorded with
/// @param level LevelOver, or arrays of its names: in scaled unknowns the preconditioner's r and z
/// @param v the arrays of Krylov in solver_groups.h; its residual holds f, 0 in prescribed components; on return dx,
/// and the recurrence's residual
/// @param residual_length where it is above 0: solves to |r| <= this [N] in place of the tolerance
/// @param multiply turns v.direction p and leaves K p in v.product
/// @param precondition leaves z = M r in level.correction; level.residual is used up
template <class On, class Level, class Vectors, class Multiply, class Precondition>
void conjugate_gradients(On& on, typename On::Loop& loop, Level& level, Vectors& v, double tolerance,
                         int most_iterations, double residual_length, const Multiply& multiply,
                         const Precondition& precondition) {
  const index_t n = level.scales.size();
  const auto state = v.state.view();
  const auto scales = level.scales.const_view();
  const auto scaled = level.residual.view();
  const auto step = v.step.view();
  const auto residual = v.residual.view();
  const auto direction = v.direction.view();
  const auto z = level.correction.const_view();
  const auto p = v.direction.const_view();
  const auto r = v.residual.const_view();
  const auto q = v.product.const_view();

  on.run(1, SetTolerance{state, tolerance});
  on.run(n, ClearStep{step});
  on.run(n, ClearStep{direction});
  on.run(n, ScaleResidual{scales, r, scaled});
  precondition();
  on.reduce(n, ResidualNorm{scales, r, z}, Sum{}, SetFirstNorm{state});
  on.repeat(
      loop, most_iterations,
      [&] {
        multiply();
        on.reduce(n, Curvature{p, q}, Sum{}, SetLength{state});
        on.run(n, TakeStep{v.state.const_view(), level.constraints.const_view(), scales, p, q, step, residual, scaled});
        precondition();
        if (residual_length > 0) {
          on.reduce(n, ResidualNorms{scales, r, z}, Sum{}, SetNextNorms{state, residual_length});
        } else {
          on.reduce(n, ResidualNorm{scales, r, z}, Sum{}, SetNextNorm{state});
        }
      },
      HasEnded{v.state.const_view()});
}

/// The same with the assembled stiffness of level `top`. @pre prepare() has been called for it
template <class On, class Levels, class Vectors>
void solve_assembled(On& on, typename On::Loop& loop, Levels& levels, std::size_t top, Vectors& v,
                     const PreconditionerSettings& settings, double tolerance, int most_iterations,
                     double residual_length = 0) {
  auto& level = *levels[top];
  const auto product = v.product.view();
  const auto multiply = [&] {
    on.run(level.nodes(), TurnDirection{v.state.const_view(), level.scales.const_view(), level.correction.const_view(),
                                        level.node_stiffness.const_view(), v.direction.view(), product});
    add_edges(on,
              SymmetricProduct{level.node_stiffness.const_view(), level.edge_stiffness.const_view(),
                               level.edges.const_view(), v.direction.const_view(), product},
              level.sums);
  };
  conjugate_gradients(on, loop, level, v, tolerance, most_iterations, residual_length, multiply,
                      [&] { precondition(on, levels, top, settings); });
}

/// The same with the stiffness of level `top` as it is: assembled, or the tangents in `a`.
/// @pre prepare() has been called for this level and its stiffness, or prepare_nodes()
template <class On, class Arrays, class Levels, class Vectors>
void solve(On& on, typename On::Loop& loop, Arrays& a, Levels& levels, std::size_t top, Vectors& v,
           const PreconditionerSettings& settings, double tolerance, int most_iterations, double residual_length = 0) {
  auto& level = *levels[top];
  using Choices = typename std::remove_cvref_t<decltype(level)>::Choices;
  if constexpr (Choices::assembled) {
    if (level.assembled) {
      return solve_assembled(on, loop, levels, top, v, settings, tolerance, most_iterations, residual_length);
    }
  }
  if constexpr (Choices::matrix_free) {
    const auto product = v.product.view();
    const auto multiply = [&] {
      on.run(level.nodes(), TurnDirectionAlone{v.state.const_view(), level.scales.const_view(),
                                               level.correction.const_view(), v.direction.view(), product});
      add_tangents(on, a, v.direction.const_view(), product);
    };
    conjugate_gradients(on, loop, level, v, tolerance, most_iterations, residual_length, multiply,
                        [&] { precondition(on, levels, top, settings); });
  }
}

/// Waits for a solve. The status is still `running` where the iterations did not suffice.
template <class On, class Vectors>
[[nodiscard]] LinearResult linear_result(On& on, const Vectors& v) {
  const auto state = on.value(v.state);
  return {int{state.iterations}, static_cast<LinearStatus>(int{state.status}),
          state.rz_first > 0 ? std::sqrt(std::max(state.rz, 0.0) / state.rz_first) : 0.0};
}

}  // namespace physgen::fem

#pragma pop_macro("I")
