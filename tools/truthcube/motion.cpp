#include "motion.h"

#include <fem/dynamics/explicit.h>
#include <fem/solver/solvers/scene_solvers.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "arrays.h"
#include "estimates.h"
#include "interrupts.h"
#include "suspect.h"

namespace physgen::truthcube {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int most_halved_steps = 6;     // of a time step for which there is no equilibrium
constexpr int steps_between_looks = 32;  // whether an explicit motion is finite: a look takes as long as a step

fem::DynamicSettings settings_of(const Options& options) {
  return {options.solver, options.motion.density, options.motion.damping, options.motion.fixed_order};
}

bool is_explicit(const Options& options) { return options.scene == SceneKind::explicit_dynamics; }

/// The longest time step [s]. @throw Error when what is asked for is not stable
double longest_step(const Options& options, const Scene& scene) {
  const MotionOptions& motion = options.motion;
  if (!is_explicit(options)) return motion.time_step > 0 ? motion.time_step : motion.duration / 100;
  const double stable = fem::stable_time_step(scene.levels.front(), settings_of(options));
  if (motion.time_step <= stable) return motion.time_step > 0 ? motion.time_step : stable / 2;
  std::array<char, 200> text{};
  std::snprintf(
      text.data(), text.size(),
      "--time-step %g: explicit steps of this body at rest are stable up to about %.3g s, and compressed tets need "
      "shorter ones; take a shorter step, or choose --scene implicit-dynamics",
      motion.time_step, 0.995 * stable);  // which is refused in no rounding
  throw Error(text.data());
}

/// The sums over the time steps of a state.
struct Effort {
  int steps = 0, newton = 0, iterations = 0;
  double residual = 0;
  fem::NewtonStatus status = fem::NewtonStatus::converged;
};

/// A time step, in halves where there is no equilibrium at its end.
void advance(const Options& options, fem::DynamicSolver& solver, double length, int halved_steps, Effort& effort) {
  const MotionOptions& motion = options.motion;
  const double load = compression_at(solver.time() + length, motion.duration, options.compressions.back());
  const fem::NewtonResult result = solver.step(length, load);
  effort.newton += result.steps;
  effort.iterations += result.iterations;
  effort.residual = result.residual;
  effort.status = result.status;
  if (result.status == fem::NewtonStatus::converged) {
    ++effort.steps;
  } else if (halved_steps < most_halved_steps) {
    advance(options, solver, length / 2, halved_steps + 1, effort);
    if (effort.status == fem::NewtonStatus::converged) advance(options, solver, length / 2, halved_steps + 1, effort);
  }
}

}  // namespace

double compression_at(double time, double duration, double compression) {
  const double part = std::clamp(2 * time / duration, 0.0, 1.0);
  return compression * part * part * part * (10 - part * (15 - 6 * part));
}

std::unique_ptr<fem::DynamicSolver> make_dynamic_solver(const Options& options, const Scene& scene, RanksOfRun& ranks) {
  (void)longest_step(options, scene);
  if (ranks.are_several()) return ranks.make_motion(options, scene.levels, scene.loading, settings_of(options));
  if (is_explicit(options)) {
    return fem::make_explicit_solver(scene.levels.front(), scene.loading, settings_of(options));
  }
  return arrays_of(options) == "everything"
             ? fem::make_implicit_solver(scene.levels, scene.loading, settings_of(options))
             : fem::make_scene_implicit_solver(scene.levels, scene.loading, settings_of(options));
}

