#include "needed_memory.h"

#include <physgen/error.h>

#include <algorithm>

#include "memory.h"

namespace physgen::truthcube {

void print_sizes(const std::vector<LevelCounts>& levels, const RunBytes& bytes, const Options& options,
                 const Terminal& terminal) {
  terminal.text("  level        nodes         tets        edges            bytes");
  const bool assembled =
      options.solver.newton.product == fem::Product::assembled && options.scene != SceneKind::explicit_dynamics;
  for (std::size_t l = 0; l < bytes.levels.size(); ++l) {
    const LevelCounts& c = levels[l];
    terminal.line("  %5zu %12lld %12lld %12lld %16lld", l, static_cast<long long>(c.nodes),
                  static_cast<long long>(c.tets), static_cast<long long>(assembled ? c.edges : 0),
                  static_cast<long long>(bytes.levels[l]));
  }
  const auto total = static_cast<double>(bytes.solver);
  terminal.line("solver: %lld bytes, %.0f per node and %.0f per tet of the finest level",
                static_cast<long long>(bytes.solver), total / static_cast<double>(levels.front().nodes),
                total / static_cast<double>(levels.front().tets));
  std::int64_t meshes = 0;
  for (const LevelCounts& level : levels) meshes += bytes_of_mesh(level);
  terminal.line("set-up: %s more on the host, of which %s of meshes stay; this machine has %s",
                gigabytes(bytes.lists).c_str(), gigabytes(meshes).c_str(), gigabytes(host_memory()).c_str());
  if (options.solver.device == fem::Device::cuda) {
    try {
      terminal.line("GPU: %s free", gigabytes(cuda_memory()).c_str());
    } catch (const Error& error) {
      terminal.text(error.what());
    }
  }
}

NeededMemory::NeededMemory(const Options& options, const RunBytes& bytes, int ranks, bool are_several)
    : who_((options.is_cube() ? "a cube of " + std::to_string(options.cells) + "^3 cells" : "this mesh") +
           (ranks > 1 ? " on each of " + std::to_string(ranks) + " ranks" : "")),
      remedy_((options.is_cube() ? std::string("fewer --cells, ") : "a coarser mesh, ") +
              (ranks > 1 ? "ranks on more machines, fewer ranks or --volume tets need less"
                         : "--volume tets, --precision half or --product matrix-free need less")),
      bytes_(bytes),
      ranks_(ranks),
      are_several_(are_several) {}

void NeededMemory::require(const Options& options, const DeviceStart& device) const {
  if (options.solver.device != fem::Device::cuda || are_several_) {  // the arrays of ranks begin on the host
    // Lists go before the first step is written.
    const std::int64_t beside = std::max(ranks_ * bytes_.lists, ranks_ * bytes_.meshes + bytes_.results);
    require_memory(who_, ranks_ * bytes_.solver + beside, "this machine", host_memory(), remedy_);
    return;
  }
  require_memory("setting up " + who_, bytes_.lists, "this machine", host_memory(), remedy_);
  if (on_gpu() > most_without_a_look) require_on_gpu(device.free_bytes());
}

void NeededMemory::require_on_gpu(std::int64_t free) const { require_memory(who_, on_gpu(), "the GPU", free, remedy_); }

}  // namespace physgen::truthcube
