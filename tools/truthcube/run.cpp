#include "run.h"

#include <fem/solver/solvers/scene_solvers.h>
#include <physgen/error.h>
#include <physgen/memory/memory_error.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "arrays.h"
#include "case_run.h"
#include "device_start.h"
#include "memory.h"
#include "mesh_order.h"
#include "motion.h"
#include "needed_memory.h"
#include "output/folder_lock.h"
#include "output/hash.h"
#include "parse.h"
#include "program.h"
#include "ranks_of_run.h"
#include "run_bytes.h"
#include "run_files.h"
#include "scene.h"
#include "settings_json.h"
#include "steps.h"
#include "terminal.h"
#include "timings.h"

namespace physgen::truthcube {

namespace {

using Clock = std::chrono::steady_clock;

/// How such a run speaks of its solves. The remedies where there is no equilibrium are those that it has not taken yet.
SolveWords solve_words(const Options& options) {
  const bool is_linear = options.scene == SceneKind::linear_elastic;
  std::string remedies = is_linear ? "a --poisson farther from 0.5" : "more and smaller --compress steps";
  if (options.historical) remedies += ", the same without --historical";
  if (!is_linear && options.solver.nested) remedies += ", --stepping loads";
  const bool may_be_double = options.scene == SceneKind::everything || is_linear;
  if (may_be_double && !options.historical && options.solver.precision != fem::TangentPrecision::float64) {
    remedies += ", --precision double";
  }
  remedies += options.is_cube() ? ", or more --cells" : ", or a finer mesh";
  return {is_linear ? "linear solves" : "Newton steps", remedies};
}

void append(std::vector<std::string>& notes, const std::vector<std::string>& more) {
  notes.insert(notes.end(), more.begin(), more.end());
}

PlateRecord record_of(const Plate& plate) {
  return {static_cast<std::int64_t>(plate.nodes.front().size()), plate.area};
}

/// What tells a checkpoint from others of its settings and mesh.
std::string digest_of(const Checkpoint& checkpoint) {
  Hash hash;
  hash.add(std::as_bytes(std::span(checkpoint.positions)));
  return "step " + std::to_string(checkpoint.step) + ", at " + std::to_string(checkpoint.compression) +
         ", positions of digest " + std::to_string(hash.value());
}

Outcome run_recorded(Options options, const std::string& command, const fem::Stages& stages, RanksOfRun& ranks) {
  const Terminal terminal(options.quiet, ranks.is_first());
  const auto start = Clock::now();
  const bool starts_device = options.solver.device == fem::Device::cuda && !ranks.are_several();  // ranks take one each
  const DeviceStart device(starts_device && !options.dry_run);
  constexpr int parts = 4;
  terminal.set_up(1, parts, "sizes");
  std::vector<std::string> notes;
  Scene scene;
  if (!options.is_cube()) {
    ranks.require_readable(options.mesh);
    if (options.restart) require_last_order(options);
    GivenMesh given = read_mesh(options, notes);
    bring_into_order(given, options);
    scene = make_scene(options, std::move(given.levels));
    scene.tet_tags = std::move(given.tet_tags);
    scene.order = std::move(given.order);
    scene.numbers = std::move(given.numbers);
    scene.refinements = options.refinements;
  }
  const std::vector<LevelCounts> counts =
      options.is_cube() ? count_cube(options.cells, options.volume) : count_mesh(scene.levels, options);
  append(notes, options.notes);
  append(notes, adapt_solver(options, scene, counts));
  for (const std::string& note : notes) terminal.text("note: " + note);
  for (const std::string& warning : warnings_of(scene.plates)) terminal.warning("%s", warning.c_str());
  const std::string arrays = arrays_of(options);
  const RunArrays of_run{options.scene, arrays, options.plates == Plates::contact ? 2 : 0, options.motion.fixed_order};
  const RunBytes bytes = bytes_of_run(counts, options.solver, of_run);
  const RunBytes of_each = ranks.bytes_of_each(options, counts, of_run, bytes);
  if (options.dry_run) {
    if (!options.is_cube()) terminal.text(describe(scene.plates));
    print_sizes(counts, bytes, options, terminal);
    if (!ranks.are_several()) return Outcome::done;
    ranks.print_forecast(of_each, terminal);
    options.out.clear();  // they make their parts to count them
    options.restart = false;
    options.beads.clear();
  }
  const NeededMemory needed(options, of_each, ranks.on_this_machine(), ranks.are_several());
  needed.require(options, device);
  std::optional<FolderLock> lock;
  if (!options.out.empty() && ranks.is_first()) {
    if (options.set_up_only) require_no_run(options.out);
    if (!options.restart) require_writable(options.out);
    if (is_writable(options.out)) lock.emplace(options.out);  // else a run that goes on writes nothing
  }

  terminal.set_up(2, parts, "meshes of " + std::to_string(counts.front().tets) + " tets");
  if (options.is_cube()) scene = make_scene(options, make_cube(options, ranks.levels_without_lists(options, counts)));
  adapt_smoother(options, scene);
  const fem::MeshLevel& finest = scene.levels.front();
  if (options.historical) {
    fem::NewtonSettings& newton = options.solver.newton;
    newton.absolute_tolerance = std::min(
        1e-3, newton.tolerance * options.solver.youngs_modulus * scene.plates.height() * scene.plates.height());
  }

  terminal.set_up(3, parts, "files");
  const bool is_compared = !options.out.empty() || ranks.are_several();
  const std::uint64_t hash = is_compared ? mesh_hash(finest.rest, finest.mesh.tets) : 0;
  ranks.agree("mesh", std::to_string(hash));  // processors of other kinds may round its corners otherwise
  RunRecord record;
  std::optional<Checkpoint> checkpoint;
  if (options.restart) {
    checkpoint = read_last_step(options, scene, hash);
    ranks.agree("checkpoint in " + options.out.string(), digest_of(*checkpoint));
    record.steps = read_steps(options, *checkpoint);
    for (const double compression : options.compressions) {
      const auto is_it = [=](const StepRecord& step) { return step.compression == compression; };
      if (compression >= checkpoint->compression || std::ranges::any_of(record.steps, is_it)) continue;
      throw Error("--restart: " + options.out.string() + " has steps up to a compression of " +
                  std::to_string(checkpoint->compression) + " but none at " + std::to_string(compression) +
                  ", and a run continues only to larger ones; choose another --out");
    }
    if (checkpoint->compression >= options.compressions.back()) {
      terminal.line("nothing is left to do: step %d, at a compression of %g, is in %s", checkpoint->step,
                    checkpoint->compression, options.out.c_str());
      return Outcome::done;
    }
    if (ranks.is_first()) require_writable(options.out);
  }
  std::optional<MeasuredBeads> beads;
  if (!options.beads.empty()) beads.emplace(options.beads, finest);

  terminal.set_up(4, parts, "the solver's graphs and arrays, " + gigabytes(bytes.solver));
  if (options.solver.device == fem::Device::cuda) {
    options.solver.before_device = [&] {
      needed.require_on_gpu(starts_device ? device.free_bytes() : ranks.free_on_gpu());
    };
  }
  std::unique_ptr<fem::EquilibriumSolver> solver;
  std::unique_ptr<fem::DynamicSolver> dynamic;
  if (options.moves()) {
    dynamic = make_dynamic_solver(options, scene, ranks);
  } else if (ranks.are_several()) {
    solver = ranks.make_solver(options, scene.levels, scene.loading);
  } else if (options.scene == SceneKind::linear_elastic) {
    solver = fem::make_linear_solver(scene.levels, scene.loading, options.solver);
  } else if (arrays != "everything") {
    solver = fem::make_scene_solver(arrays, scene.levels, scene.loading, options.solver);
  } else {
    solver = fem::make_solver(scene.levels, scene.loading, options.solver);
  }
  record.nodes = finest.mesh.nodes;
  record.tets = static_cast<std::int64_t>(finest.mesh.tets.size());
  record.bytes = dynamic != nullptr ? dynamic->bytes() : solver->bytes();
  ranks.count(record);
  record.device = fem::device_name(options.solver.device);
  record.layout = built_layout();
  record.command = command;
  record.settings = settings_json(options);
  record.lower_plate = record_of(scene.plates.lower);
  record.upper_plate = record_of(scene.plates.upper);
  record.setup_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  record.stages = records_of(stages, record.setup_seconds);
  const auto total = static_cast<double>(record.bytes);
  terminal.line("%lld tets, %lld nodes, %zu levels; %s; %.1f MB, %.0f bytes per node; set up in %.2f s",
                static_cast<long long>(record.tets), static_cast<long long>(record.nodes), scene.levels.size(),
                record.device.c_str(), total / 1e6, total / static_cast<double>(record.nodes), record.setup_seconds);
  if (options.prints_timings()) print_timings(record.stages, terminal);
  terminal.text(describe(scene.plates));
  if (ranks.are_several()) ranks.print_parts(terminal);
  if (options.dry_run) {
    ranks.print_iteration(terminal);
    return Outcome::done;
  }
  if (options.set_up_only) {
    if (ranks.is_first()) write_set_up(options.out, record);
    return Outcome::done;
  }
  if (checkpoint) {
    solver->restore(state_of(*checkpoint, solver->state(), ranks.is_first()));
    terminal.line("continuing after step %d, at a compression of %g", checkpoint->step, checkpoint->compression);
    checkpoint.reset();
  }
  RunFiles files(options, scene, hash, static_cast<int>(record.steps.size()), ranks.is_first());
  files.write_record(record);
  if (dynamic != nullptr) return run_motion(options, scene, *dynamic, files, record, terminal, ranks);
  const double tolerance = options.solver.newton.absolute_tolerance > 0 ? 0 : options.solver.newton.tolerance;
  return Steps(scene, *solver, files, record, beads, terminal, ranks, tolerance, solve_words(options), options.window)
      .run(options.compressions, options.repetitions);
}

}  // namespace

Outcome run(Options options, const std::string& command, const Ranks& ranks) {
  fem::Stages stages;
  const auto in_stage = [&stages] {
    return stages.failed().empty() ? std::string() : " in its stage \"" + stages.failed() + "\"";
  };
  try {
    const fem::Stages::Recording recording(stages);
    RanksOfRun together(ranks, options);
    if (options.replicate > 0 && !together.are_several()) {
      options.notes.emplace_back("--replicate is of several ranks; one process has the whole of all meshes");
    }
    return options.is_case() ? run_case(std::move(options), command, stages, together)
                             : run_recorded(std::move(options), command, stages, together);
  } catch (const MemoryError& error) {
    throw Error("the memory ended" + in_stage() + ": " + text_of(error));
  } catch (const std::bad_alloc& error) {
    throw Error("the memory ended" + in_stage() + ": " + error.what());
  }
}

}  // namespace physgen::truthcube
