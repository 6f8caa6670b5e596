// Everything that one may choose of a run; plain values, which parse.h makes of a command line.
#pragma once

#include <fem/solver/scene_rows.h>
#include <fem/solver/settings.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "case_file.h"
#include "output/window.h"
#include "plates.h"

namespace physgen::truthcube {

enum class VolumeTreatment { tets, patches, nodes };
enum class TopPlate { bonded, frictionless };
/// How plates treat the sides of the body: they ignore them, or push back those that reach them.
enum class Plates { held, contact };
/// What the file for viewers has: all of the body, or its surface alone.
enum class Output { body, surface };

/// How a mesh of the user's numbers its nodes and tets: as its file does, or by parts that METIS finds.
enum class NodeOrder { mesh, metis };

/// The problem that is solved; see scene_choice.h.
#define PHYSGEN_SCENE_KIND(scene, ...) scene,
enum class SceneKind {
  everything,
  PHYSGEN_EQUILIBRIUM_SCENES(PHYSGEN_SCENE_KIND) PHYSGEN_IMPLICIT_SCENES(PHYSGEN_SCENE_KIND) explicit_dynamics,
  linear_elastic
};
#undef PHYSGEN_SCENE_KIND

/// Settings of scenes that move.
struct MotionOptions {
  double time_step = 0;      ///< at most [s]; 0: a hundredth of the duration, or half of what is stable
  double duration = 0.4;     ///< [s]
  double density = 1000;     ///< [kg/m^3]
  double damping = 0;        ///< [1/s]
  int frames = 20;           ///< how many states are written, evenly in time
  bool fixed_order = false;  ///< of the sums at nodes of explicit steps on CUDA
};

struct Options {
  SceneKind scene = SceneKind::everything;
  MotionOptions motion;
  int cells = 16;
  double grading = 1;                                ///< of the cube's cells: see fem::grade_cube()
  std::filesystem::path mesh;                        ///< in place of the cube
  int refinements = 0;                               ///< of that mesh
  NodeOrder order = NodeOrder::mesh;                 ///< of that mesh
  std::filesystem::path case_file;                   ///< in place of plates and compressions
  Case given_case;                                   ///< what that file says
  double plate_tolerance = default_plate_tolerance;  ///< in mean edge lengths of that mesh
  VolumeTreatment volume = VolumeTreatment::patches;
  TopPlate top = TopPlate::bonded;
  Plates plates = Plates::held;
  std::vector<double> compressions{0.05, 0.125, 0.1825};  ///< plate travel over height, ascending
  fem::SolverSettings solver;
  bool historical = false;    ///< whether the tolerance is an absolute force, which the height of the body decides
  std::filesystem::path out;  ///< empty: nothing is written
  Output output = Output::body;
  std::size_t window = window_bytes;  ///< of states that are printed and written; smaller in tests
  std::filesystem::path beads;
  bool restart = false, dry_run = false, set_up_only = false, timings = false, quiet = false;
  int repetitions = 0;             ///< of all solves, for their time
  int threads = 0;                 ///< of the CPU, see physgen::set_threads()
  int replicate = 0;               ///< of several ranks: the most nodes of a coarser mesh that is not cut; 0: by itself
  std::vector<std::string> notes;  ///< what a user should know of what was chosen
  std::string help;                ///< what to print where help was asked for

  [[nodiscard]] bool is_cube() const { return mesh.empty(); }
  /// A quiet run measures no copy: its peak of memory is that of what it makes.
  [[nodiscard]] bool prints_timings() const { return (timings || set_up_only) && !quiet; }
  [[nodiscard]] bool is_case() const { return !case_file.empty(); }
  [[nodiscard]] bool moves() const {
    return scene == SceneKind::implicit_dynamics || scene == SceneKind::explicit_dynamics;
  }
};

}  // namespace physgen::truthcube
