// run.json: what was solved, on what, and how each step went, for scripts.
#pragma once

#include <truthcube/output/case_state.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace physgen::truthcube {

struct NewtonRecord {
  int coarser_by = 0;  ///< levels of mesh; 0 is the finest
  int pcg_iterations = 0;
  double residual = 0;    ///< relative, after the step, as energy and smallest_J are
  double energy = 0;      ///< [J]
  double smallest_J = 0;  // NOLINT(readability-identifier-naming): as in the file
  double seconds = 0;
  bool operator==(const NewtonRecord&) const = default;
};

struct StepRecord {
  double compression = 0;  ///< plate travel over side
  int newton_iterations = 0;
  int pcg_iterations = 0;        ///< of all Newton iterations together
  double residual = 0;           ///< relative
  double energy = 0;             ///< [J]
  double smallest_J = 0;         // NOLINT(readability-identifier-naming): as in the file
  double reaction = 0;           ///< force on the top plate along z [N]; negative under compression
  double reaction_estimate = 0;  ///< of a mesh of vanishing size, extrapolated [N]; NaN without a coarser equilibrium
  double error_estimate = 0;     ///< RMS of the displacements' error [m]; NaN without a coarser equilibrium
  double past_plates = 0;        ///< how far the body reaches past the plates at most [m]
  double seconds = 0;            ///< wall time of the solve, without set-up and output
  double warm_seconds = 0;       ///< the shortest of its repetitions; NaN where it was not repeated
  double time = 0;               ///< of a motion [s]
  double kinetic_energy = 0;     ///< of a motion [J]
  /// Every Newton step in the order in which it was done, on coarser meshes too; none of a motion.
  std::vector<NewtonRecord> newton{};
  std::optional<CaseState> at{};  ///< of a case, for which there are no plates: what is theirs above is not written
  bool operator==(const StepRecord&) const = default;
};

/// What a plate holds of the finest mesh.
struct PlateRecord {
  std::int64_t nodes = 0;
  double area = 0;  ///< of surface triangles all of whose corners it holds [m^2]
  bool operator==(const PlateRecord&) const = default;
};

/// A part of the set-up.
struct StageRecord {
  std::string name;
  double seconds = 0;      ///< without those of stages within it
  std::int64_t bytes = 0;  ///< of what it reads and writes, each once
  bool operator==(const StageRecord&) const = default;
};

/// What has crossed between ranks up to the last step of this run.
struct RanksRecord {
  int count = 0;
  std::int64_t exchanges = 0, gathers = 0;                   ///< in which each rank took part
  std::int64_t messages = 0, bytes = 0, gathered_bytes = 0;  ///< of all ranks
  bool operator==(const RanksRecord&) const = default;
};

struct RunRecord {
  std::int64_t nodes = 0, tets = 0;
  std::int64_t bytes = 0;       ///< of all arrays of the solver
  std::string device;           ///< "cpu", or the name of the GPU
  std::string layout;           ///< of all arrays: "schema", or one for all, such as "aos"
  std::string command;          ///< as it was typed
  std::string settings = "{}";  ///< a JSON object: material, young, poisson, volume, cells, preconditioner, ...
  double setup_seconds = 0;
  std::vector<StageRecord> stages;        ///< of the set-up; in files of older versions there are none
  bool has_plates = true;                 ///< not of a case; they are not written then
  PlateRecord lower_plate, upper_plate;   ///< in files of older versions they are missing, and read as zeros
  std::optional<RanksRecord> ranks = {};  ///< of several
  std::vector<StepRecord> steps;
  bool operator==(const RunRecord&) const = default;
};

/// Writes all of the record; the file is complete at any time. Numbers keep all digits, and those that are not finite
/// are null, since JSON has no others.
/// @throws Error when the settings are not a JSON object or writing fails
void write_run_json(const std::filesystem::path& file, const RunRecord& record);

/// Reads what write_run_json() wrote, for a run between plates that is continued; null gives NaN.
/// @throws Error naming the file when it cannot be read, or lacks a key, which is named
[[nodiscard]] RunRecord read_run_json(const std::filesystem::path& file);

}  // namespace physgen::truthcube
