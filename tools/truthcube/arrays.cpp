#include "arrays.h"

namespace physgen::truthcube {

namespace {

/// Whether the scene implicit_dynamics has what is asked for. A mesh of one's own may need a background grid.
bool has_implicit_dynamics(const Options& options) {
  const fem::SolverSettings& settings = options.solver;
  return settings.material == "stable-neo-hookean" && settings.precision == fem::TangentPrecision::float32 &&
         !fem::asks_for(settings.newton.preconditioner.kind, fem::asks::arrays) &&
         options.volume != VolumeTreatment::nodes && options.plates == Plates::held && options.is_cube();
}

}  // namespace

std::string arrays_of(const Options& options) {
  switch (options.scene) {
    case SceneKind::quasistatic:
      return "quasistatic";
    case SceneKind::matrix_free:
      return "quasistatic_matrix_free";
    case SceneKind::fixed_corotated:
      return "quasistatic_fixed_corotated";
    case SceneKind::explicit_dynamics:
      return "explicit_dynamics";
    case SceneKind::implicit_dynamics:
      if (has_implicit_dynamics(options)) return "implicit_dynamics";
      break;
    case SceneKind::linear_elastic:
      return options.solver.newton.product == fem::Product::assembled ? "linear_elastic_assembled" : "linear_elastic";
    case SceneKind::everything:
      break;
  }
  return "everything";
}

}  // namespace physgen::truthcube
