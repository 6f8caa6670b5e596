#include "ranks_of_run.h"

#include <fem/dynamics/explicit_on_ranks.h>
#include <fem/solver/levels/layers_of_levels.h>
#include <fem/solver/solvers/solvers_on_ranks.h>
#include <physgen/distributed/cuda/device.h>
#include <physgen/error.h>
#include <physgen/launch/processors.h>
#include <physgen/threads.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <span>

#include "arrays.h"
#include "memory.h"
#include "rank_bytes.h"
#include "scene_choice.h"
#include "state_on_ranks.h"

namespace physgen::truthcube {

namespace {

/// The processors that this process may use, as text.
std::string allowed_set() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (::sched_getaffinity(0, sizeof set, &set) != 0) return "";
  std::string text;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) text += CPU_ISSET(cpu, &set) ? '1' : '0';
  return text;
}

[[noreturn]] void refuse(const std::string& what, const std::string& remedy) {
  throw Error("several ranks do not have " + what + "; " + remedy + ", or start one process, without mpirun");
}

[[noreturn]] [[maybe_unused]] void refuse_without_clang() {
  refuse("a solver in this build, which was made without Clang", "build physgen where LLVM is installed");
}

std::string in_case(const Options& options, const std::string& key) {
  return " (" + key + " of the case " + options.case_file.string() + ")";
}

/// @throw Error naming what one process alone has of the scene everything
void require_everything_on_ranks(const Options& options) {
  const fem::SolverSettings& solver = options.solver;
  if (solver.newton.product != fem::Product::assembled) {
    refuse("--product matrix-free of --scene everything, which --historical uses, too",
           "remove it, or write --scene matrix-free");
  }
  if (const auto kind = solver.newton.preconditioner.kind; fem::asks_for(kind, fem::asks::arrays)) {
    refuse("--preconditioner " + std::string(fem::row_of(kind).name), "write --preconditioner multigrid");
  }
  if (solver.precision == fem::TangentPrecision::float64) {
    refuse("--precision double", "write --precision float");
  }
  if (options.volume == VolumeTreatment::nodes) refuse("--volume nodes", "write --volume patches");
  if (std::ranges::any_of(options.given_case.load_case.pressures, &fem::GroupPressure::follows)) {
    refuse("pressures that follow the surface" + in_case(options, "loads"), "remove \"follows\"");
  }
}

}  // namespace

void require_on_ranks(const Options& options) {
#ifndef PHYSGEN_TRUTHCUBE_HAS_RANKS
  refuse_without_clang();
#endif
  const bool on_cuda = options.solver.device == fem::Device::cuda;
  const std::string scene = "--scene " + name_of(scene_kinds, options.scene);
  if (on_cuda && options.scene != SceneKind::quasistatic) refuse(scene + " on CUDA", "write --scene quasistatic");
  const fem::Preconditioner preconditioner = options.solver.newton.preconditioner.kind;
  if (options.scene == SceneKind::linear_elastic && fem::asks_for(preconditioner, fem::asks::arrays)) {
    refuse(scene + " --preconditioner " + fem::row_of(preconditioner).name,
           "take --preconditioner " + fem::preconditioners_without(fem::asks::arrays));
  }
  if (options.scene == SceneKind::implicit_dynamics && arrays_of(options) == "everything") {
    refuse(scene + " with the arrays of the scene everything",
           "take the cube, of stable-neo-hookean material, in float, without --volume nodes and --plates contact, and "
           "with --preconditioner " +
               fem::preconditioners_without(fem::asks::arrays));
  }
  const auto has_axis = [](const fem::Support& support) { return support.axis.has_value(); };
  if (std::ranges::any_of(options.given_case.load_case.supports, has_axis)) {
    refuse("supports along other axes than x, y and z" + in_case(options, "supports"),
           "turn the mesh so that they lie along these, and write \"fixed\"");
  }
  if (options.scene == SceneKind::everything) require_everything_on_ranks(options);
}

RanksOfRun::RanksOfRun(const Ranks& ranks, const Options& options) : ranks_(ranks) {
  if (options.replicate > 0) replicated_ = options.replicate;
  if (!are_several()) return;
  require_on_ranks(options);
  transport_ = make_transport(ranks);
  const std::vector<std::string> machines = texts_of_all(ranks.host());
  on_this_machine_ = static_cast<int>(std::ranges::count(machines, ranks.host()));
  is_beside_first_ = machines.front() == ranks.host();
  const std::string own = ranks.host() + " " + allowed_set();
  const auto sharing = static_cast<int>(std::ranges::count(texts_of_all(own), own));
  if (options.threads == 0 && std::getenv("OMP_NUM_THREADS") == nullptr) {
    set_threads(std::max(1, allowed_processors() / sharing));
  }
}

