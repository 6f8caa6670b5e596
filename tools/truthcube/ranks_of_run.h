// The ranks of a run, of which the first prints and writes: what they decide together, and the solver of several.
#pragma once

#include <fem/solver/dynamic_solver.h>
#include <fem/solver/quasistatic.h>
#include <physgen/distributed/ranks.h>
#include <physgen/distributed/transport.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "body_state.h"
#include "options.h"
#include "output/run_json.h"
#include "sizes.h"
#include "solver_bytes.h"
#include "terminal.h"

namespace physgen::fem {
class RankReport;
}  // namespace physgen::fem

namespace physgen::truthcube {

/// @throw Error naming what several ranks do not have, and what to write instead
void require_on_ranks(const Options& options);

/// All ranks call the same functions. With one rank they do what a program of one process does.
class RanksOfRun {
 public:
  /// Threads of ranks that may use the same processors share these, where `options.threads` and OMP_NUM_THREADS say
  /// nothing. @throw Error as require_on_ranks(), with several
  RanksOfRun(const Ranks& ranks, const Options& options);

  [[nodiscard]] bool is_first() const { return ranks_.is_first(); }
  [[nodiscard]] bool are_several() const { return ranks_.count() > 1; }
  [[nodiscard]] int on_this_machine() const { return on_this_machine_; }
  /// @throw Error on a rank of several that cannot read it, with the reason
  void require_readable(const std::filesystem::path& mesh) const;
  /// Whether it is so on any rank.
  [[nodiscard]] bool any(bool is_so) const;
  /// See Ranks::agree().
  void agree(const std::string& what, const std::string& value) const { ranks_.agree(what, value); }

  /// Of so many of the finest levels several ranks need no lists but those of their parts, which they make.
  /// @param counts of all levels
  [[nodiscard]] std::size_t levels_without_lists(const Options& options, const std::vector<LevelCounts>& counts) const;

  /// What one of several ranks takes, as bytes_of_rank(), of what one process does. With one: this.
  [[nodiscard]] RunBytes bytes_of_each(const Options& options, const std::vector<LevelCounts>& counts,
                                       const RunArrays& arrays, const RunBytes& of_one) const;
  void print_forecast(const RunBytes& of_each, const Terminal& terminal) const;
  /// Free bytes of the GPU of this rank, which it takes. All ranks call it. @throw Error as cuda_memory(), and as
  /// cuda::take_device()
  [[nodiscard]] std::int64_t free_on_gpu() const;

  /// The solver of several ranks, which print_parts() and count() ask: it lives as long as they are called.
  [[nodiscard]] std::unique_ptr<fem::EquilibriumSolver> make_solver(const Options& options,
                                                                    const std::vector<fem::MeshLevel>& levels,
                                                                    const fem::Loading& loading);
  /// The same of a body that moves.
  [[nodiscard]] std::unique_ptr<fem::DynamicSolver> make_motion(const Options& options,
                                                                const std::vector<fem::MeshLevel>& levels,
                                                                const fem::Loading& loading,
                                                                const fem::DynamicSettings& settings);
  /// The state of the solver of this run, with one rank or several: until the solver goes on.
  [[nodiscard]] std::unique_ptr<BodyState> state_of(fem::EquilibriumSolver& solver) const;
  [[nodiscard]] std::unique_ptr<BodyState> state_of(fem::DynamicSolver& solver) const;
  /// A line for each rank: its machine, its part of the finest mesh, and its bytes. @pre make_solver()
  void print_parts(const Terminal& terminal) const;
  /// A line for each rank: what it sends in an iteration of conjugate gradients, or where there are none in a time
  /// step, some of which this does. @pre make_solver()
  void print_iteration(const Terminal& terminal) const;
  /// The number of ranks, and what has crossed, of several. @pre make_solver()
  void count(RunRecord& record) const;

 private:
  /// How many of the finest levels are cut.
  [[nodiscard]] std::size_t levels_cut(const Options& options, const std::vector<LevelCounts>& counts) const;
  /// The texts of all ranks.
  [[nodiscard]] std::vector<std::string> texts_of_all(const std::string& mine) const;
  /// The numbers of all ranks, below this head, each in a column. @param last text behind them
  void print_table(const Terminal& terminal, const std::string& head, const std::vector<index_t>& mine,
                   const std::string& last) const;

  const Ranks& ranks_;
  std::unique_ptr<Transport> transport_;
  int on_this_machine_ = 1;
  bool is_beside_first_ = true;        ///< on the machine of the first rank, which writes
  std::optional<index_t> replicated_;  ///< as make_solver_on_ranks() takes it
  [[maybe_unused]] const char* iteration_ = "a PCG iteration";
  [[maybe_unused]] fem::RankReport* solver_ = nullptr;  ///< in builds that have it
};

}  // namespace physgen::truthcube
