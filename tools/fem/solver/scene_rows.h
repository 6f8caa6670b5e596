// The catalogue of scenes that have a solver of their own. The solvers' types and build, the forecast of bytes and the
// command line read its rows: a new one is a declaration in scenes/ and a row here.
#pragma once

/// A row: the scene, which is declared in scenes/; the name by which users choose it; its material; its choices at run
/// time (run_time_choices.h); and whose volumes it takes: by_patches, by_tets or by_either. CMake reads these lines,
/// too (physgen_read_rows).
#define PHYSGEN_EQUILIBRIUM_SCENES(ROW, ...)                                                     \
  ROW(quasistatic, "quasistatic", StableNeoHookean, AssembledOnMeshes, by_either, __VA_ARGS__)   \
  ROW(quasistatic_matrix_free, "matrix-free", StableNeoHookean, ByTets, by_patches, __VA_ARGS__) \
  ROW(quasistatic_fixed_corotated, "fixed-corotated", FixedCorotated, AssembledOnMeshes, by_tets, __VA_ARGS__)

/// The same of motion by implicit steps.
#define PHYSGEN_IMPLICIT_SCENES(ROW, ...) \
  ROW(implicit_dynamics, "implicit-dynamics", StableNeoHookean, AssembledOnMeshes, by_either, __VA_ARGS__)

namespace physgen::fem {

/// A row as plain values.
struct SceneRow {
  const char *name, *word;
  const char *material, *bodies;  ///< the material's name for users, and in a sentence: "fixed corotated"
  bool assembled;
  bool patches, tets;  ///< whether volumes may be averaged over patches, or be those of tets
};

}  // namespace physgen::fem
