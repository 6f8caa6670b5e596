#include "case_run.h"

#include <fem/solver/loads/pressed_faces.h>
#include <fem/solver/solvers/scene_solvers.h>
#include <physgen/error.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "arrays.h"
#include "case_state_of.h"
#include "interrupts.h"
#include "memory.h"
#include "mesh_order.h"
#include "needed_memory.h"
#include "output/case_tables.h"
#include "output/folder_lock.h"
#include "output/hash.h"
#include "output/run_json.h"
#include "parse.h"
#include "run_files.h"
#include "scene.h"
#include "settings_json.h"
#include "steps.h"
#include "suspect.h"
#include "terminal.h"
#include "timings.h"
#include "viewers_file.h"

namespace physgen::truthcube {

namespace {

using Clock = std::chrono::steady_clock;
using fem::Point;

struct Interrupt {};

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

class CaseSteps {
 public:
  CaseSteps(const Options& options, const Scene& scene, fem::EquilibriumSolver& solver, RunRecord& record,
            std::vector<fem::Location> locations, const Terminal& terminal, const RanksOfRun& ranks)
      : options_(options),
        scene_(scene),
        solver_(solver),
        record_(record),
        locations_(std::move(locations)),
        axes_(axes_of(scene, options.given_case)),
        terminal_(terminal),
        ranks_(ranks) {
    if (options.out.empty()) return;
    if (ranks.is_first()) write_order_of(options.out, scene);
    viewers_.emplace(options, scene, 0, ranks.is_first());
    write_tables();
  }

  [[nodiscard]] Outcome run() {
    const Interrupts interrupts;
    for (const double load : options_.given_case.steps) {
      if (ranks_.any(interrupted != 0)) return stop();
      terminal_.line("load %g", load);
      terminal_.newton_header();
      const auto begin = Clock::now();
      std::vector<NewtonRecord> newton;
      fem::NewtonResult result;
      try {
        result = solver_.solve_to(load, [&](std::size_t level, const fem::NewtonStep& step) {
          newton.push_back(
              {static_cast<int>(level), step.iterations, step.residual, step.energy, step.smallest_J, step.seconds});
          terminal_.newton_step(level, step);
          if (ranks_.any(interrupted != 0)) throw Interrupt{};
        });
      } catch (const Interrupt&) {
        return stop();
      }
      if (result.status != fem::NewtonStatus::converged) return fail(load, result);
      finish(load, result, seconds_since(begin), std::move(newton));
    }
    return Outcome::done;
  }

 private:
  void finish(double load, const fem::NewtonResult& result, double seconds, std::vector<NewtonRecord> newton) {
    // All ranks go through all of this; what they do not get is neither printed nor written.
    terminal_.line("  solved in %.3f s: %d Newton steps and %d PCG iterations", seconds, result.steps,
                   result.iterations);
    auto [state, applied] = sums_at(load);
    if (ranks_.is_first()) {
      for (const std::string& line : describe(state, options_.given_case.load_case)) terminal_.text("  " + line);
    }
    const std::unique_ptr<BodyState> of_solver = ranks_.state_of(solver_);
    warn(load, result, applied, *of_solver);
    StepRecord step;
    step.newton_iterations = result.steps;
    step.pcg_iterations = result.iterations;
    step.residual = result.residual;
    step.energy = result.energy;
    step.smallest_J = result.smallest_J;
    step.seconds = seconds;
    step.newton = std::move(newton);
    states_.push_back(state);
    step.at = std::move(state);
    record_.steps.push_back(std::move(step));
    if (!viewers_) return;
    ranks_.count(record_);
    viewers_->write_step(static_cast<double>(states_.size()), *of_solver);
    write_tables();
  }

