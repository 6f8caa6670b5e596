// The steps of a run: from compression to compression with a solver that is set up.
#pragma once

#include <fem/mesh/locate.h>
#include <fem/solver/quasistatic.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "body_state.h"
#include "outcome.h"
#include "output/bead_table.h"
#include "output/run_json.h"
#include "ranks_of_run.h"
#include "run_files.h"
#include "scene.h"
#include "terminal.h"

namespace physgen::truthcube {

/// A user's measured beads, and where they lie in the mesh.
struct MeasuredBeads {
  BeadTable table;
  std::vector<fem::Location> locations;

  /// @throw Error naming the line that is malformed, or whose bead lies outside
  MeasuredBeads(const std::filesystem::path& file, const fem::MeshLevel& level);
};

/// Why a solve found no equilibrium; "" where it did.
[[nodiscard]] const char* reason(fem::NewtonStatus status);

class LastEquilibrium;
/// How a run speaks of its solves.
struct SolveWords {
  std::string what;      ///< the steps of a solve, in the plural
  std::string remedies;  ///< what to try where there is no equilibrium
};

class Steps {
 public:
  /// All stay alive as long as this. @param record gets an entry for each step
  /// @param tolerance of the residual; 0: of another measure
  /// @param window bytes of what is printed
  Steps(const Scene& scene, fem::EquilibriumSolver& solver, RunFiles& files, RunRecord& record,
        const std::optional<MeasuredBeads>& beads, const Terminal& terminal, const RanksOfRun& ranks, double tolerance,
        SolveWords words, std::size_t window)
      : scene_(scene),
        solver_(solver),
        files_(files),
        record_(record),
        beads_(beads),
        terminal_(terminal),
        ranks_(ranks),
        tolerance_(tolerance),
        words_(std::move(words)),
        window_(window) {}

  /// Solves for those behind the solver's load. Ctrl-C ends this after a Newton step; a second one ends the process.
  /// @param repetitions of all solves once more from where they began, for their time without what a program does once
  /// @throw Error when a file cannot be written
  [[nodiscard]] Outcome run(const std::vector<double>& compressions, int repetitions);

 private:
  [[nodiscard]] Outcome repeat(const fem::SolverState& beginning, std::span<StepRecord> steps, int repetitions);
  [[nodiscard]] Outcome stop() const;
  /// Prints and writes an equilibrium. @param newton the steps that led to it
  void finish(double compression, const fem::NewtonResult& result, double seconds, std::vector<NewtonRecord> newton);
  /// Says on standard error why an equilibrium should not be taken as it is.
  void warn(double compression, const fem::NewtonResult& result, BodyState& state) const;
  /// Writes the last equilibrium on the way, and says what stopped the run.
  [[nodiscard]] Outcome fail(double compression, const fem::NewtonResult& result, LastEquilibrium& last,
                             double seconds);
  void compare(double compression, BodyState& state) const;

  const Scene& scene_;
  fem::EquilibriumSolver& solver_;
  RunFiles& files_;
  RunRecord& record_;
  const std::optional<MeasuredBeads>& beads_;
  const Terminal& terminal_;
  const RanksOfRun& ranks_;
  double tolerance_;
  SolveWords words_;
  std::size_t window_;
};

}  // namespace physgen::truthcube
