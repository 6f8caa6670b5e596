// The files of a run: cube.vtkhdf, beads.csv, run.json and checkpoint.h5 in one folder; or none.
#pragma once

#include <fem/mesh/locate.h>
#include <fem/solver/quasistatic.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "body_state.h"
#include "options.h"
#include "output/beads.h"
#include "output/checkpoint.h"
#include "output/run_json.h"
#include "scene.h"
#include "viewers_file.h"

namespace physgen::truthcube {

[[nodiscard]] bool is_writable(const std::filesystem::path& folder);
/// Makes the folder where it is missing. @throw Error when it cannot be made, or nothing can be written into it
void require_writable(const std::filesystem::path& folder);

/// For a run that ends behind its set-up. @throw Error when the folder has the files of a run, whose record would be
/// lost
void require_no_run(const std::filesystem::path& folder);
/// Its record, without steps; nothing where the folder is empty.
void write_set_up(const std::filesystem::path& folder, const RunRecord& record);

/// Writes the order of a mesh that has another than its own; else removes that of an old run.
void write_order_of(const std::filesystem::path& folder, const Scene& scene);

class RunFiles {
 public:
  /// Begins the files anew, or continues those of a run after its first `steps_done` steps. All ranks have one, and
  /// call the same functions.
  /// @param scene stays alive as long as this. @param mesh_hash of its finest level
  /// @param is_first whether this is the rank that writes: the others write nothing
  /// @throw Error when a file cannot be written, or does not continue this run
  RunFiles(const Options& options, const Scene& scene, std::uint64_t mesh_hash, int steps_done, bool is_first = true);

  /// Whether the run writes files, on whatever rank.
  [[nodiscard]] bool writes() const { return !folder_.empty(); }
  /// The record without steps of this run, for whoever looks before the first.
  void write_record(const RunRecord& record) const;
  /// The last step in the record. @param time as viewers show it
  void write_step(const RunRecord& record, double time, BodyState& state);
  /// From which a run goes on behind that step. @pre it is written
  void write_checkpoint(const RunRecord& record, BodyState& state) const;

 private:
  [[nodiscard]] std::filesystem::path file(const char* name) const { return folder_ / name; }

  std::filesystem::path folder_;
  std::string settings_;
  std::uint64_t mesh_hash_;
  OrderMark order_;
  const std::vector<fem::Point>& rest_;
  const fem::TetMesh& mesh_;
  bool is_first_;
  std::size_t window_;
  std::optional<ViewersFile> viewers_;
  std::optional<BeadFile> beads_;         ///< of the cube, of the rank that writes
  std::vector<fem::Location> locations_;  ///< of beads of the cube
};

/// For a run that goes on. @throw Error when the checkpoint in its folder is of another --order
void require_last_order(const Options& options);
/// The order of the mesh in the folder of a run. @throw Error as read_order()
[[nodiscard]] MeshOrder read_last_order(const Options& options, std::uint64_t mesh_hash);
/// The checkpoint that is in the folder of a run. @throw Error as read_checkpoint()
[[nodiscard]] Checkpoint read_last_step(const Options& options, const Scene& scene, std::uint64_t mesh_hash);
/// The record of the steps up to the checkpoint. @throw Error when there is none, or it has fewer steps
[[nodiscard]] std::vector<StepRecord> read_steps(const Options& options, const Checkpoint& checkpoint);
/// The state in a checkpoint. @param shape a state of the same solver, for the number of levels and nodes; on another
/// rank than the first it has no nodes, and the result has none
/// @throw Error when the checkpoint has another number of positions
[[nodiscard]] fem::SolverState state_of(const Checkpoint& checkpoint, const fem::SolverState& shape, bool is_first);

}  // namespace physgen::truthcube
