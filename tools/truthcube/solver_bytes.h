// Bytes of the solver's arrays, from the records of the generated types.
#pragma once

#include <fem/solver/settings.h>

#include <cstdint>
#include <string>
#include <vector>

#include "sizes.h"

namespace physgen::truthcube {

struct RunBytes {
  std::int64_t solver = 0;           ///< arrays in the memory of the device: QuasistaticSolver::bytes()
  std::vector<std::int64_t> levels;  ///< of each level that the solver uses; their sum is `solver`
  std::int64_t stresses = 0;         ///< in the same memory while a step is written
  std::int64_t lists = 0;            ///< meshes and graphs in the host's memory while the solver is set up
  std::int64_t meshes = 0;           ///< of these what stays
  std::int64_t results = 0;          ///< of all ranks, on the first of several while it writes a step
};
/// The choices that decide a run's arrays, beside its settings.
struct RunArrays {
  SceneKind scene = SceneKind::everything;
  std::string names = "everything";  ///< arrays_of()
  std::int64_t planes = 0;           ///< fem::Loading::planes, their number
  bool fixed_order = false;          ///< fem::DynamicSettings::fixed_order
  std::int64_t faces = 0;            ///< of the finest mesh that fem::Loading::pressures push, their number
  bool on_ranks = false;             ///< whether they are the part of one of several ranks
};

/// All of RunBytes but what lies in lists.
[[nodiscard]] RunBytes solver_bytes(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings,
                                    const RunArrays& arrays);

}  // namespace physgen::truthcube
