// Newton's method for the equilibrium of one mesh: steps in the precision of the tangent, states in double, so that
// Newton's method itself is the refinement.
#pragma once

#include <fem/solver/elastic/mean_pressures.h>
#include <fem/solver/linear/conjugate_gradients.h>
#include <fem/solver/newton/evaluate_state.h>
#include <fem/solver/newton/line_search.h>
#include <fem/solver/newton/newton_steps.h>
#include <fem/solver/newton/return_to_rest.h>

#include <chrono>
#include <cmath>
#include <functional>

namespace physgen::fem {

/// The stiffness of a level at the arrays' positions. @pre they are those of the last evaluate_state()
/// @param load of pressures that follow the surface; a tangent that is filtered is one without them
template <class On, class Arrays, class Level, class Evaluate>
void assemble(On& on, Arrays& a, Level& level, Evaluate& evaluator, TangentFilter filter, double load = 0) {
  const auto edges = level.edge_stiffness.view();
  for (const TetChunk& chunk : a.chunks) {
    evaluator.evaluate_tangents(on, a, chunk, filter);
    const auto sum = [&](const auto& patches) {
      on.run(chunk.edges(),
             SumEdgeStiffness{chunk, a.edge_tets.const_view(), patches, a.chunk_arrays->tangent.const_view(), edges});
    };
    const auto sum_with = [&](auto& p) { sum(EdgePatchTangents{p.edge_patches.const_view(), p.tangent.const_view()}); };
    if (!where(a.patches, sum_with)) sum(NoEdgePatches{});
  }
  where(a.rings, [&](auto& rings) {
    on.run(level.edge_count(), AddNodeVolumeStiffness{level.edges.const_view(), rings.nodes.const_view(),
                                                      rings.tangent.const_view(), edges});
  });
  where(a.surface, [&](auto& surface) {
    if (filter != TangentFilter::none) return;
    on.run(level.edge_count(), AddPressureStiffness{load, surface.edge_faces.const_view(), level.edges.const_view(),
                                                    surface.faces.const_view(), a.positions.const_view(), edges});
  });
  on.run(level.nodes(), SumNodeStiffness{level.node_edges.const_view(), level.edge_stiffness.const_view(),
                                         level.node_stiffness.view()});
}

/// df = K dx of the level's tangent, assembled or by tets.
template <class On, class Arrays, class Level, class DisplacementView, class DifferentialView>
void multiply_tangent(On& on, Arrays& a, Level& level, const DisplacementView& dx, const DifferentialView& df) {
  if constexpr (Level::Choices::assembled) {
    if (level.assembled) {
      return multiply(on,
                      SymmetricProduct{level.node_stiffness.const_view(), level.edge_stiffness.const_view(),
                                       level.edges.const_view(), dx, df},
                      level.sums);
    }
  }
  if constexpr (Level::Choices::matrix_free) {
    on.run(a.nodes(), ClearDifferentials{df});
    add_tangents(on, a, dx, df);
  }
}

/// The tangent at the arrays' positions: assembled, or by tets. @pre they are those of the last evaluate_state()
template <class On, class Arrays, class Level, class Evaluate>
void form_tangent(On& on, Arrays& a, Level& level, Evaluate& evaluator, TangentFilter filter, const AtLoad& at) {
  if (!level.assembled) return evaluator.evaluate_tangents(on, a, a.all_tets(), filter);
  if constexpr (Level::Choices::assembled) {
    assemble(on, a, level, evaluator, filter, at.load);
    const auto stiffness = level.node_stiffness.view();
    where(level.planes, [&](auto& planes) {
      on.run(a.nodes(), AddPlaneStiffness{planes.at(at), a.positions.const_view(), level.constraints.const_view(),
                                          planes.stiffness.view(), stiffness});
    });
    where(level.inertia, [&](auto& inertia) {
      on.run(a.nodes(), AddInertiaStiffness{inertia.per_mass, inertia.masses.const_view(), stiffness});
    });
  }
}

/// The preconditioner of that tangent. @param fresh whether power iterations begin anew
template <class On, class Arrays, class Levels>
void prepare_tangent(On& on, Arrays& a, Levels& levels, std::size_t top, const PreconditionerSettings& settings,
                     bool fresh) {
  using Choices = typename std::remove_cvref_t<decltype(*levels[top])>::Choices;
  if constexpr (Choices::assembled) {
    if (levels[top]->assembled) return prepare(on, levels, top, settings, fresh);
  }
  if constexpr (Choices::matrix_free) prepare_nodes(on, a, *levels[top], settings);
}

/// Forms the tangent at the arrays' positions, and solves for the step; a.increment is taken in where there is one.
template <class On, class Arrays, class Levels, class Vectors, class Evaluate>
LinearResult solve_step(On& on, typename On::Loop& loop, Arrays& a, Levels& levels, std::size_t top, Vectors& v,
                        Evaluate& evaluator, TangentFilter filter, const NewtonSettings& settings, const AtLoad& at,
                        bool has_increment, bool fresh, double forcing) {
  auto& level = *levels[top];
  form_tangent(on, a, level, evaluator, filter, at);
  if (has_increment) {
    on.run(a.nodes(), CastIncrement{a.increment.const_view(), v.direction.view()});
    multiply_tangent(on, a, level, v.direction.const_view(), v.residual.view());
  }
  on.run(a.nodes(),
         BeginResidual{a.forces.const_view(), level.constraints.const_view(), has_increment, v.residual.view()});
  prepare_tangent(on, a, levels, top, settings.preconditioner, fresh);
  solve(on, loop, a, levels, top, v, settings.preconditioner, forcing, settings.most_iterations);
  return linear_result(on, v);
}

/// Seeks the equilibrium of level `top` at a load, from a.positions, and leaves it there. Where prescribed components
/// are not yet where the load takes them (a.increment), the first linear solve moves them.
/// @param restart whether linearised pressures begin anew, at those of the forces; else they are kept
/// @param report called after every step
template <class On, class Arrays, class Levels, class Vectors, class Evaluate>
NewtonResult find_equilibrium(On& on, typename On::Loop& loop, Arrays& a, Levels& levels, std::size_t top, Vectors& v,
                              Evaluate& evaluator, const NewtonSettings& settings, double load, bool has_increment,
                              bool restart, const std::function<void(const NewtonStep&)>& report) {
  using Clock = std::chrono::steady_clock;
  auto& level = *levels[top];
  const index_t n = a.nodes();
  NewtonResult result;
  const auto positions = a.positions.view();
  const auto forces = a.forces.view();

  AtLoad at(load, has_increment ? settings.start_load : load);
  auto state = evaluate_state(on, a, level, evaluator, a.positions.const_view(), forces, at, restart);
  const auto begin_nearer_to_rest = [&] {
    ++result.returns;
    return_to_rest(on, a, level, v);
    state = evaluate_state(on, a, level, evaluator, a.positions.const_view(), forces, at, true);
  };
  if (settings.start_is_given && !(state.smallest_ratio > 0)) begin_nearer_to_rest();
  // The error left by a coarser mesh's equilibrium lies where F changes most, and no linear solve takes all of it away.
  double before = free_force(state),
         forcing = settings.is_interpolated ? settings.most_forcing : settings.least_forcing;
  Risk risk;
  bool fresh = true;
  // Forces are measured against those on prescribed components, now or at the last equilibrium: they may vanish.
  const auto scale_of = [&](const auto& s) { return std::max(std::sqrt(s.fixed_square), settings.last_reaction); };
  const auto residual_of = [&](const auto& s) {
    const double scale = scale_of(s);
    return scale > 0 ? free_force(s) / scale : (free_force(s) > 0 ? 1.0 : 0.0);
  };
  const double start_free = before;
  const auto has_converged = [&](const auto& s) {
    const double free = free_force(s);
    if (settings.absolute_tolerance > 0) return free <= settings.absolute_tolerance;
    if (residual_of(s) <= settings.tolerance) return true;
    // Where nothing holds the body: against the forces at the beginning. And rounding is all that is left where a step
    // has not lessened it.
    if (scale_of(s) == 0 && free <= std::max(1e-10 * start_free, settings.rounding_force)) return true;
    return free <= settings.rounding_force && (free <= 0.01 * settings.rounding_force || free > 0.1 * before);
  };
  const auto finish = [&](NewtonStatus status) {
    result.status = status;
    result.residual = residual_of(state);
    result.energy = energy_of(state);
    result.smallest_J = state.smallest_ratio;
    result.reaction = std::sqrt(state.fixed_square);
    return result;
  };
  if (!std::isfinite(energy_of(state)) || !std::isfinite(before)) return finish(NewtonStatus::not_finite);

  for (;;) {
    if (!has_increment && has_converged(state)) {
      const bool inverted = !(state.smallest_ratio > 0) && state.fixed_square == 0;
      if (!inverted || result.returns == settings.most_returns) return finish(NewtonStatus::converged);
      // Nothing pulls, and yet tets are flat or inverted: a saddle, or another minimum.
      begin_nearer_to_rest();
      before = free_force(state);
      fresh = true;
    }
    if (result.steps == settings.most_steps) return finish(NewtonStatus::too_many_steps);
    const auto start = Clock::now();
    NewtonStep step;
    step.number = ++result.steps;
    LinearResult linear;
    if (settings.all_prescribed) {
      on.run(n, ClearStep{v.step.view()});
      linear = {0, LinearStatus::converged, 0};
    } else {
      linear = solve_step(on, loop, a, levels, top, v, evaluator, TangentFilter::none, settings, at, has_increment,
                          fresh, forcing);
    }
    fresh = false;
    step.iterations = linear.iterations;
    const auto has_no_step = [&](const LinearResult& r) {
      // Forces of rounding alone need no step; their squares may be 0 in the solve's precision.
      return r.status == LinearStatus::not_finite || (r.iterations == 0 && !(before <= settings.rounding_force));
    };
    const auto has_failed = [&](const LinearResult& r) {
      return r.status == LinearStatus::negative_curvature || has_no_step(r);
    };
    // Where the energy is not convex: once more with a tangent that is.
    const auto solve_filtered = [&] {
      (void)evaluate_state(on, a, level, evaluator, a.positions.const_view(), forces, at, false);
      linear = solve_step(on, loop, a, levels, top, v, evaluator, TangentFilter::absolute, settings, at, has_increment,
                          true, forcing);
      step.filtered = true;
      step.iterations += linear.iterations;
      return !has_no_step(linear);
    };
    if (!settings.all_prescribed && has_failed(linear)) (void)solve_filtered();
    if (!settings.all_prescribed && has_no_step(linear)) {
      return finish(NewtonStatus::linear_solver);
    }
    if (has_increment) on.run(n, AddIncrement{a.increment.const_view(), v.step.view()});

    const NewtonStatus found =
        search_along_step(on, a, level, v, evaluator, settings, load, has_increment, state, risk, step, solve_filtered);
    if (found != NewtonStatus::converged) return finish(found);
    result.halvings += step.halvings;
    result.filtered += step.filtered ? 1 : 0;
    result.iterations += step.iterations;
    on.run(n, KeepPositions{a.trial.const_view(), positions});
    on.run(n, KeepForces{a.trial_forces.const_view(), forces});
    const double free = free_force(state);
    forcing = has_increment ? settings.least_forcing
                            : std::max(settings.least_forcing,
                                       std::min(settings.most_forcing, 0.9 * (free / before) * (free / before)));
    // The last step goes a little below the tolerance, and no further. Conjugate gradients measure in another norm.
    if (settings.absolute_tolerance == 0 && residual_of(state) > settings.tolerance) {
      forcing = std::max(forcing, 0.02 * settings.tolerance / residual_of(state));
    }
    before = free;
    // Where the step was shortened, the next takes what is left of the increment.
    has_increment = has_increment && step.halvings > 0;
    if (has_increment) {
      on.run(n, ComputeIncrement{load, a.rest.const_view(), a.motion.const_view(), level.constraints.const_view(),
                                 positions, a.increment.view()});
    } else {
      at = load;
    }
    step.residual = residual_of(state);
    step.energy = energy_of(state);
    step.smallest_J = state.smallest_ratio;
    step.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (report) report(step);
  }
}

}  // namespace physgen::fem