Outcome run_motion(const Options& options, const Scene& scene, fem::DynamicSolver& solver, RunFiles& files,
                   RunRecord& record, const Terminal& terminal, const RanksOfRun& ranks) {
  const Interrupts interrupts;
  const MotionOptions& motion = options.motion;
  const double interval = motion.duration / motion.frames;
  const auto steps = static_cast<long long>(std::ceil(interval / longest_step(options, scene) * (1 - 1e-12)));
  const double length = interval / static_cast<double>(steps);
  terminal.line("%d states of %lld time steps of %.4g s each", motion.frames, steps, length);
  terminal.text(
      "      time  compression     kinetic     elastic    reaction   steps  Newton     PCG  smallest J   seconds");
  SuspectTet before;  // of the last state
  int states_inverted = 0;
  for (int frame = 1; frame <= motion.frames; ++frame) {
    const auto begin = Clock::now();
    Effort effort;
    bool finite = true;
    bool is_interrupted = false;
    for (long long k = 1; k <= steps && finite && effort.status == fem::NewtonStatus::converged && !is_interrupted;
         ++k) {
      advance(options, solver, length, 0, effort);
      if (is_explicit(options) && k % steps_between_looks == 0) finite = solver.measure().is_finite();
      is_interrupted = ranks.any(interrupted != 0);
    }
    if (is_interrupted) {
      terminal.line("interrupted; %zu states are %s", record.steps.size(), files.writes() ? "written" : "done");
      return Outcome::interrupted;
    }
    const fem::MotionMeasure measure = solver.measure();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    const std::unique_ptr<BodyState> state = ranks.state_of(solver);
    const auto contacts = solver.plane_contacts();
    const SuspectTet suspect = find_suspect(scene.levels.front(), *state, options.window);
    if (!measure.is_finite() || ranks.any(!suspect.is_finite)) {
      terminal.error("truthcube: the motion is not finite at %g s, time step %lld of this state: %s.", solver.time(),
                     static_cast<long long>(effort.steps), describe(suspect, scene).c_str());
      if (frame > 1) terminal.error("In the state before, %s.", describe(before, scene).c_str());
      terminal.error(
          "A time step of %.3g s is too long for tets that are compressed. Try --time-step %.2g, or --scene "
          "implicit-dynamics.",
          length, length / 2);
      return Outcome::not_converged;
    }
    if (effort.status != fem::NewtonStatus::converged) {
      terminal.error(
          "truthcube: no equilibrium with inertia was found after %g s: time steps were halved down to %.3g s, and %d "
          "Newton steps ended with a residual of %.2e. There, %s.\nTry a shorter --time-step, --precision double, or "
          "more --cells.",
          solver.time(), length / (1 << most_halved_steps), effort.newton, effort.residual,
          describe(suspect, scene).c_str());
      return Outcome::not_converged;
    }
    const double compression = compression_at(solver.time(), motion.duration, options.compressions.back());
    const double reaction = plate_reaction(state->forces(0, scene.plates.upper.nodes.front()), contacts);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    record.steps.push_back({compression,
                            effort.newton,
                            effort.iterations,
                            effort.residual,
                            measure.elastic,
                            suspect.J,
                            reaction,
                            none,
                            none,
                            reach_past_plates(scene, compression, *state, options.window),
                            seconds,
                            none,
                            solver.time(),
                            measure.kinetic,
                            {}});
    terminal.line("  %8.4g     %8.5f  %10.4e  %10.4e  %10.4g  %6d  %6d  %6d    %8.4f  %8.3f%s", solver.time(),
                  compression, measure.kinetic, measure.elastic, reaction, effort.steps, effort.newton,
                  effort.iterations, suspect.J, seconds, suspect.inverted > 0 ? "  inverted" : "");
    if (suspect.inverted > 0 && states_inverted++ == 0) {
      terminal.warning(
          "at %.4g s, %s. No real body is in such a state. Try a shorter --time-step, a longer --duration, more "
          "--cells, "
          "or a smaller --compress.",
          solver.time(), describe(suspect, scene).c_str());
    }
    before = suspect;
    if (!files.writes()) continue;
    ranks.count(record);
    files.write_step(record, solver.time(), *state);
  }
  if (states_inverted > 0) {
    terminal.warning("%d of %d states have inverted tets.", states_inverted, motion.frames);
  }
  return Outcome::done;
}

}  // namespace physgen::truthcube