void RanksOfRun::require_readable(const std::filesystem::path& mesh) const {
  if (!are_several() || ::access(mesh.c_str(), R_OK) == 0) return;
  throw Error("cannot read the mesh " + mesh.string() + ": " + std::strerror(errno) +
              "; each rank reads it, so put it where all machines find it by this name");
}

bool RanksOfRun::any(bool is_so) const {
  if (!are_several()) return is_so;
  const std::vector<index_t> given(static_cast<std::size_t>(ranks_.count()), is_so ? 1 : 0);
  return std::ranges::count(transport_->all_to_all(given), 1) > 0;
}

std::vector<std::string> RanksOfRun::texts_of_all(const std::string& mine) const {
  const auto ranks = static_cast<std::size_t>(ranks_.count());
  const std::vector<index_t> sizes =
      transport_->all_to_all(std::vector<index_t>(ranks, static_cast<index_t>(mine.size())));
  std::string all(static_cast<std::size_t>(std::accumulate(sizes.begin(), sizes.end(), index_t{0})), ' ');
  transport_->gather(std::as_bytes(std::span(mine)), sizes, std::as_writable_bytes(std::span(all)));
  std::vector<std::string> texts;
  std::size_t begin = 0;
  for (const index_t size : sizes) {
    texts.push_back(all.substr(begin, static_cast<std::size_t>(size)));
    begin += static_cast<std::size_t>(size);
  }
  return texts;
}

void RanksOfRun::print_table(const Terminal& terminal, const std::string& head, const std::vector<index_t>& mine,
                             const std::string& last) const {
  const auto column = [](index_t number, std::size_t width) {
    const std::string text = std::to_string(number);
    return std::string(width - std::min(width, text.size()), ' ') + text;
  };
  std::string line;
  for (const index_t number : mine) line += column(number, 13);
  const std::vector<std::string> lines = texts_of_all(line + "  " + last);
  terminal.text("   rank" + head);
  for (std::size_t r = 0; r < lines.size(); ++r) terminal.text(column(static_cast<index_t>(r), 7) + lines[r]);
}

void RanksOfRun::print_forecast(const RunBytes& of_each, const Terminal& terminal) const {
  const std::string writing =
      of_each.results == 0 ? ""
                           : "; the first has " + std::to_string(of_each.results) + " bytes of a step that it writes";
  terminal.line("each of %d ranks: about %lld bytes of the solver, and %s more on the host for its set-up%s",
                ranks_.count(), static_cast<long long>(of_each.solver), gigabytes(of_each.lists).c_str(),
                writing.c_str());
}

std::int64_t RanksOfRun::free_on_gpu() const {
  (void)cuda::take_device(ranks_, *transport_);
  return cuda_memory();
}

std::unique_ptr<BodyState> RanksOfRun::state_of(fem::EquilibriumSolver& solver) const {
  if (are_several()) return std::make_unique<StateOnRanks>(*solver_, is_first());
  return std::make_unique<WholeState>(solver);
}

std::unique_ptr<BodyState> RanksOfRun::state_of(fem::DynamicSolver& solver) const {
  if (are_several()) return std::make_unique<StateOnRanks>(*solver_, is_first());
  return std::make_unique<WholeState>(
      WholeState::Makers{.positions = [&solver] { return std::vector<WholeState::Points>{solver.positions()}; },
                         .forces = [&solver] { return solver.forces(); },
                         .stresses = [&solver] { return solver.stresses(); }});
}

#ifdef PHYSGEN_TRUTHCUBE_HAS_RANKS

std::unique_ptr<fem::EquilibriumSolver> RanksOfRun::make_solver(const Options& options,
                                                                const std::vector<fem::MeshLevel>& levels,
                                                                const fem::Loading& loading) {
  const fem::SolverSettings& settings = options.solver;
  auto solver = options.scene == SceneKind::linear_elastic
                    ? fem::make_linear_solver_on_ranks(ranks_, levels, loading, settings, replicated_)
                    : fem::make_solver_on_ranks(ranks_, arrays_of(options), levels, loading, settings, replicated_);
  solver_ = solver.get();
  return solver;
}

std::unique_ptr<fem::DynamicSolver> RanksOfRun::make_motion(const Options& options,
                                                            const std::vector<fem::MeshLevel>& levels,
                                                            const fem::Loading& loading,
                                                            const fem::DynamicSettings& settings) {
  const bool is_explicit = options.scene == SceneKind::explicit_dynamics;
  if (is_explicit) iteration_ = "a time step";
  auto solver = is_explicit ? fem::make_explicit_solver_on_ranks(ranks_, levels.front(), loading, settings)
                            : fem::make_implicit_solver_on_ranks(ranks_, levels, loading, settings, replicated_);
  solver_ = solver.get();
  return solver;
}

