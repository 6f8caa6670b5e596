#include "steps.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <ranges>
#include <set>
#include <string>
#include <utility>

#include "estimates.h"
#include "grading.h"
#include "interrupts.h"
#include "suspect.h"

namespace physgen::truthcube {

using fem::Point;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Thrown out of a solve by Ctrl-C.
struct Interrupt {};

/// "0.05, 0.125" of a table that names compressions, ascending; of many the first five.
std::string compressions_of(const BeadTable& table) {
  std::set<double> found;
  for (const BeadRow& row : table.rows) found.insert(row.compression.value_or(0));
  constexpr std::size_t most = 5;
  std::string text;
  for (const double compression : found | std::views::take(most)) {
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), "%g", compression);
    text += (text.empty() ? "" : ", ") + std::string(number.data());
  }
  return text + (found.size() > most ? ", ..." : "");
}

}  // namespace

const char* reason(fem::NewtonStatus status) {
  switch (status) {
    case fem::NewtonStatus::too_many_steps:
      return "Newton's method took too many steps";
    case fem::NewtonStatus::no_descent:
      return "no step along Newton's direction lowers the energy";
    case fem::NewtonStatus::not_finite:
      return "the energy or a force is not finite";
    case fem::NewtonStatus::linear_solver:
      return "conjugate gradients found no direction: the tangent is not definite, or not finite";
    case fem::NewtonStatus::converged:
      break;
  }
  return "";
}

/// Watches the Newton steps of one solve, whose load may be bisected: what the last increment of the load came to
/// that found its equilibrium.
class LastEquilibrium {
 public:
  explicit LastEquilibrium(const fem::EquilibriumSolver& solver) : solver_(solver), load_(solver.load()) {}

  void see(std::size_t level, const fem::NewtonStep& step) {
    look();
    newton_.push_back(
        {static_cast<int>(level), step.iterations, step.residual, step.energy, step.smallest_J, step.seconds});
    if (level > 0) return;
    now_.steps += 1;
    now_.iterations += step.iterations;
    now_.residual = step.residual;
    now_.energy = step.energy;
    now_.smallest_J = step.smallest_J;
  }

  /// The result of solver.load(); nothing where that is the load at the beginning.
  [[nodiscard]] const std::optional<fem::NewtonResult>& result() {
    look();
    return last_;
  }

  /// Every Newton step up to that equilibrium.
  [[nodiscard]] std::vector<NewtonRecord> newton() {
    look();
    return {newton_.begin(), newton_.begin() + static_cast<std::ptrdiff_t>(last_count_)};
  }

 private:
  void look() {
    if (solver_.load() == load_) return;
    load_ = solver_.load();
    last_ = now_;
    last_count_ = newton_.size();
  }

  const fem::EquilibriumSolver& solver_;
  double load_;
  fem::NewtonResult now_;
  std::optional<fem::NewtonResult> last_;
  std::vector<NewtonRecord> newton_;
  std::size_t last_count_ = 0;  // of newton_, up to last_
};

MeasuredBeads::MeasuredBeads(const std::filesystem::path& file, const fem::MeshLevel& level)
    : table(read_bead_table(file)), locations(locate_beads(table, level.rest, level.mesh)) {}

Outcome Steps::run(const std::vector<double>& compressions, int repetitions) {
  const Interrupts interrupts;
  const std::size_t steps_before = record_.steps.size();
  const fem::SolverState beginning = repetitions > 0 ? solver_.state() : fem::SolverState();
  for (const double compression : compressions) {
    if (compression <= solver_.load()) continue;
    if (ranks_.any(interrupted != 0)) return stop();
    terminal_.line("compression %g", compression);
    terminal_.newton_header();
    const auto begin = Clock::now();
    LastEquilibrium last(solver_);
    fem::NewtonResult result;
    try {
      result = solver_.solve_to(compression, [&](std::size_t level, const fem::NewtonStep& step) {
        last.see(level, step);
        terminal_.newton_step(level, step);
        if (ranks_.any(interrupted != 0)) throw Interrupt{};
      });
    } catch (const Interrupt&) {
      return stop();
    }
    const double seconds = seconds_since(begin);
    if (result.status != fem::NewtonStatus::converged) return fail(compression, result, last, seconds);
    finish(compression, result, seconds, last.newton());
  }
  if (repetitions > 0) return repeat(beginning, std::span(record_.steps).subspan(steps_before), repetitions);
  return Outcome::done;
}

Outcome Steps::repeat(const fem::SolverState& beginning, std::span<StepRecord> steps, int repetitions) {
  for (StepRecord& step : steps) step.warm_seconds = std::numeric_limits<double>::infinity();
  for (int k = 0; k < repetitions; ++k) {
    solver_.restore(beginning);
    for (StepRecord& step : steps) {
      const auto begin = Clock::now();
      (void)solver_.solve_to(step.compression, {});
      step.warm_seconds = std::min(step.warm_seconds, seconds_since(begin));
      if (ranks_.any(interrupted != 0)) return stop();
    }
  }
  for (const StepRecord& step : steps) {
    terminal_.line("compression %g, repeated %d times: %.4f s at best, %.4f s the first time", step.compression,
                   repetitions, step.warm_seconds, step.seconds);
  }
  if (files_.writes()) files_.write_record(record_);
  return Outcome::done;
}

Outcome Steps::stop() const {
  terminal_.line("interrupted; %zu steps are %s", record_.steps.size(), files_.writes() ? "written" : "done");
  return Outcome::interrupted;
}