  /// What groups and probes come to, and the square of the loads [N^2]; on the first rank, of vectors of all nodes.
  [[nodiscard]] std::pair<CaseState, double> sums_at(double load) {
    const std::vector<Point> positions = solver_.positions(), forces = solver_.forces();
    if (!ranks_.is_first()) return {};
    double applied = 0;
    for (const Point& force : external_forces(scene_.history.at(load), positions)) {
      for (const double component : force) applied += component * component;
    }
    return {case_state_of(scene_, options_.given_case, locations_, axes_, load, positions, forces), applied};
  }

  void write_tables() const {
    if (!ranks_.is_first()) return;
    write_case_tables(options_.out, states_);
    write_run_json(options_.out / "run.json", record_);
  }

  /// @param applied the square of the loads [N^2]
  void warn(double load, const fem::NewtonResult& result, double applied, BodyState& state) const {
    // Loads that balance each other leave no reaction for the residual to be small against.
    const double allowed = options_.solver.newton.tolerance * std::max(result.reaction, std::sqrt(applied));
    if ((load != 0 || applied > 0) && result.residual * result.reaction > allowed) {
      terminal_.warning(
          "at a load of %g, rounding ended the solve with %.2e N left, above the %.2e N of the tolerance: "
          "the result is less accurate than was asked for. Try a larger --tolerance.",
          load, result.residual * result.reaction, allowed);
    }
    if (result.smallest_J > 0) return;
    terminal_.warning(
        "at a load of %g, %s. A real body has no such equilibrium. Try more and smaller steps, or a finer mesh.", load,
        truthcube::describe(find_suspect(scene_.levels.front(), state, options_.window), scene_).c_str());
  }

  [[nodiscard]] Outcome stop() const {
    terminal_.line("interrupted; %zu steps are %s", states_.size(), options_.out.empty() ? "done" : "written");
    return Outcome::interrupted;
  }

  [[nodiscard]] Outcome fail(double load, const fem::NewtonResult& result) const {
    const SuspectTet suspect = find_suspect(scene_.levels.front(), *ranks_.state_of(solver_), options_.window);
    terminal_.error(
        "truthcube: no equilibrium at a load of %g: %s, after %d Newton steps, with a residual of %.2e; the last "
        "equilibrium is at %g.\nThere, %s.\nTry more and smaller steps in the case, %sor a finer mesh.",
        load, reason(result.status), result.steps, result.residual, solver_.load(),
        truthcube::describe(suspect, scene_).c_str(),
        options_.solver.precision == fem::TangentPrecision::float64 ? "" : "--precision double, ");
    return Outcome::not_converged;
  }

