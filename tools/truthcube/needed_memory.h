// The memory that a run will take: printed, or required before anything of it is allocated.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "device_start.h"
#include "options.h"
#include "run_bytes.h"
#include "sizes.h"
#include "terminal.h"

namespace physgen::truthcube {

void print_sizes(const std::vector<LevelCounts>& levels, const RunBytes& bytes, const Options& options,
                 const Terminal& terminal);

/// The memory that a run takes, and its words where there is less.
class NeededMemory {
 public:
  /// @param bytes of one rank where there are several @param ranks of this machine, each of which takes as much
  /// @param are_several ranks of all machines: the device is not asked then, since each rank takes its own
  NeededMemory(const Options& options, const RunBytes& bytes, int ranks = 1, bool are_several = false);

  /// @throw Error when the run would not fit, before it is allocated
  void require(const Options& options, const DeviceStart& device) const;
  /// @param free bytes of the GPU of this process
  /// @throw Error when it does not fit into the GPU
  void require_on_gpu(std::int64_t free) const;

 private:
  /// Of runs this small the lists are made before the GPU is there to be asked; larger ones are refused sooner.
  static constexpr std::int64_t most_without_a_look = 4'000'000'000;

  [[nodiscard]] std::int64_t on_gpu() const { return bytes_.solver + bytes_.stresses; }

  std::string who_, remedy_;
  RunBytes bytes_;
  int ranks_;
  bool are_several_;
};

}  // namespace physgen::truthcube