void Steps::finish(double compression, const fem::NewtonResult& result, double seconds,
                   std::vector<NewtonRecord> newton) {
  // All ranks go through all of this; what they do not get is neither printed nor written.
  const std::unique_ptr<BodyState> of_solver = ranks_.state_of(solver_);
  BodyState& state = *of_solver;
  const std::vector<fem::PlaneContact> contacts = solver_.plane_contacts();
  const double reaction = plate_reaction(state.forces(0, scene_.plates.upper.nodes.front()), contacts);
  const double reach = reach_past_plates(scene_, compression, state, window_);
  Estimates estimates;
  if (state.coarser_contacts()) {
    estimates = make_estimates(scene_.levels, scene_.plates.upper.nodes[1], reaction, state,
                               order_of_errors(scene_.grading), window_);
  }
  record_.steps.push_back({compression, result.steps, result.iterations, result.residual, result.energy,
                           result.smallest_J, reaction, estimates.reaction, estimates.error_rms, reach, seconds,
                           std::numeric_limits<double>::quiet_NaN(), 0, 0, std::move(newton)});
  const std::string coarse = result.coarse_steps == 0
                                 ? ""
                                 : ", " + std::to_string(result.coarse_steps) + " and " +
                                       std::to_string(result.coarse_iterations) + " on coarser meshes";
  terminal_.line("  solved in %.3f s: %d %s and %d PCG iterations%s; reaction %.6g N", seconds, result.steps,
                 words_.what.c_str(), result.iterations, coarse.c_str(), reaction);
  if (std::isfinite(estimates.reaction)) {
    terminal_.line(
        "  estimated from half as many cells: displacements are off by %.4f mm RMS, %.4f mm at most; reaction of an "
        "ever finer mesh %.6g N",
        1e3 * estimates.error_rms, 1e3 * estimates.error_max, estimates.reaction);
  }
  if (!contacts.empty() && contacts.front().force + contacts.back().force > 0) {
    terminal_.line(
        "  free sides reach %.4f mm past the plates; the lower one pushes them back with %.4g N, the upper one with "
        "%.4g N",
        1e3 * reach, contacts.front().force, contacts.back().force);
  } else if (reach > 1e-6 * scene_.plates.height()) {
    terminal_.line("  free sides reach %.3f mm past the plates: --plates contact pushes them back", 1e3 * reach);
  }
  warn(compression, result, state);
  compare(compression, state);
  if (!files_.writes()) return;
  ranks_.count(record_);
  files_.write_step(record_, compression, state);
  files_.write_checkpoint(record_, state);
}

void Steps::warn(double compression, const fem::NewtonResult& result, BodyState& state) const {
  if (tolerance_ > 0 && result.residual > tolerance_) {
    terminal_.warning(
        "at a compression of %g, rounding ended the solve at a residual of %.2e, above the tolerance of %.2e: "
        "the result is less accurate than was asked for. Try a larger --compress or --tolerance.",
        compression, result.residual, tolerance_);
  }
  if (result.smallest_J > 0) return;
  // Sides that fold past a plate turn cells over that are narrower than the fold.
  const char* remedies = scene_.grading > 1
                             ? "--plates contact, a smaller --grading, or more and smaller --compress steps"
                             : "more and smaller --compress steps, more --cells, or --plates contact";
  terminal_.warning("at a compression of %g, %s. A real body has no such equilibrium. Try %s.", compression,
                    describe(find_suspect(scene_.levels.front(), state, window_), scene_).c_str(), remedies);
}

Outcome Steps::fail(double compression, const fem::NewtonResult& result, LastEquilibrium& last, double seconds) {
  const double reached = solver_.load();
  if (const std::optional<fem::NewtonResult>& found = last.result(); found.has_value()) {
    terminal_.line("compression %g, on the way", reached);
    finish(reached, *found, seconds, last.newton());
  }
  terminal_.error(
      "truthcube: no equilibrium at a compression of %g: %s, after %d %s, with a residual of %.2e; the last "
      "equilibrium is at %g.",
      compression, reason(result.status), result.steps, words_.what.c_str(), result.residual, reached);
  const SuspectTet suspect = find_suspect(scene_.levels.front(), *ranks_.state_of(solver_), window_);
  terminal_.error("There, %s.", describe(suspect, scene_).c_str());
  terminal_.error("Try %s.", words_.remedies.c_str());
  return Outcome::not_converged;
}

void Steps::compare(double compression, BodyState& state) const {
  if (!beads_) return;
  const BeadTable& table = beads_->table;
  const fem::MeshLevel& level = scene_.levels.front();
  const std::vector<Point> corners = state.positions(0, corners_of(beads_->locations, level.mesh));
  if (!state.is_here()) return;
  const auto errors =
      compare_beads(table, compression, interpolate_displacements(beads_->locations, level.mesh, level.rest, corners));
  if (!errors) {
    terminal_.line("  %s has no beads at a compression of %g, only at %s", table.file.c_str(), compression,
                   compressions_of(table).c_str());
    return;
  }
  if (!table.rows.front().compression) {
    terminal_.line("  %s has no column compression, so its beads are compared with every step", table.file.c_str());
  }
  terminal_.line("  %zu beads of %s: difference [mm] mean %.4f, RMS %.4f, 95 %% below %.4f, max %.4f", errors->beads,
                 table.file.c_str(), errors->mean, errors->rms, errors->p95, errors->max);
}

}  // namespace physgen::truthcube
