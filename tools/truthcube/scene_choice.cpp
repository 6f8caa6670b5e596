#include "scene_choice.h"

#include <physgen/error.h>

#include <cmath>
#include <initializer_list>

#include "arrays.h"
#include "names.h"

namespace physgen::truthcube {

#define PHYSGEN_SCENE_NAME(scene, word, ...) {word, SceneKind::scene},
const Names<SceneKind> scene_kinds{{"everything", SceneKind::everything},
                                   PHYSGEN_EQUILIBRIUM_SCENES(PHYSGEN_SCENE_NAME)  //
                                   PHYSGEN_IMPLICIT_SCENES(PHYSGEN_SCENE_NAME)     //
                                   {"explicit-dynamics", SceneKind::explicit_dynamics},
                                   {"linear-elastic", SceneKind::linear_elastic}};
#undef PHYSGEN_SCENE_NAME

namespace {

using Given = std::function<bool(const std::string&)>;

std::string scene_name(const Options& options) { return "--scene " + name_of(scene_kinds, options.scene); }

/// @throw Error when a flag is given for which the scene has no use
void refuse(const Options& options, const Given& given, std::initializer_list<const char*> flags,
            const std::string& reason) {
  for (const char* flag : flags) {
    if (given(flag))
      throw Error(scene_name(options) + " cannot take " + flag + ", because " + reason + "; remove " + flag);
  }
}

/// Sets what the scene requires. @throw Error when a flag chooses otherwise
template <class Value>
void choose(const Options& options, const Given& given, const char* flag, const std::string& word, Value& value,
            const Value& chosen) {
  if (given(flag) && value != chosen) {
    throw Error(scene_name(options) + " requires " + flag + " " + word + "; remove " + flag +
                ", or take another scene");
  }
  value = chosen;
}

/// The choices of scenes that average no volumes.
void choose_tets(Options& options, const Given& given, const std::string& who) {
  const bool is_given = given("--volume");
  choose(options, given, "--volume", "tets", options.volume, VolumeTreatment::tets);
  if (is_given) return;
  options.notes.push_back(
      who + " the change of volume tet by tet (--volume tets), which locks near a Poisson's ratio of 0.5");
}

/// The choices of scenes whose solver is compiled for them alone.
void choose_declared(Options& options, const Given& given, const fem::SceneRow& row) {
  refuse(options, given, {"--historical"}, "only --scene everything has it");
  choose(options, given, "--material", row.material, options.solver.material, std::string(row.material));
  choose(options, given, "--precision", "float", options.solver.precision, fem::TangentPrecision::float32);
  choose(options, given, "--plates", "held", options.plates, Plates::held);
  fem::NewtonSettings& newton = options.solver.newton;
  choose(options, given, "--product", row.assembled ? "assembled" : "matrix-free", newton.product,
         row.assembled ? fem::Product::assembled : fem::Product::matrix_free);
  if (const auto kind = newton.preconditioner.kind; fem::asks_for(kind, fem::asks::arrays)) {
    throw Error(scene_name(options) + " cannot take --preconditioner " + fem::row_of(kind).name +
                ", because only --scene everything has it; take another preconditioner");
  }
  if (!row.tets) choose(options, given, "--volume", "patches", options.volume, VolumeTreatment::patches);
  if (options.volume == VolumeTreatment::nodes && row.patches) {
    throw Error(scene_name(options) + " requires --volume patches or tets; remove --volume, or take another scene");
  }
  if (!row.patches) choose_tets(options, given, std::string(row.bodies) + " bodies take");
  if (!row.assembled && !given("--preconditioner")) newton.preconditioner.kind = fem::Preconditioner::block_jacobi;
}

void apply_motion(Options& options, const Given& given) {
  refuse(options, given, {"--restart", "--beads", "--repeat"}, "it is for equilibria, and a motion begins at rest");
  refuse(options, given, {"--stepping", "--historical"}, "it steps in time");
  if (!given("--compress")) options.compressions = {options.compressions.back()};
  if (options.compressions.size() != 1) {
    throw Error(scene_name(options) + " moves the plate to one compression, and --compress has " +
                std::to_string(options.compressions.size()) + "; give one");
  }
}

}  // namespace

void apply_scene(Options& options, const Given& given) {
  fem::NewtonSettings& newton = options.solver.newton;
  if (const fem::SceneRow* row = equilibrium_row(options.scene)) choose_declared(options, given, *row);
  switch (options.scene) {
    case SceneKind::implicit_dynamics:
      apply_motion(options, given);
      choose(options, given, "--product", "assembled", newton.product, fem::Product::assembled);
      options.solver.nested = false;
      if (!given("--material")) options.solver.material = "stable-neo-hookean";
      if (!given("--precision")) options.solver.precision = fem::TangentPrecision::float32;
      if (arrays_of(options) == "everything") {
        options.notes.push_back(
            "this motion uses the arrays of the scene everything, because those of implicit-dynamics are only for the "
            "cube, of stable-neo-hookean material, in float, without --volume nodes and --plates contact, and with "
            "--preconditioner " +
            fem::preconditioners_without(fem::asks::arrays));
      }
      break;
    case SceneKind::explicit_dynamics:
      apply_motion(options, given);
      refuse(options, given, {"--product", "--preconditioner", "--tolerance"}, "explicit steps solve no equations");
      choose(options, given, "--plates", "held", options.plates, Plates::held);
      choose_tets(options, given, "explicit steps take");
      if (options.motion.fixed_order && options.solver.device != fem::Device::cuda) {
        throw Error(scene_name(options) + " takes --fixed-order only with --device cuda: on the CPU the order of " +
                    "sums is always fixed; remove --fixed-order");
      }
      newton.preconditioner.kind = fem::Preconditioner::none;
      options.solver.nested = false;
      break;
    case SceneKind::linear_elastic:
      refuse(options, given, {"--material"}, "it uses linear elasticity, which has only --young and --poisson");
      refuse(options, given, {"--stepping", "--historical"}, "one linear solve finds each equilibrium");
      choose(options, given, "--plates", "held", options.plates, Plates::held);
      choose_tets(options, given, "linear elasticity takes");
      options.solver.nested = false;
      break;
    default:
      break;
  }
  if (options.scene != SceneKind::explicit_dynamics) {
    refuse(options, given, {"--fixed-order"}, "only --scene explicit-dynamics on CUDA uses it");
  }
  if (!options.moves()) {
    refuse(options, given, {"--time-step", "--duration", "--density", "--damping", "--frames"},
           "only --scene implicit-dynamics and explicit-dynamics use it");
  }
}

void check_motion(const MotionOptions& motion) {
  const auto require_positive = [](const char* flag, double value, const char* what) {
    if (value > 0 && std::isfinite(value)) return;
    throw Error(std::string(flag) + " " + number(value) + ": " + what + " must be a positive number");
  };
  require_positive("--duration", motion.duration, "the time of the motion, in seconds,");
  require_positive("--density", motion.density, "the density, in kg/m^3,");
  if (motion.time_step != 0) require_positive("--time-step", motion.time_step, "the time step, in seconds,");
  if (!(motion.damping >= 0) || !std::isfinite(motion.damping)) {
    throw Error("--damping " + number(motion.damping) + ": the damping, in 1/s, must be 0 or a positive number");
  }
}

}  // namespace physgen::truthcube