std::size_t RanksOfRun::levels_cut(const Options& options, const std::vector<LevelCounts>& counts) const {
  std::vector<index_t> nodes;
  for (const LevelCounts& level : counts) nodes.push_back(level.is_grid ? 0 : level.nodes);
  return fem::levels_cut_by_solver(nodes, options.solver, ranks_.count(), replicated_);
}

std::size_t RanksOfRun::levels_without_lists(const Options& options, const std::vector<LevelCounts>& counts) const {
  const bool needs_rows = options.output == Output::surface;  // which is found by rows of tets
  if (!are_several() || !options.is_cube() || needs_rows) return 0;
  return levels_cut(options, counts);
}

RunBytes RanksOfRun::bytes_of_each(const Options& options, const std::vector<LevelCounts>& counts,
                                   const RunArrays& arrays, const RunBytes& of_one) const {
  if (!are_several()) return of_one;
  const bool has_layers = levels_without_lists(options, counts) > 0;
  return bytes_of_rank(
      counts, options.solver, arrays,
      {.count = ranks_.count(),
       .cut = levels_cut(options, counts),
       .cells = options.is_cube() ? options.cells : 0,
       .has_layers = has_layers,
       .window = !options.out.empty() && is_beside_first_ ? std::optional(options.window) : std::nullopt,
       .sums_groups = options.is_case()});
}

void RanksOfRun::print_parts(const Terminal& terminal) const {
  const fem::PartOfMesh part = solver_->part();
  print_table(terminal,
              "    own nodes       ghosts     own tets       ghosts   neighbours        bytes      threads  machine",
              {part.owned_nodes, part.ghost_nodes, part.owned_tets, part.ghost_tets, part.neighbours, solver_->bytes(),
               threads()},
              ranks_.host());
}

void RanksOfRun::print_iteration(const Terminal& terminal) const {
  const Traffic traffic = solver_->traffic_of_iteration();
  terminal.line("in %s: %lld exchanges, %lld gathers", iteration_, static_cast<long long>(traffic.exchanges),
                static_cast<long long>(traffic.gathers));
  print_table(terminal, "     messages        bytes     gathered  sent by",
              {traffic.messages, traffic.bytes, traffic.gathered_bytes}, ranks_.host());
}

void RanksOfRun::count(RunRecord& record) const {
  if (!are_several()) return;
  const Traffic traffic = solver_->traffic();
  std::vector<index_t> all(static_cast<std::size_t>(ranks_.count()));
  const auto sum = [&](index_t mine) {
    std::ranges::fill(all, mine);
    const std::vector<index_t> got = transport_->all_to_all(all);
    return static_cast<std::int64_t>(std::accumulate(got.begin(), got.end(), index_t{0}));
  };
  record.bytes = sum(solver_->bytes());
  record.ranks = RanksRecord{ranks_.count(),        traffic.exchanges,  traffic.gathers,
                             sum(traffic.messages), sum(traffic.bytes), sum(traffic.gathered_bytes)};
}

#else

std::unique_ptr<fem::EquilibriumSolver> RanksOfRun::make_solver(const Options& /*options*/,
                                                                const std::vector<fem::MeshLevel>& /*levels*/,
                                                                const fem::Loading& /*loading*/) {
  refuse_without_clang();
}
std::unique_ptr<fem::DynamicSolver> RanksOfRun::make_motion(const Options& /*options*/,
                                                            const std::vector<fem::MeshLevel>& /*levels*/,
                                                            const fem::Loading& /*loading*/,
                                                            const fem::DynamicSettings& /*settings*/) {
  refuse_without_clang();
}
std::size_t RanksOfRun::levels_without_lists(const Options& /*options*/,
                                             const std::vector<LevelCounts>& /*counts*/) const {
  return 0;
}
RunBytes RanksOfRun::bytes_of_each(const Options& /*options*/, const std::vector<LevelCounts>& /*counts*/,
                                   const RunArrays& /*arrays*/, const RunBytes& of_one) const {
  return of_one;
}
void RanksOfRun::print_parts(const Terminal& /*terminal*/) const {}
void RanksOfRun::print_iteration(const Terminal& /*terminal*/) const {}
void RanksOfRun::count(RunRecord& /*record*/) const {}

#endif

}  // namespace physgen::truthcube
