#include "run_files.h"

#include <physgen/error.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <numeric>
#include <span>

#include "choices.h"
#include "settings_json.h"
#include "state_windows.h"

namespace physgen::truthcube {

namespace {

using fem::Point;

constexpr const char* checkpoint_name = "checkpoint.h5";
constexpr const char* order_name = "order.h5";
constexpr const char* record_name = "run.json";

OrderMark mark_of(const Options& options, const Scene& scene) {
  return {name_of(orders, options.order), scene.order.digest()};
}

}  // namespace

bool is_writable(const std::filesystem::path& folder) { return ::access(folder.c_str(), W_OK | X_OK) == 0; }

void require_writable(const std::filesystem::path& folder) {
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (code) throw Error("cannot make the folder " + folder.string() + ": " + code.message() + "; choose another --out");
  if (!is_writable(folder)) {
    throw Error("cannot write into the folder " + folder.string() + ": " + std::strerror(errno) +
                "; choose another --out");
  }
}

void require_no_run(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / viewers_name)) return;
  throw Error("--set-up: " + folder.string() + " has the files of a run, whose " + record_name +
              " would be replaced by one without steps; choose another --out");
}

void write_set_up(const std::filesystem::path& folder, const RunRecord& record) {
  if (!folder.empty()) write_run_json(folder / record_name, record);
}

void write_order_of(const std::filesystem::path& folder, const Scene& scene) {
  if (scene.order.is_own()) {
    std::filesystem::remove(folder / order_name);
  } else {
    write_order(folder / order_name, scene.order);
  }
}

RunFiles::RunFiles(const Options& options, const Scene& scene, std::uint64_t mesh_hash, int steps_done, bool is_first)
    : folder_(options.out),
      settings_(settings_json(options)),
      mesh_hash_(mesh_hash),
      order_(mark_of(options, scene)),
      rest_(scene.levels.front().rest),
      mesh_(scene.levels.front().mesh),
      is_first_(is_first),
      window_(options.window) {
  if (folder_.empty()) return;
  const auto csv = file("beads.csv");
  // An old run's checkpoint does not belong to the files that begin here.
  if (is_first && steps_done == 0) {
    std::filesystem::remove(file(checkpoint_name));
    write_order_of(folder_, scene);
  }
  viewers_.emplace(options, scene, steps_done, is_first);
  if (!options.is_cube()) return;
  locations_ = fem::locate(rest_, mesh_, bead_positions());
  if (is_first) beads_.emplace(steps_done > 0 ? BeadFile::append_to(csv, steps_done) : BeadFile(csv));
}

void RunFiles::write_record(const RunRecord& record) const {
  if (writes() && is_first_) write_run_json(file(record_name), record);
}

void RunFiles::write_step(const RunRecord& record, double time, BodyState& state) {
  if (!writes()) return;
  viewers_->write_step(time, state);
  if (!locations_.empty()) {
    const std::vector<Point> corners = state.positions(0, corners_of(locations_, mesh_));
    if (beads_) {
      beads_->write_step(record.steps.back().compression, interpolate_displacements(locations_, mesh_, rest_, corners));
    }
  }
  write_record(record);
}

void RunFiles::write_checkpoint(const RunRecord& record, BodyState& state) const {
  if (!writes()) return;
  const std::vector<fem::Index> nodes = state.nodes_of_levels();
  const auto each_level = [&](const auto& take) {
    for (std::size_t l = 0; l < nodes.size(); ++l) {
      each_window(0, static_cast<std::size_t>(nodes[l]), WindowSizes(window_).nodes(),
                  [&](std::span<const fem::Index> numbers) { take(state.positions(l, numbers)); });
    }
  };
  if (!is_first_) return each_level([](const std::vector<Point>& /*none*/) {});
  // Last: what it counts is complete.
  truthcube::write_checkpoint(
      file(checkpoint_name),
      {settings_, mesh_hash_, static_cast<int>(record.steps.size()), record.steps.back().compression, {}, {}, order_},
      3 * std::accumulate(nodes.begin(), nodes.end(), std::uint64_t{0}), [&](const TakePositions& take) {
        each_level([&](const std::vector<Point>& positions) {
          take({positions.front().data(), 3 * positions.size()});  // Points are arrays without gaps
        });
      });
}

void require_last_order(const Options& options) {
  require_order(options.out / checkpoint_name, name_of(orders, options.order));
}

MeshOrder read_last_order(const Options& options, std::uint64_t mesh_hash) {
  return read_order(options.out / order_name, mesh_hash);
}

Checkpoint read_last_step(const Options& options, const Scene& scene, std::uint64_t mesh_hash) {
  return read_checkpoint(options.out / checkpoint_name, settings_json(options), mesh_hash, mark_of(options, scene));
}

std::vector<StepRecord> read_steps(const Options& options, const Checkpoint& checkpoint) {
  const std::filesystem::path file = options.out / record_name;
  std::vector<StepRecord> steps = read_run_json(file).steps;
  const auto done = static_cast<std::size_t>(checkpoint.step);
  if (steps.size() < done) {
    throw Error(file.string() + " has " + std::to_string(steps.size()) +
                " steps, and the checkpoint beside it is of step " + std::to_string(done) +
                ": the files come from different runs; run again without --restart");
  }
  steps.resize(done);
  if (done > 0 && steps.back().compression != checkpoint.compression) {
    throw Error(file.string() + " has a compression of " + std::to_string(steps.back().compression) + " in step " +
                std::to_string(done) + ", and the checkpoint beside it " + std::to_string(checkpoint.compression) +
                ": the files come from different runs; run again without --restart");
  }
  return steps;
}

fem::SolverState state_of(const Checkpoint& checkpoint, const fem::SolverState& shape, bool is_first) {
  fem::SolverState state = shape;
  state.load = checkpoint.compression;
  if (!is_first) return state;
  std::size_t wanted = 0;
  for (const auto& level : state.positions) wanted += 3 * level.size();
  if (wanted != checkpoint.positions.size()) {
    throw Error("the checkpoint has " + std::to_string(checkpoint.positions.size()) +
                " coordinates, and these meshes " + std::to_string(wanted) + "; run again without --restart");
  }
  auto number = checkpoint.positions.begin();
  for (auto& level : state.positions) {
    for (Point& x : level) {
      for (double& coordinate : x) coordinate = *number++;
    }
  }
  return state;
}

}  // namespace physgen::truthcube