  const Options& options_;
  const Scene& scene_;
  fem::EquilibriumSolver& solver_;
  RunRecord& record_;
  std::vector<fem::Location> locations_;
  std::vector<std::optional<Point>> axes_;
  const Terminal& terminal_;
  const RanksOfRun& ranks_;
  std::optional<ViewersFile> viewers_;  // of a run that writes
  std::vector<CaseState> states_;
};

}  // namespace

Outcome run_case(Options options, const std::string& command, const fem::Stages& stages, RanksOfRun& ranks) {
  const Terminal terminal(options.quiet, ranks.is_first());
  const auto start = Clock::now();
  const bool starts_device = options.solver.device == fem::Device::cuda && !ranks.are_several();  // ranks take one each
  const DeviceStart device(starts_device && !options.dry_run);
  constexpr int parts = 3;
  terminal.set_up(1, parts, "the mesh");
  std::vector<std::string> notes;
  ranks.agree("case", options.given_case.text);
  ranks.require_readable(options.mesh);
  GivenMesh given = read_mesh(options, notes);
  bring_into_order(given, options);
  const Scene scene = make_case_scene(options, std::move(given));
  const std::vector<LevelCounts> counts = count_mesh(scene.levels, options);
  notes.insert(notes.end(), options.notes.begin(), options.notes.end());
  for (std::string& note : adapt_solver(options, scene, counts)) notes.push_back(std::move(note));
  adapt_smoother(options, scene);
  for (const std::string& note : notes) terminal.text("note: " + note);
  const auto faces = static_cast<std::int64_t>(pressed_faces(scene.history.at(1).pressures).size());
  const RunArrays of_run{.scene = options.scene, .names = arrays_of(options), .faces = faces};
  RunBytes bytes = bytes_of_run(counts, options.solver, of_run);
  if (scene.levels.front().axes) {  // the solver is made of a turned copy
    for (const LevelCounts& level : counts) bytes.lists += bytes_of_mesh(level);
  }
  const RunBytes of_each = ranks.bytes_of_each(options, counts, of_run, bytes);
  if (options.dry_run) {
    print_sizes(counts, bytes, options, terminal);
    if (!ranks.are_several()) return Outcome::done;
    ranks.print_forecast(of_each, terminal);
    options.out.clear();  // they make their parts to count them
  }
  const NeededMemory needed(options, of_each, ranks.on_this_machine(), ranks.are_several());
  needed.require(options, device);
  terminal.set_up(2, parts, "files");
  std::optional<FolderLock> lock;
  if (!options.out.empty() && ranks.is_first()) {
    if (options.set_up_only) require_no_run(options.out);
    require_writable(options.out);
    lock.emplace(options.out);
  }
  const fem::MeshLevel& finest = scene.levels.front();
  if (ranks.are_several()) {
    ranks.agree("mesh", std::to_string(mesh_hash(finest.rest, finest.mesh.tets)));
    ranks.agree("set of groups in its mesh", std::to_string(groups_hash(scene.groups)));
  }
  std::vector<fem::Location> locations = locate_probes(options.given_case.probes, finest);
  terminal.set_up(3, parts, "the solver's graphs and arrays, " + gigabytes(bytes.solver));
  if (options.solver.device == fem::Device::cuda) {
    options.solver.before_device = [&] {
      needed.require_on_gpu(starts_device ? device.free_bytes() : ranks.free_on_gpu());
    };
  }
  std::unique_ptr<fem::EquilibriumSolver> solver;
  const fem::Loading loading = scene.history.at(1);
  if (ranks.are_several()) {
    solver = ranks.make_solver(options, scene.levels, loading);
  } else if (options.scene == SceneKind::linear_elastic) {
    solver = fem::make_linear_solver(scene.levels, loading, options.solver);
  } else if (const fem::SceneRow* row = equilibrium_row(options.scene)) {
    solver = fem::make_scene_solver(row->name, scene.levels, loading, options.solver);
  } else {
    solver = fem::make_solver(scene.levels, loading, options.solver);
  }
  if (!scene.history.parts.empty()) {
    solver = fem::follow(std::move(solver), scene.history, options.solver.most_bisections);
  }
  RunRecord record;
  record.has_plates = false;
  record.nodes = finest.mesh.nodes;
  record.tets = static_cast<std::int64_t>(finest.mesh.tets.size());
  record.bytes = solver->bytes();
  ranks.count(record);
  record.device = fem::device_name(options.solver.device);
  record.layout = built_layout();
  record.command = command;
  record.settings = settings_json(options);
  record.setup_seconds = seconds_since(start);
  record.stages = records_of(stages, record.setup_seconds);
  terminal.line("%lld tets, %lld nodes, %zu levels; %s; set up in %.2f s", static_cast<long long>(record.tets),
                static_cast<long long>(record.nodes), scene.levels.size(), record.device.c_str(), record.setup_seconds);
  if (options.prints_timings()) print_timings(record.stages, terminal);
  if (ranks.are_several()) ranks.print_parts(terminal);
  if (options.dry_run) {
    ranks.print_iteration(terminal);
    return Outcome::done;
  }
  if (options.set_up_only) {
    if (ranks.is_first()) write_set_up(options.out, record);
    return Outcome::done;
  }
  return CaseSteps(options, scene, *solver, record, std::move(locations), terminal, ranks).run();
}

}  // namespace physgen::truthcube
