#include "arrays.h"

namespace physgen::truthcube {

std::string arrays_of(SceneKind scene, const fem::SolverSettings& settings) {
  const fem::NewtonSettings& newton = settings.newton;
  switch (scene) {
    case SceneKind::quasistatic:
      return "quasistatic";
    case SceneKind::matrix_free:
      return "quasistatic_matrix_free";
    case SceneKind::fixed_corotated:
      return "quasistatic_fixed_corotated";
    case SceneKind::explicit_dynamics:
      return "explicit_dynamics";
    case SceneKind::linear_elastic:
      if (settings.precision == fem::TangentPrecision::float32 && newton.product == fem::Product::matrix_free) {
        return "linear_elastic";
      }
      break;
    case SceneKind::everything:
    case SceneKind::implicit_dynamics:
      break;
  }
  return "everything";
}

}  // namespace physgen::truthcube
